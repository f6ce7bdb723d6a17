"""What files of other tools hold beside the letter of SSP: a run does without it, and it is noted."""

from __future__ import annotations

import re
import zipfile
from fractions import Fraction
from pathlib import Path

import pytest
from helpers import last
from rovbrush.orchestrator.cli.console import print_notes
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.tolerant.rules import Rule
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import strictly
from rovbrush.orchestrator.system.experiment import whole_stop
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.files import rules
from ssp_files import CHAIN, GAINS, Read, component, connection, connectors, document, system, write_ssp_file

OMS = '<ssd:Annotations><ssc:Annotation type="org.openmodelica"><oms:Annotations xmlns:oms="urn:oms">' \
      "<oms:SimulationInformation><oms:{}/></oms:SimulationInformation></oms:Annotations></ssc:Annotation>" \
      "</ssd:Annotations>"  # fmt: skip
OSP = '<ssd:Annotations><ssc:Annotation type="com.opensimulationplatform">{}</ssc:Annotation></ssd:Annotations>'
HINT = OSP.format('<o:StepSizeHint xmlns:o="urn:o" value="0.02"/>')
WIRE = connection("a.y", "b.u")


def broken(found: System) -> set[Rule]:
    return {note.rule for note in found.breaches}


def wired(found: System) -> list[str]:
    return [connection.label for connection in found.connections]


def test_an_empty_element_of_a_connection_is_the_system_itself(read: Read) -> None:
    wire = connection("in", "b.u").replace("<ssd:Connection ", '<ssd:Connection startElement="" ')
    inner = system(component("b", "gain"), wire, head=connectors(**{"in": "input"}), name="inner")
    found = read(document(system(component("a", "gain") + inner, connection("a.y", "inner.in"))))
    assert wired(found) == ["a.y -> inner_b.u"] and not found.breaches


def test_systems_inside_systems_only_are_run_where_a_component_is_in_one(read: Read) -> None:
    top = system(system(system(GAINS, WIRE, name="core"), name="inner") + system("", name="empty"))
    found = read(document(top.replace("<ssd:Elements></ssd:Elements>", "")))
    assert wired(found) == ["inner_core_a.y -> inner_core_b.u"] and not found.breaches


@pytest.mark.parametrize(
    ("where", "hint", "period"),
    [
        ("system", OMS.format('FixedStepMaster stepSize="0.020000"'), "1/50"),
        ("system", OMS.format('VariableStepMaster initialStepSize="1e-6" maximumStepSize="0.02"'), "1/50"),
        ("system", OMS.format('FixedStepMaster stepSize="0"'), "1/1000"),  # none: that of the FMU
        ("experiment", OSP.format('<o:Algorithm xmlns:o="urn:o"><o:FixedStepAlgorithm baseStepSize="0.02"/></o:Algorithm>'), "1/50"),  # noqa: E501
        ("component", HINT, "1/50"),
        ("component", HINT.replace(' xmlns:o="urn:o"', ""), "1/50"),  # a prefix that nothing declares
    ],
)  # fmt: skip
def test_steps_of_other_tools_are_periods(where: str, hint: str, period: str, read: Read) -> None:
    places = {"system": "", "experiment": "", "component": ""} | {where: hint}
    top = system(component("a", "gain", places["component"]), tail=places["system"])
    text = document(top).replace('stopTime="0.1"/>', f'stopTime="0.1">{places["experiment"]}</ssd:DefaultExperiment>')
    assert read(text).components["a"].period == Fraction(period)
    assert read(text, step="5 ms").components["a"].period == Fraction(1, 200)


def test_the_innermost_system_says_the_step(read: Read) -> None:
    inner = system(component("b", "gain"), tail=OMS.format('FixedStepMaster stepSize="0.01"'), name="inner")
    top = system(component("a", "gain") + inner, tail=OMS.format('FixedStepMaster stepSize="0.02"'))
    found = read(document(top))
    assert [c.period for c in found.components.values()] == [Fraction(1, 50), Fraction(1, 100)]


def test_a_draft_says_the_step_in_its_own_element(read: Read) -> None:
    head = '<ssd:SimulationInformation><ssd:FixedStepMaster stepSize="0.02"/></ssd:SimulationInformation>'
    found = read(document(system(component("a", "gain"), head=head)))
    assert found.components["a"].period == Fraction(1, 50)


