"""Every way to break the standard that a run can do without: it runs, a note names it, --strict makes it an error."""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import fmpy
import pytest
from helpers import edited, last, read_system, rovbrush, system_text
from native_build import FREE2, FREE3, built, feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.note_rows import note_rows
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.tolerant import rules
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import strictly

pytestmark = needs_gcc
SUFFIX = fmpy.sharedLibraryExtension
FOLDER2, FOLDER3 = f"binaries/{fmpy.platform}", f"binaries/{fmpy.platform_tuple}"
LIBRARY2, LIBRARY3 = f"{FOLDER2}/feedthrough2{SUFFIX}", f"{FOLDER3}/feedthrough3{SUFFIX}"
GUID, VARIABLES, OUT = 'guid="feedthrough2"', "<ModelVariables>", '<Unknown index="2" dependencies="1"/>'
COMPLEX = '<ScalarVariable name="c" valueReference="7"><Complex/></ScalarVariable>'
U = 'name="u" valueReference="0" causality="input" variability="continuous"><Real start="0"/>'
Y = 'name="y" valueReference="1" causality="output" variability="continuous"><Real /></ScalarVariable>'
N = 'name="n_in" valueReference="0" causality="input" variability="discrete"><Integer start="0"/>'
FAULT = 'causality="parameter" variability="fixed"><Integer start="0" min="0" max="9"/>'
AT = 'causality="parameter" variability="fixed"><Real start="1e9"/>'
MODE = 'causality="input" variability="discrete"><Enumeration declaredType="Mode" start="1"/>'
ON = 'causality="input" variability="discrete"><Boolean start="false"/>'
HEAD = '<?xml version="1.0" encoding="UTF-8"?>'
NEXT = "</ScalarVariable>\n</ModelVariables>"
LAST = '<ScalarVariable name="more" valueReference="2" causality="local"><Real {}/></ScalarVariable>\n</ModelVariables>'
UNITS = "<UnitDefinitions>{}</UnitDefinitions>\n<TypeDefinitions>"
TYPES = "<TypeDefinitions>"


def more(inner: str) -> dict[str, str]:
    """One more variable, a Real with these attributes."""
    return {"</ModelVariables>": LAST.format(inner)}


