"""What an SSP has that is not supported, or wrong, is one error that says what and where."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.system.file.reader import load_system
from ssp_files import (
    CHAIN,
    GAINS,
    Read,
    bindings,
    component,
    connection,
    document,
    inline,
    real,
    system,
)

BOOLEAN = "<ssc:BooleanMappingTransformation><ssc:MapEntry source='true' target='false'/>"
BOOLEAN += "</ssc:BooleanMappingTransformation>"
WRONG = {
    "signal dictionary that is not declared": (
        system('<ssd:SignalDictionaryReference name="bus" dictionary="d"/>'),
        r"there is no signal dictionary 'd'.*line",
    ),
    "boolean mapping": (
        system(GAINS, connection("a.y", "b.u", BOOLEAN)),
        r"a connection that makes false of true is not supported; let a component do it",
    ),
    "a component of another kind": (
        system(component("a", "gain", type="text/x-modelica")),
        r"component 'a' is of type text/x-modelica; FMUs, SSDs and SSPs can be run",
    ),
    "no source": (system('<ssd:Component name="a" source=""/>'), r"component 'a' has no source: nobody has built it"),
    "model exchange of FMI": (
        system(component("a", "gain", implementation="Sorcery")), r"Sorcery is not supported; CoSimulation is needed"
    ),
    "NUL in a source": (system('<ssd:Component name="a" source="a%00.fmu"/>'), r"source 'a%00.fmu' is no file"),
    "a source that is no address": (
        system('<ssd:Component name="a" source="http://[x"/>'), r"is no address of a file"
    ),
    "a source of too many letters": (system(component("a", "x" * 5000)), r"there is no file 'resources/xxx"),
    "remote FMU": (
        system('<ssd:Component name="a" source="https://example.org/a.fmu"/>'),
        r"component 'a': source 'https://example.org/a.fmu' is not inside the SSP; nothing is fetched",
    ),
    "FMU outside": (
        system('<ssd:Component name="a" source="../../secret.fmu"/>'), r"'../../secret.fmu' leaves the folder"
    ),
    "missing FMU": (system(component("a", "lost")), r"no file 'resources/lost.fmu' in case.ssp"),
    "fragment": (system('<ssd:Component name="a" source="#other"/>'), r"the file has no system with id 'other'"),
    "unknown connector": (system(GAINS, connection("a.z", "b.u")), r"'a' has no connector 'z'"),
    "unknown element": (system(GAINS, connection("c.y", "b.u")), r"there is no element 'c'"),
    "output to output": (system(GAINS, connection("a.y", "b.y")), r"output and output cannot be connected here"),
    "driven twice": (
        system(GAINS, connection("a.y", "b.u") + connection("b.y", "b.u")), r"the second connection to the same"
    ),
    "units that do not fit": (
        system(component("a", "gain", bindings(inline(real("offset", "1", "m"))))), r"offset.*units do not fit: m"
    ),
    "value out of range": (
        system(component("a", "gain", bindings(inline(real("k", "1e9"))))),
        r"a\.k = 1e\+09 is out of range.*",
    ),
    "other parameter source": (
        system(component("a", "gain", bindings('<ssd:ParameterBinding type="text/csv" source="a.csv"/>'))),
        r"a parameter source of type text/csv is not supported",
    ),
    "no component": (system(system("", name="a") + system("", name="b")), r"holds no component at all, only systems"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_not_supported_or_wrong_is_one_error_that_says_what_and_where(case: str, read: Read) -> None:
    top, message = WRONG[case]
    with pytest.raises(InputError, match=message) as raised:
        read(document(top))
    assert "case.ssp" in str(raised.value)


def test_ssp_2_elements_that_are_not_supported_are_errors_too(read: Read) -> None:
    wire = connection("a.y", "b.u", more='startIndices="1"')
    with pytest.raises(InputError, match=r"<Connection>: the attribute startIndices is not supported .*line"):
        read(document(system(GAINS, wire), version="2.0"))
    with pytest.raises(InputError, match=r"<Sorcery> in <System> is not supported"):
        read(document(system(GAINS, tail="<ssd:Sorcery/>"), version="2.0"))


LINEAR = system(GAINS, connection("a.y", "b.u", '<ssc:LinearTransformation factor="2"/>'))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('factor="2"', 'factor="two"', r"<LinearTransformation>: factor = 'two' is no finite number .*line"),
        ('factor="2"', 'factor="NaN"', r"<LinearTransformation>: factor = 'NaN' is no finite number"),
        (' startConnector="y"', "", r"<Connection>: the attribute startConnector is missing"),
        (' startConnector="y"', ' startConnector=""', r"<Connection>: the attribute startConnector is empty .*line"),
        ("ssd:System ", 'ssd:System xmlns:ssd="urn:other" ', r"has no <System> of the namespace of SSP"),
        ('stopTime="0.1"', 'stopTime="later"', r"stopTime = 'later' is no finite number"),
        ('name="a" source', "source", r"<Component>: the attribute name is missing"),
    ],
)
def test_what_no_schema_checks_in_ssp_2_is_checked_all_the_same(old: str, new: str, message: str, read: Read) -> None:
    text = document(LINEAR, version="2.0")
    assert old in text
    with pytest.raises(InputError, match=message):
        read(text.replace(old, new))


def test_a_unit_whose_base_is_of_another_namespace_is_an_error(read: Read) -> None:
    units = '<ssc:Unit name="own"><o:BaseUnit xmlns:o="urn:other" kg="1"/></ssc:Unit>'
    with pytest.raises(InputError, match=r"<Unit> has no <BaseUnit> of the namespace of SSP .*line"):
        read(document(LINEAR, units, version="2.0"))


def test_a_description_without_a_system_is_an_error(read: Read) -> None:
    with pytest.raises(InputError, match=r"<SystemStructureDescription> has no <System>"):
        read(document("", version="2.0"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<ssd:System", r"SystemStructure\.ssd is not well-formed"),
        (
            document(CHAIN).replace("<ssd:System ", "<ssd:Sistem ").replace("</ssd:System>", "</ssd:Sistem>"),
            "has no <System>",
        ),
        (document(CHAIN, version="3.0"), r"SSP version 3\.0 is not known; 1\.0 and 2\.0 are"),
        (document(CHAIN, experiment='startTime="6" stopTime="5"'), r"the stop at 5 s is not after the start at 6 s"),
        (
            document(CHAIN).replace("?>\n", '?>\n<!DOCTYPE x [<!ENTITY e SYSTEM "file:///etc/passwd">]>'),
            r"document type declaration, which can open and expand anything; remove it",
        ),
    ],
)
def test_a_structure_description_that_is_no_ssp_is_refused(text: str, message: str, read: Read) -> None:
    with pytest.raises(InputError, match=message):
        read(text)


def test_an_archive_without_a_structure_or_with_an_unsafe_entry_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "case.ssp"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("readme.txt", "")
    with pytest.raises(InputError, match=r"case\.ssp has no SystemStructure\.ssd"):
        load_system(str(path))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("../outside", "")
    with pytest.raises(FmuError, match=r"SSP .*entry '\.\./outside' would leave the unpack folder"):
        load_system(str(path))
    path.write_bytes(b"no zip")
    with pytest.raises(FmuError, match=r"SSP .* is not a readable zip archive"):
        load_system(str(path))