def test_a_stop_that_is_no_whole_number_of_fixed_steps_is_put_off_to_the_next_and_told(read: Read) -> None:
    found = read(document(CHAIN, experiment='stopTime="0.1005"'))
    assert found.stop == Fraction(201, 2000) and not found.remarks  # the last step is a shorter one
    remarks: list[str] = []
    assert whole_stop(Fraction(-1), found.stop, [Fraction(1, 1000)], remarks) == Fraction(101, 1000)
    assert remarks == ["100.5 ms is no whole number of steps: the run goes on to 101 ms"]


EARLY = OMS.format('FixedStepMaster stepSize="0.001"')  # before the elements, where the schema wants it behind
DRAFT = '<ssd:SimulationInformation><ssd:FixedStepMaster stepSize="0.001"/></ssd:SimulationInformation>'
TEXT = connectors(y="output").replace("></ssd:Connector>", "><ssc:String/></ssd:Connector>")
ODD = {
    "annotations first": (system(GAINS, WIRE, head=EARLY), {}, rules.SCHEMA),
    "empty lists": (
        system(component("a", "gain", "<ssd:Connectors/>") + component("b", "gain"), WIRE), {}, rules.SCHEMA
    ),
    "a vendor's element": (system(GAINS, WIRE, tail='<v:Look xmlns:v="urn:vendor"/>'), {}, rules.FOREIGN),
    "what a later version may add": (
        system(component("a", "gain", "<ssd:Looks/>") + component("b", "gain"), WIRE), {}, rules.FOREIGN
    ),
    "connector of nothing": (
        system(component("a", "gain", connectors(q="input")) + component("b", "gain"), WIRE), {}, rules.NO_VARIABLE
    ),
    "other kind": (
        system(component("a", "gain", connectors(y="local")) + component("b", "gain"), WIRE), {}, rules.OTHER_KIND
    ),
    "other type": (
        system(component("a", "gain", TEXT) + component("b", "gain"), WIRE), {}, rules.OTHER_TYPE,
    ),
    "other unit": (
        system(component("a", "gain", connectors(y="output|percent")) + component("b", "gain"), WIRE), {},
        rules.OTHER_UNIT,
    ),
    "unit of nothing": (
        system(component("a", "gain", connectors(y="output|furlogs")) + component("b", "gain"), WIRE), {},
        rules.UNDEFINED_UNIT,
    ),
    "twice": (system(GAINS, WIRE + WIRE), {}, rules.TWICE),
    "other case": (system(GAINS, WIRE), {"resources/gain.fmu": "Resources/Gain.fmu"}, rules.CASE),
    "backslash": (system(GAINS, WIRE), {"resources/gain.fmu": "resources\\gain.fmu"}, rules.BACKSLASH),
    "no namespaces": (
        system(GAINS, WIRE), {'<ssd:': "<", "</ssd:": "</", 'xmlns:ssd="[^"]*"': ""},
        rules.NAMESPACE,
    ),
    "namespaces of another place": (
        system(GAINS, WIRE), {"http://ssp-standard.org/SSP1": "file:///C:/Software/OSP/xsd"}, rules.NAMESPACE
    ),
    "no version": (system(GAINS, WIRE), {' version="1.0" name': " name"}, rules.VERSION),
    "a draft's version": (system(GAINS, WIRE), {' version="1.0" name': ' version="Draft20180219" name'}, rules.VERSION),
    "a draft's element": (system(GAINS, WIRE, head=DRAFT), {}, rules.FOREIGN),
}  # fmt: skip


@pytest.mark.parametrize("case", ODD)
def test_what_a_run_can_do_without_is_noted(case: str, read: Read) -> None:
    top, changes, rule = ODD[case]
    text = document(top)
    for old, new in changes.items():
        assert re.search(old, text)
        text = re.sub(old, new.replace("\\", r"\\"), text)
    found = read(text)
    assert rule in broken(found)
    assert [(c.source, c.target, c.gain, c.offset) for c in found.connections] == [(("a", "y"), ("b", "u"), 1.0, 0.0)]
    with pytest.raises(FmuError, match=re.escape(rule.found)):
        strictly(found)


def test_a_file_as_the_standard_wants_it_breaks_nothing(read: Read) -> None:
    for version in ("1.0", "2.0", "2.0-beta.2", "2.0.1"):
        found = read(document(CHAIN, version=version))
        assert (found.breaches, found.remarks) == ((), ()) and strictly(found).strict