# rule, what is replaced in the description of feedthrough2.fmu, words of the note
DESCRIPTIONS: list[tuple[rules.Rule, Mapping[str, str], str]] = [
    (rules.BEFORE, {HEAD: f"\n {HEAD}"}, "modelDescription.xml"),
    (rules.PREFIX, {NEXT: "<Annotations><Tool name='t'><osp:x/></Tool></Annotations>" + NEXT}, "osp:"),
    (rules.PREFIX, {VARIABLES: '<VendorAnnotations><Tool name="t"><osp:x osp:y="1"/></Tool></VendorAnnotations>'
                    + VARIABLES}, "osp:"),
    (rules.VERSION, {'fmiVersion="2.0"': 'fmiVersion="2.0.4"'}, "'2.0.4', taken for 2.0"),
    (rules.MISSING, {'guid="feedthrough2"': ""}, "guid"),
    (rules.MISSING, {'modelName="feedthrough2"': ""}, "modelName"),
    (rules.BOOLEAN, {'canGetAndSetFMUstate="true"': 'canGetAndSetFMUstate="True"'}, "canGetAndSetFMUstate='True'"),
    (rules.BOOLEAN, {ON: ON.replace("false", "False")}, "start='False' of on_in"),
    (rules.NUMBER, {GUID: GUID + ' numberOfEventIndicators=""'}, "numberOfEventIndicators=''"),
    (rules.NUMBER, {VARIABLES: '<DefaultExperiment startTime="" stopTime="1 s" stepSize="0,01"/>' + VARIABLES},
     "stopTime='1 s' of DefaultExperiment"),
    (rules.NUMBER, {"<CoSimulation": '<CoSimulation maxOutputDerivativeOrder="no"'}, "maxOutputDerivativeOrder='no'"),
    (rules.NUMBER, {U: U.replace("start", 'min="low" nominal="" start')}, "nominal='' of u (line 6), min='low'"),
    (rules.NUMBER, {N: N.replace('"0"/>', '"0.0" min="-50.0"/>')}, "min='-50.0' of n_in"),
    (rules.NUMBER, {U: U.replace('start="0"', 'start="zero"')}, "start='zero' of u"),
    (rules.NUMBER, {TYPES: UNITS.format('<Unit name="m"><BaseUnit m="one"/></Unit>')}, "m='one' of m"),
    (rules.NUMBER, {TYPES: UNITS.format('<Unit name="m"><BaseUnit m="1" factor="0"/></Unit>')}, "factor='0' of m"),
    (rules.UNKNOWN, {TYPES: TYPES + '<SimpleType name="T"><Real color="red"/></SimpleType>'}, "color of T"),
    (rules.UNKNOWN, {'<Item name="off" ': '<Item name="off" color="red" '}, "color of Mode"),
    (rules.NAMELESS, {TYPES: TYPES + '<SimpleType name="T"/><SimpleType><Real/></SimpleType>'}, "T (line 4), Simp"),
    (rules.NAMELESS, {TYPES: UNITS.format("<Unit/>")}, "Unit"),
    (rules.SCHEMA, {'guid="feedthrough2"': 'guid="feedthrough2" newerAttribute="1"'}, "newerAttribute"),
    (rules.SCHEMA, {"<ModelVariables>": "<Clocks/><ModelVariables>"}, "Clocks"),
    (rules.UNUSABLE, {"<ScalarVariable " + U: COMPLEX + "<ScalarVariable " + U,
                      'index="2" dependencies="1"': 'index="3" dependencies="2"'}, "c (line 6)"),
    (rules.UNUSABLE, {Y: Y + '<ScalarVariable name="z" valueReference="-1"><Real/></ScalarVariable>'}, "z (line 7)"),
    (rules.NAME_TWICE, {"</ModelVariables>": LAST.format("").replace("more", "y")}, "y (line 19)"),
    (rules.TYPE, {U: U.replace("start", 'declaredType="Nowhere" start')}, "'Nowhere' of u"),
    (rules.WORD, {U: U.replace("continuous", "steady")}, "variability='steady' of u"),
    (rules.WORD, {"</ModelVariables>": LAST.format("").replace("local", "none")}, "causality='none' of more"),
    (rules.CONTINUOUS, {MODE: MODE.replace("discrete", "continuous")}, "mode_in"),
    (rules.CONTINUOUS, {MODE: MODE.replace('variability="discrete"', "")}, "mode_in"),
    (rules.CONTINUOUS, {ON: ON.replace('variability="discrete"', "")}, "on_in"),
    (rules.COMBINATION, {FAULT: FAULT.replace('variability="fixed"', "")}, "parameter and continuous of fault"),
    (rules.COMBINATION, {U: U.replace("continuous", "constant")}, "input and constant of u"),
    (rules.COMBINATION, {U: U.replace('"continuous"', '"continuous" initial="approx"')}, "initial='approx' of u"),
    (rules.START_MISSING, {N: N.replace(' start="0"', "")}, "n_in"),
    (rules.START_MISSING, {AT: AT.replace(' start="1e9"', "")}, "bad_at"),
    (rules.START_SURPLUS, {Y: Y.replace("<Real ", '<Real start="3" ')}, "y (line 7)"),
    (rules.START_OUTSIDE, {U: U.replace("start", 'min="1" start')}, "u (line 6)"),
    (rules.RANGE, {U: U.replace("start", 'min="3" max="1" start')}, "u (line 6)"),
    (rules.UNIT, {U: U.replace("start", 'unit="blorp" start')}, "blorp"),
    (rules.DISPLAY_UNIT, {U: U.replace("start", 'unit="m" displayUnit="yd" start'),
                          TYPES: UNITS.format('<Unit name="m"/>')}, "yd"),
    (rules.NOWHERE, {"<InitialUnknowns>": '<InitialUnknowns><Unknown index="99"/><Unknown index="-1"/>'}, "index='99'"),
    (rules.NOWHERE, {'index="2" dependencies="1"': 'index="2" dependencies="1 77"'}, "dependencies='1 77'"),
    (rules.NOWHERE, more('derivative="50"'), "derivative of more"),
    (rules.KINDS, {'index="2" dependencies="1"': 'index="2" dependencies="1" dependenciesKind="dependent dependent"'},
     "ModelStructure"),
    (rules.OUTPUTS, {OUT: ""}, "y (line 7)"),
    (rules.OUTPUTS, {OUT: OUT + '<Unknown index="1"/>'}, "u (line 6)"),
]  # fmt: skip


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def runs_noted_and_strict(fmu: Path, rule: rules.Rule, words: str, values: Mapping[str, Any], output: str) -> None:
    """It runs rightly, a note names what is wrong and where, `check` finds it, and --strict is an error."""
    parts = {"a": (str(fmu), "1 ms", values)}
    system = read_system(fmu.parent, fmu.parent, parts, stop="10 ms")
    component = system.components["a"].fmu
    noted = {note.rule: note for note in component.notes}
    assert rule in noted, [note.found for note in component.notes]
    assert words in ", ".join(noted[rule].places), noted[rule].places
    run = simulate(make_plan(system))
    assert not run.failure, run.failure
    assert last(run, f"a.{output}") == pytest.approx(0.015, rel=1e-12)
    row = next(row for row in note_rows(open_subject(fmu)) if row.rule == rule.found)
    assert row.verdict == "finding" and row.mend == rule.mend and rule.taken in row.found
    with pytest.raises(FmuError) as error:
        strictly(system)
    assert str(fmu) in str(error.value) and rule.found in str(error.value) and rule.mend in str(error.value)


