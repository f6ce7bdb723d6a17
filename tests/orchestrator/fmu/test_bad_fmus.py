"""One row per way in which an FMU can be wrong: each is one clear error."""

from __future__ import annotations

from pathlib import Path

import fmpy
import pytest
from helpers import column, edited, plan_of
from native_build import FAULTS2, FREE2, built, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.tolerant import xml
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
LIBRARY = f"binaries/{fmpy.platform}/feedthrough2{fmpy.sharedLibraryExtension}"
ENTITIES = '<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><fmiModelDescription fmiVersion="2.0"/>'
Edit = tuple[dict[str, bytes | None], dict[str, str]]


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (({"modelDescription.xml": None}, {}), "has no modelDescription.xml"),
        (({"modelDescription.xml": b"<fmi"}, {}), "not well-formed"),
        (({"modelDescription.xml": ENTITIES.encode()}, {}), "has a document type declaration, which can"),
        (({}, {'fmiVersion="2.0"': 'fmiVersion="1.0"'}), "is of FMI version 1.0 and written as a later one"),
        (({}, {'fmiVersion="2.0"': 'fmiVersion="2.1"'}), "is of FMI version 2.1; version 1.0, 2.0 or 3.0 is needed"),
        (({}, {'fmiVersion="2.0" ': ""}), "is of FMI version None"),
        (({}, {"<fmiModelDescription ": "<fmuModelDescription ", "</fmiModel": "</fmuModel"}), "it describes no FMU"),
        (({}, {"<CoSimulation": "<Cosimulation"}), "has no interface at all; export it for co-simulation"),
        (({LIBRARY: None, "binaries/darwin32/feedthrough2.dylib": b"x"}, {}),
         f"no binary for {fmpy.platform}; it has darwin32; ask for a binary"),
        (({LIBRARY: None, "sources/all.c": b"int x;"}, {}),
         "it has none; ask for a binary of this platform: its sources are"),
    ],
)  # fmt: skip
def test_what_cannot_be_opened_says_why(edit: Edit, words: str, native: Path, tmp_path: Path) -> None:
    path = tmp_path / "feedthrough2.fmu"
    source = native / "feedthrough2.fmu"
    changes, replacements = edit
    edited(source, path, changes, replacements)
    with pytest.raises(FmuError) as error:
        Fmu.open(path)
    assert str(path) in str(error.value) and words in str(error.value)


def test_a_huge_description_is_refused(native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xml, "LARGEST", 1000)
    path = edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {"extra.txt": b"another content"})
    with pytest.raises(
        FmuError, match=r"its modelDescription\.xml has more than 0 MB; export the model with fewer variables"
    ):
        Fmu.open(path)


def test_a_build_description_with_entities_is_refused(native: Path, tmp_path: Path) -> None:
    changes: dict[str, bytes | None] = {"sources/buildDescription.xml": ENTITIES.encode()}
    path = edited(native / "feedthrough3.fmu", tmp_path / "feedthrough3.fmu", changes)
    with pytest.raises(FmuError, match=r"its buildDescription\.xml has a document type declaration, which can"):
        Fmu.open(path)


CONTINUOUS = 'variability="continuous"><Real'
UNITS = {
    "<TypeDefinitions>": '<UnitDefinitions><Unit name="m"/><Unit name="blorp"/></UnitDefinitions><TypeDefinitions>',
    f'causality="input" {CONTINUOUS}': f'causality="input" {CONTINUOUS} unit="m"',
    f'causality="output" {CONTINUOUS}': f'causality="output" {CONTINUOUS} unit="blorp"',
}
NO_CAUSALITY = {
    'name="y" valueReference="1" causality="output" ': 'name="y" valueReference="1" ',
    '<Unknown index="2" dependencies="1"/>': "",
    '<InitialUnknowns><Unknown index="2"/>': "<InitialUnknowns>",
}


@pytest.mark.parametrize(
    ("replacements", "words"),
    [
        (NO_CAUSALITY, "has no output 'y'; its 'y' is declared with causality local, where output is needed"),
        (UNITS, "unit 'blorp' is not understood"),
    ],
)
def test_a_connection_to_an_ill_declared_variable_is_refused(
    replacements: dict[str, str], words: str, native: Path, tmp_path: Path
) -> None:
    edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {}, replacements)
    driven = {k: v for k, v in FREE2.items() if k != "=u"}
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "1 ms", driven)}
    with pytest.raises(InputError) as error:
        plan_of(tmp_path, tmp_path, parts, ["a.y -> b.u"])
    assert words in str(error.value) and "case.toml, line" in str(error.value)


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("discard", "returned fmi2Discard in the step to t = 0.004 s; it reached t = 0.0125 s"),
        ("error", "returned fmi2Error"),
        ("fatal", "returned fmi2Fatal"),
        ("pending", "returned fmi2Pending"),
        ("nan", "output y became nan"),
    ],
)
def test_a_fault_while_stepping_ends_the_run_and_keeps_what_there_is(
    fault: str, words: str, interpreted: bool, native: Path, tmp_path: Path
) -> None:
    values = {**FREE2, "fault": FAULTS2[fault], "bad_at": 0.0035}
    run = simulate(plan_of(tmp_path, native, {"b": ("feedthrough2", "1 ms", values)}, stop="10 ms"), interpreted)
    assert run.failure.startswith("component b") and words in run.failure
    assert f"fault {FAULTS2[fault]} at t = 0.004" in run.failure, "the FMU's own words"
    assert run.end == 0.003 and column(run, "b.x")[0].tolist() == [0.0, 0.001, 0.002, 0.003]


def test_a_warning_is_no_fault(native: Path, tmp_path: Path) -> None:
    values = {**FREE2, "fault": FAULTS2["warning"], "bad_at": 0.0035}
    assert not simulate(plan_of(tmp_path, native, {"b": ("feedthrough2", "1 ms", values)}, stop="10 ms")).failure