def test_what_ssp_2_says_of_units_sizes_and_clocks_breaks_nothing(read: Read) -> None:
    stated = connectors(y="output").replace(
        "></ssd:Connector>", '><ssc:Float64 unit="1"/><ssc:Dimension size="1"/><ssd:Clock name="c"/></ssd:Connector>'
    )
    units = '<ssc:Unit name="1"><ssc:BaseUnit/><ssc:DisplayUnit name="percent" factor="100"/></ssc:Unit>'
    top = system(component("a", "gain", stated) + component("b", "gain"), WIRE)
    found = read(document(top, units, version="2.0"))
    assert not found.breaches and wired(found) == ["a.y -> b.u"]


def test_breaches_are_counted_by_run_and_listed_by_plan(read: Read, capsys: pytest.CaptureFixture[str]) -> None:
    found = read(document(ODD["connector of nothing"][0]))
    print_notes(found)
    assert "case.ssp breaks the standard in 1 point that a run can do without" in " ".join(
        capsys.readouterr().out.split()
    )
    assert "connectors for which the FMU has no variable: a.q (case.ssp/SystemStructure.ssd, line 2)" in explain(
        make_plan(found)
    )


@pytest.mark.parametrize("kind", ["inout", "unspecified", ""])
def test_a_connector_of_both_directions_takes_the_one_of_its_connections(kind: str, read: Read) -> None:
    head = connectors(bus="input").replace('kind="input"', f'kind="{kind}"')
    inner = system(GAINS, connection("a.y", "bus") + connection("bus", "b.u"), head=head, name="inner")
    outer = system(inner + component("c", "gain"), connection("inner.bus", "c.u"))
    assert sorted(wired(read(document(outer)))) == ["inner_a.y -> c.u", "inner_a.y -> inner_b.u"]


def test_components_whose_names_become_the_same_are_numbered(read: Read) -> None:
    top = system(
        component("a b", "gain") + component("a.b", "gain") + component("a_b", "gain"), connection("a.b.y", "a b.u")
    )
    assert wired(read(document(top))) == ["a_b_2.y -> a_b.u"]


@pytest.fixture
def package(tmp_path: Path, fmus: Path) -> Path:
    """A .ssp with two structures."""
    path = tmp_path / "case.ssp"
    other = document(system(component("only", "gain")))
    return write_ssp_file(
        path, fmus, document(CHAIN), ("gain",), {"Variant B.ssd": other, "notes.txt": "", "x.srmd": ""}
    )


def test_further_structures_are_told_and_run_by_their_names(package: Path) -> None:
    found = load_system(str(package))
    assert set(found.components) == {"a", "b"}
    assert found.remarks == ("case.ssp holds further structures, Variant B.ssd: run case.ssp#Variant B.ssd",)
    assert set(load_system(f"{package}#Variant B.ssd").components) == {"only"}
    with pytest.raises(InputError, match=r"case\.ssp has no structure 'VariantB\.ssd'; did you mean 'Variant B\.ssd'"):
        load_system(f"{package}#VariantB.ssd")


def test_the_folder_of_an_unpacked_ssp_and_unpacked_fmus_are_taken(package: Path, tmp_path: Path) -> None:
    folder = tmp_path / "case"
    with zipfile.ZipFile(package) as archive:
        archive.extractall(folder)
    fmu = folder / "resources" / "gain.fmu"
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(folder / "resources" / "gain")
    fmu.unlink()
    structure = folder / "SystemStructure.ssd"
    structure.write_text(structure.read_text().replace("resources/gain.fmu", "resources/gain"))
    found = load_system(str(folder))
    packed = load_system(str(package))
    assert [last(simulate(make_plan(s)), "b.y") for s in (found, packed)] == [
        last(simulate(make_plan(packed)), "b.y")
    ] * 2


@pytest.mark.parametrize("name", ["systemstructure.ssd", "plant.ssd", "case/SystemStructure.ssd"])
def test_a_package_whose_structure_is_called_otherwise_is_noted(name: str, tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "case.SSP"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(name, document(CHAIN))
        archive.write(
            fmus / "gain.fmu", name.rpartition("/")[0] + "/resources/gain.fmu" if "/" in name else "resources/gain.fmu"
        )
    found = load_system(str(path))
    assert wired(found) == ["a.y -> b.u"] and broken(found) == {rules.STRUCTURE}


def test_of_several_structures_and_no_default_the_error_says_how_to_choose(tmp_path: Path) -> None:
    path = tmp_path / "case.ssp"
    with zipfile.ZipFile(path, "w") as archive:
        for name in ("a.ssd", "b.ssd"):
            archive.writestr(name, document(CHAIN))
    with pytest.raises(InputError, match=r"of a\.ssd, b\.ssd, say which: case\.ssp#a\.ssd"):
        load_system(str(path))