@pytest.mark.parametrize(("rule", "replacements", "words"), DESCRIPTIONS)
def test_a_description_that_breaks_the_standard_runs_with_a_note(
    rule: rules.Rule, replacements: Mapping[str, str], words: str, native: Path, tmp_path: Path
) -> None:
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {}, replacements)
    runs_noted_and_strict(fmu, rule, words, FREE2, "x")


TIME = '<Float64 name="time" valueReference="999" causality="independent"></Float64>'
IN, INT, A = 'name="Float64_in" valueReference="0"', '<Int8 name="Int8_in"', '<Float64 name="a_in" valueReference="100"'
STARTS = 'start="1 2 3 4 5 6 7 8"'
# the same of feedthrough3.fmu
DESCRIPTIONS3: list[tuple[rules.Rule, Mapping[str, str], str]] = [
    (rules.VERSION, {'fmiVersion="3.0"': 'fmiVersion="3.0-beta.2"'}, "'3.0-beta.2', taken for 3.0"),
    (rules.MISSING, {'instantiationToken="{t}"': ""}, "instantiationToken"),
    (rules.BOOLEAN, {'canGetAndSetFMUState="true"': 'canGetAndSetFMUState="TRUE"'}, "canGetAndSetFMUState='TRUE'"),
    (rules.NUMBER, {"<CoSimulation": '<CoSimulation fixedInternalStepSize=""'}, "fixedInternalStepSize=''"),
    (rules.NUMBER, {STARTS: 'start="1 2 3 4 5 6 7 eight"'}, "start='1 2 3 4 5 6 7 eight' of a_in"),
    (rules.STARTS, {STARTS: 'start="1 2 3"'}, "3 for 8 of a_in"),
    (rules.UNUSABLE, {"</ModelVariables>": '<Quaternion name="q" valueReference="300"/></ModelVariables>'}, "q (line"),
    (rules.UNUSABLE, {"</ModelVariables>": '<Float64 name="b" valueReference="301"><Dimension valueReference="9999"/>'
                      "</Float64></ModelVariables>"}, "b (line"),
    (rules.NAME_TWICE, {"</ModelVariables>": '<Float64 name="b" valueReference="301"><Alias name="a_in"/></Float64>'
                        "</ModelVariables>"}, "a_in (line"),
    (rules.REFERENCE_TWICE, {"</ModelVariables>": '<Float64 name="b" valueReference="107"/></ModelVariables>'}, "b ("),
    (rules.INDEPENDENT, {TIME: ""}, "0"),
    (rules.CONTINUOUS, {INT: INT + ' variability="continuous"'}, "Int8_in"),
    (rules.NOWHERE, {IN: IN + ' clocks="77 78"'}, "clocks of Float64_in"),
    (rules.NOWHERE, {IN: IN + ' derivative="77"'}, "derivative of Float64_in"),
    (rules.NOWHERE, {'<Output valueReference="1" dependencies="0"': '<Output valueReference="1" dependencies="0 77"'},
     "dependencies='0 77'"),
    (rules.OUTPUTS, {'<Output valueReference="1" dependencies="0"/>': ""}, "Float64_out"),
    (rules.TYPE, {IN: IN + ' declaredType="Nowhere"'}, "'Nowhere' of Float64_in"),
]  # fmt: skip


@pytest.mark.parametrize(("rule", "replacements", "words"), DESCRIPTIONS3)
def test_so_does_one_of_fmi_3(
    rule: rules.Rule, replacements: Mapping[str, str], words: str, native: Path, tmp_path: Path
) -> None:
    fmu = edited(native / "feedthrough3.fmu", tmp_path / "feedthrough3.fmu", {}, replacements)
    runs_noted_and_strict(fmu, rule, words, {**FREE3, "=Float64_in": 0.015}, "Float64_out")


BUILD = b'<fmiBuildDescription fmiVersion="2.9"/>'
ARCHIVES: dict[str, tuple[rules.Rule, dict[str, bytes | None], str, int]] = {
    "windows paths": (rules.BACKSLASH, {"resources\\table.csv": b"1", "resources\\": b""}, "resources\\table.csv", 2),
    "another name": (rules.LIBRARY, {LIBRARY2: None, f"{FOLDER2}/model{SUFFIX}": b""}, f"model{SUFFIX}", 2),
    "another case": (rules.LIBRARY, {LIBRARY2: None, f"{FOLDER2}/FeedThrough2{SUFFIX}": b"",
                                     f"{FOLDER2}/helper{SUFFIX}": b"x"}, f"FeedThrough2{SUFFIX}", 2),
    "folder of FMI 3": (rules.PLATFORM, {LIBRARY2: None, f"{FOLDER3}/feedthrough2{SUFFIX}": b""},
                        str(fmpy.platform_tuple), 2),
    "folder of FMI 2": (rules.PLATFORM, {LIBRARY3: None, f"{FOLDER2}/feedthrough3{SUFFIX}": b""},
                        str(fmpy.platform), 3),
    "another build": (rules.BUILD, {"sources/buildDescription.xml": BUILD}, "2.9", 3),
}  # fmt: skip


@pytest.mark.parametrize("case", ARCHIVES)
def test_an_archive_that_breaks_the_standard_runs_with_a_note(case: str, native: Path, tmp_path: Path) -> None:
    rule, changes, words, version = ARCHIVES[case]
    source = native / f"feedthrough{version}.fmu"
    with zipfile.ZipFile(source) as archive:
        library = archive.read(LIBRARY2 if version == 2 else LIBRARY3)
    filled = {
        name: library if content == b"" and name.endswith(SUFFIX) else content for name, content in changes.items()
    }
    fmu = edited(source, tmp_path / source.name, filled)
    if version == 2:
        runs_noted_and_strict(fmu, rule, words, FREE2, "x")
    else:
        runs_noted_and_strict(fmu, rule, words, {**FREE3, "=Float64_in": 0.015}, "Float64_out")


def test_an_entry_that_is_there_twice_with_the_same_content_is_one(native: Path, tmp_path: Path) -> None:
    fmu = shutil.copy(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu")
    with zipfile.ZipFile(fmu, "a") as archive, pytest.warns(UserWarning, match="Duplicate name"):
        archive.writestr("modelDescription.xml", archive.read("modelDescription.xml"))
    runs_noted_and_strict(fmu, rules.TWICE, "modelDescription.xml", FREE2, "x")


@pytest.mark.parametrize("declared", ["UTF-8", "martian"])
def test_bytes_of_another_encoding_than_the_declared_are_read(declared: str, native: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(native / "feedthrough2.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    text = text.replace("UTF-8", declared).replace('guid="', 'author="M\u00fcller" guid="')
    fmu = edited(
        native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {"modelDescription.xml": text.encode("latin-1")}
    )
    runs_noted_and_strict(fmu, rules.ENCODING, declared, FREE2, "x")
    assert Fmu.open(fmu).description.author == "M\u00fcller"


@pytest.mark.parametrize(
    ("encoding", "mark"), [("ISO-8859-1", b""), ("UTF-8", b"\xef\xbb\xbf"), ("utf8", b""), ("UTF-16", b"")]
)
def test_every_encoding_that_is_declared_is_read_without_a_word(
    encoding: str, mark: bytes, native: Path, tmp_path: Path
) -> None:
    with zipfile.ZipFile(native / "feedthrough2.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    text = text.replace("UTF-8", encoding).replace('guid="', 'author="M\u00fcller" guid="')
    content = mark + text.encode(encoding)
    opened = Fmu.open(edited(native / "feedthrough2.fmu", tmp_path / "f.fmu", {"modelDescription.xml": content}))
    assert opened.description.author == "M\u00fcller" and not opened.notes


@pytest.mark.parametrize("dependencies", ["1\n   4", "1\t4", "  1 4  ", "1&#10;4"])
def test_a_list_may_be_broken_over_lines(dependencies: str, native: Path, tmp_path: Path) -> None:
    changes = {'index="2" dependencies="1"': f'index="2" dependencies="{dependencies}"'}
    opened = Fmu.open(edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {}, changes))
    assert opened.feedthrough()["y"] == {"u"} and not opened.notes  # the fourth is a parameter


def test_functions_that_a_library_lacks_fail_only_when_they_are_called(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    fmu = feedthrough2(tmp_path / "bare.fmu", BARE=1)
    (tmp_path / "case.toml").write_text(system_text({"a": ("./bare.fmu", "1 ms", FREE2)}, stop="10 ms"))
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "out") == 0
    said = " ".join(capfd.readouterr().out.split())
    assert rules.FUNCTIONS.found in said and "fmi2CancelStep" in said
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "strict", "--strict") == 1
    assert "fmi2CancelStep" in capfd.readouterr().err
    instance = load(Fmu.open(fmu), "a")
    instance.begin(1.0)
    instance.exit_initialization()
    with pytest.raises(FmuError, match=r"cannot save its state .its library has no function fmi2GetFMUstate"):
        instance.save()
    instance.close()


def test_run_counts_what_is_wrong_and_strict_refuses_it(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    changes = {'guid="feedthrough2"': "", U: U.replace("start", 'unit="blorp" start')}
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "their.fmu", {}, changes)
    (tmp_path / "case.toml").write_text(
        system_text({"a": ("their.fmu", "1 ms", FREE2), "b": ("their.fmu", "1 ms", FREE2)}, stop="10 ms")
    )
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "out") == 0
    said = " ".join(capfd.readouterr().out.split())
    assert said.count("their.fmu breaks the standard in 2 points that a run can do without: `rovbrush check") == 1
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "strict", "--strict") == 1
    assert "blorp" in capfd.readouterr().err and not (tmp_path / "strict").exists()
    assert rovbrush(monkeypatch, "check", fmu) == 0
    assert "blorp" in capfd.readouterr().out
    assert rovbrush(monkeypatch, "check", fmu, "--strict") == 1


def test_every_rule_is_tried() -> None:
    tried = [*(row[0] for row in (*DESCRIPTIONS, *DESCRIPTIONS3)), *(row[0] for row in ARCHIVES.values())]
    assert set(rules.RULES) - set(tried) == {rules.TWICE, rules.ENCODING, rules.FUNCTIONS}  # each has its own test


@pytest.mark.parametrize("name", ["feedthrough2.FMU", "unpacked", "sub/unpacked"])
def test_the_suffix_may_be_upper_case_and_the_archive_unpacked(name: str, native: Path, tmp_path: Path) -> None:
    target = tmp_path / name
    if name.endswith("FMU"):
        shutil.copy(native / "feedthrough2.fmu", target)
    else:
        fmpy.extract(str(native / "feedthrough2.fmu"), str(target))
    system = read_system(tmp_path, tmp_path / "fmus", {"a": (name, "1 ms", FREE2)}, stop="10 ms")
    run = simulate(make_plan(system))
    assert last(run, "a.x") == pytest.approx(0.015, rel=1e-12)
    fmu = system.components["a"].fmu
    assert not fmu.notes and Fmu.open(fmu.archive).folder == fmu.folder
    assert all(file.is_relative_to(target) or file.is_relative_to(fmu.folder) for file in [fmu.library])


def test_an_unpacked_folder_that_holds_a_link_is_refused(native: Path, tmp_path: Path) -> None:
    fmpy.extract(str(native / "feedthrough2.fmu"), str(tmp_path / "unpacked"))
    (tmp_path / "unpacked" / "link").symlink_to("/etc/passwd")
    with pytest.raises(FmuError, match="'link' is a link or a device; put the file there"):
        Fmu.open(tmp_path / "unpacked")


def test_of_several_libraries_the_one_to_take_must_be_named(native: Path, tmp_path: Path) -> None:
    changes: dict[str, bytes | None] = {LIBRARY2: None, f"{FOLDER2}/a{SUFFIX}": b"x"}
    changes[f"{FOLDER2}/b{SUFFIX}"] = b"x"
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "their.fmu", changes)
    with pytest.raises(FmuError, match=rf"of a{SUFFIX}, b{SUFFIX} in binaries/{fmpy.platform} call one feedthrough2"):
        Fmu.open(fmu)
