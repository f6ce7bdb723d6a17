"""`rovbrush check`: every rule on archive and description has an FMU that breaks it; good FMUs break none."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from helpers import edited
from rovbrush.components.build import COMPONENTS
from rovbrush.orchestrator.exchange.checks import external
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.exchange.checks.note_rows import note_rows
from rovbrush.orchestrator.exchange.checks.rows import Row
from rovbrush.orchestrator.exchange.checks.rules.archive_rules import archive_rows, loadable_row
from rovbrush.orchestrator.exchange.checks.rules.description_rules import capability_rows, description_rows
from rovbrush.orchestrator.exchange.checks.rules.unit_rules import unit_rows
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.tolerant import rules

K = '<Real unit="1" min="-1000000.0" max="1000000.0" nominal="1.0" start="1.0"/>'
Edit = Callable[..., Path]


@pytest.fixture
def gain(fmus: Path, tmp_path: Path) -> Edit:
    """`gain(changes, replacements)`: the good FMU `gain` with something broken."""

    def edit(changes: dict[str, bytes | None], replacements: dict[str, str] | None = None) -> Path:
        return edited(fmus / "gain.fmu", tmp_path / "edited.fmu", changes, replacements)

    return edit


def static_rows(path: Path) -> dict[str, Row]:
    """The rows that need no process, by rule."""
    subject = open_subject(path)
    groups = (archive_rows, description_rows, unit_rows, capability_rows)
    return {row.rule: row for group in groups for row in group(subject)}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", COMPONENTS)
def test_the_python_fmus_have_no_findings(name: str, fmus: Path) -> None:
    report = check_fmu(fmus / f"{name}.fmu")
    assert report.clean and report.count("pass") >= 40, [row for row in report.rows if row.verdict != "pass"]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("name", COMPONENTS)
def test_the_native_fmus_have_no_findings(name: str, version: str, native: Path) -> None:
    report = check_fmu(native / version / f"{name}.fmu")
    assert report.clean and report.count("pass") >= 40, [row for row in report.rows if row.verdict != "pass"]


DESCRIPTIONS = {
    "variables are described": ("finding", {'description="input" ': ""}),
    "min is not above max": ("finding", {K: '<Real unit="1" min="3.0" max="2.0" start="2.0"/>'}),
    "start is within min and max": ("finding", {K: K.replace('start="1.0"', 'start="2e6"')}),
    "Outputs is complete": ("finding", {'<Unknown index="9" dependencies=""/>': ""}),
    "InitialUnknowns is complete": ("finding", {'<Unknown index="9" dependencies="1 2 3 4 5 6"/>': ""}),
    "dependencies are declared": ("finding", {'<Unknown index="8" dependencies="7"/>': '<Unknown index="8"/>'}),
    "guid identifies the content": ("finding", {'modelName="gain" guid="{': 'modelName="gain" guid="one {'}),
    "a step size is suggested": ("finding", {' stepSize="0.001"': ""}),
    "every number has a unit": ("finding", {K: K.replace('unit="1" ', "")}),
    "units are defined": ("finding", {K: K.replace('unit="1"', 'unit="m"')}),
    "units are understood": ("finding", {'<Unit name="N">': '<Unit name="bananas">'}),
    "BaseUnit is given": ("finding", {'<BaseUnit kg="1" m="1" s="-2"/>': ""}),
    "BaseUnit fits the name": ("finding", {'kg="1" m="1" s="-2"': 'kg="1" m="2" s="-2"'}),
    "states can be saved": ("finding", {'canGetAndSetFMUstate="true"': 'canGetAndSetFMUstate="false"'}),
    "states can be serialized": ("finding", {'canSerializeFMUstate="true"': ""}),
    "steps may vary": ("finding", {'canHandleVariableCommunicationStepSize="true"': ""}),
    "several instances per process": ("finding", {'OnlyOncePerProcess="false"': 'OnlyOncePerProcess="true"'}),
    "no other tool is needed": ("finding", {'needsExecutionTool="false"': 'needsExecutionTool="true"'}),
    "modelIdentifier is a C name": ("finding", {'modelIdentifier="gain"': 'modelIdentifier="a gain"'}),
    "binaries bear the identifier": ("finding", {'modelIdentifier="gain"': 'modelIdentifier="loss"'}),
}  # fmt: skip


@pytest.mark.parametrize("rule", DESCRIPTIONS)
def test_a_fault_of_the_description_is_found_with_a_mend(rule: str, gain: Edit) -> None:
    verdict, replacements = DESCRIPTIONS[rule]
    row = static_rows(gain({}, replacements))[rule]
    assert row.verdict == verdict and row.mend, row


@pytest.mark.parametrize(
    ("base", "verdict"),
    [
        ('<BaseUnit kg="1" m="1" s="-2" factor="1000"/>', "finding"),
        ('<BaseUnit kg="1" m="1" s="-2" offset="1"/>', "finding"),
        ('<BaseUnit kg="1" m="1" s="-2" rad="1"/>', "pass"),
    ],
)
def test_factor_and_offset_of_a_unit_count_and_radians_do_not(base: str, verdict: str, gain: Edit) -> None:
    row = static_rows(gain({}, {'<BaseUnit kg="1" m="1" s="-2"/>': base}))["BaseUnit fits the name"]
    assert row.verdict == verdict


def test_a_temperature_in_degrees_celsius_needs_its_offset(gain: Edit) -> None:
    degrees = {'<Unit name="N">': '<Unit name="degC">', 'unit="N"': 'unit="degC"'}
    for base, verdict in (('K="1" offset="273.15"', "pass"), ('K="1"', "finding")):
        path = gain({}, {**degrees, 'kg="1" m="1" s="-2"': base})
        assert static_rows(path)["BaseUnit fits the name"].verdict == verdict


def packed(source: Path, target: Path, **options: object) -> Path:
    """The FMU packed again in another way: `reverse`, `year` of the first entry, `twice` an entry."""
    with zipfile.ZipFile(source) as archive:
        entries = {info.filename: archive.read(info) for info in archive.infolist()}
    names = sorted(entries, reverse=bool(options.get("reverse")))
    with zipfile.ZipFile(target, "w") as archive:
        for k, name in enumerate(names):
            year = int(str(options.get("year", 1980))) if k == 0 else 1980
            archive.writestr(zipfile.ZipInfo(name, (year, 1, 1, 0, 0, 0)), entries[name])
        if options.get("twice"):
            with pytest.warns(UserWarning, match="Duplicate name"):
                archive.writestr(zipfile.ZipInfo(names[0]), entries[names[0]])
    return target


@pytest.mark.parametrize(
    ("rule", "verdict", "options"),
    [
        ("entries are sorted", "finding", {"reverse": True}),
        ("dates are fixed", "finding", {"year": 2020}),
    ],
)
def test_a_careless_archive_is_found(
    rule: str, verdict: str, options: dict[str, object], fmus: Path, tmp_path: Path
) -> None:
    sound = static_rows(packed(fmus / "gain.fmu", tmp_path / "sound.fmu"))
    assert sound[rule].verdict == "pass"
    assert static_rows(packed(fmus / "gain.fmu", tmp_path / "bad.fmu", **options))[rule].verdict == verdict


def test_an_entry_that_is_there_twice_with_one_content_is_a_finding(fmus: Path, tmp_path: Path) -> None:
    (row,) = note_rows(open_subject(packed(fmus / "gain.fmu", tmp_path / "bad.fmu", twice=True)).notes)
    assert (row.rule, row.verdict) == (rules.TWICE.found, "finding") and row.mend


def test_a_time_of_generation_is_found(gain: Edit) -> None:
    path = gain({}, {'version="0.1.0"': 'version="0.1.0" generationDateAndTime="2026-01-01T00:00:00Z"'})
    assert "generationDateAndTime" in static_rows(path)["dates are fixed"].found


def test_missing_documentation_is_found(gain: Edit) -> None:
    assert static_rows(gain({"documentation/index.html": None}))["documentation is inside"].verdict == "finding"


def test_an_unknown_platform_folder_is_found(gain: Edit) -> None:
    assert static_rows(gain({"binaries/linux128/gain.so": b""}))["platform folders"].verdict == "finding"


def test_sources_without_a_list_or_a_list_without_sources_are_found(gain: Edit) -> None:
    unlisted = static_rows(gain({"sources/gain.c": b""}))["sources are complete"]
    assert unlisted.verdict == "finding" and "a list of the source files" in unlisted.found
    flags = 'canSerializeFMUstate="true"'
    files = {f"{flags}/>": f'{flags}><SourceFiles><File name="gain.c"/></SourceFiles></CoSimulation>'}
    missing = static_rows(gain({}, files))["sources are complete"]
    assert missing.verdict == "finding" and "gain.c" in missing.found
    assert static_rows(gain({"sources/gain.c": b""}, files))["sources are complete"].verdict == "pass"


OTHERS = {"binaries/linux64/gain.so": None, "binaries/win64/gain.dll": None, "binaries/darwin32/gain.dylib": b"x"}


def test_a_binary_for_another_system_only_is_one_clear_row_with_a_remedy(gain: Edit) -> None:
    row = loadable_row(open_subject(gain(OTHERS)))
    assert row.verdict == "error" and "none for linux64; there is darwin32" in row.found and "this platform" in row.mend
    row = loadable_row(open_subject(gain({**OTHERS, "sources/gain.c": b""})))
    assert "nothing says how to compile them" in row.mend


@pytest.mark.parametrize(
    ("changes", "replacements", "found", "mend"),
    [
        ({}, {'fmiVersion="2.0"': 'fmiVersion="1.0"'}, "FMI version 1.0", "correct fmiVersion"),
        ({}, {"<CoSimulation": "<Cosimulation"}, "no interface at all", "co-simulation"),
        ({"modelDescription.xml": None}, None, "no modelDescription.xml", "not an FMU"),
        ({"../evil.txt": b""}, None, "would leave the unpack folder", "inside the archive"),
        ({}, {"<fmiModelDescription": "<!DOCTYPE x><fmiModelDescription"}, "document type", "remove it"),
        ({}, {"</fmiModelDescription>": ""}, "not well-formed", ""),
        ({}, {'fmiVersion="2.0"': 'fmiVersion="3.0"'}, "variables can be understood", "correct fmiVersion"),
    ],
)
def test_what_cannot_be_checked_is_one_clear_row(
    changes: dict[str, bytes | None], replacements: dict[str, str] | None, found: str, mend: str, gain: Edit, fmus: Path
) -> None:
    if changes == {"modelDescription.xml": None}:
        path = fmus.parent / "bare.fmu"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("readme.txt", "nothing")
    else:
        path = gain(changes, replacements)
    report = check_fmu(path)
    (row,) = report.rows
    assert row.verdict == "error" and found in row.found + row.mend and mend in row.found + row.mend, row
    assert not report.clean


def test_an_fmu_that_does_not_run_gets_no_further_rules(gain: Edit) -> None:
    rows = check_fmu(gain({"binaries/linux64/gain.so": b"no library"})).rows
    assert [(row.verdict, row.rule) for row in rows[-2:]] == [
        ("error", "runs with its start values"),
        ("not applicable", "all further rules"),
    ]


# --- other tools ---


def test_fmpy_and_fmutool_are_heard(gain: Edit) -> None:
    pytest.importorskip("fmu_manipulation_toolbox")
    subject = open_subject(gain({}, {'name="held"': 'name="y"'}))
    for row, words in (
        (external.fmpy_row(subject), "not unique"),
        (external.fmutool_row(subject), "several variables"),
    ):
        assert row.verdict == "finding" and words in row.found, row


def test_a_missing_fmutool_is_named_with_how_to_install_it(fmus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "fmu_manipulation_toolbox.checker", None)
    row = external.fmutool_row(open_subject(fmus / "gain.fmu"))
    assert row.verdict == "skipped" and row.mend == 'pip install "rovbrush[check]"'


def test_a_tool_that_cannot_read_the_version_is_named_and_not_counted(
    fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    checker = pytest.importorskip("fmu_manipulation_toolbox.checker")
    monkeypatch.setattr(checker.OperationGenericCheck, "SUPPORTED_FMI_VERSIONS", ("3.0",))
    row = external.fmutool_row(open_subject(fmus / "gain.fmu"))
    assert row.verdict == "not applicable" and "fmutool" in row.found and "cannot read FMI 2.0" in row.found


# --- FMI 3.0 ---


def test_array_starts_of_the_wrong_number_are_found(native: Path, tmp_path: Path) -> None:
    name = "rov_vehicle"
    with zipfile.ZipFile(native / "fmi3" / f"{name}.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    array = next(line for line in text.splitlines() if 'name="r_tool"' in line)
    start = array.split('start="')[1].split('"')[0]
    broken = {array: array.replace(f'start="{start}"', f'start="{start} 0.0"')}
    path = edited(native / "fmi3" / f"{name}.fmu", tmp_path / "edited.fmu", {}, broken)
    row = static_rows(path)["arrays have enough starts"]
    assert row.verdict == "finding" and "r_tool" in row.found


# --- the command ---


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "COLUMNS": "100"}
    return subprocess.run(
        [sys.executable, "-m", "rovbrush.orchestrator", "check", *arguments],
        capture_output=True, text=True, check=False, env=environment,
    )  # fmt: skip


def test_the_command_shows_a_table_writes_json_and_returns_the_verdict(fmus: Path, gain: Edit, tmp_path: Path) -> None:
    bad = gain(OTHERS, {'description="input" ': ""})
    json_file = tmp_path / "report.json"
    run = command(str(fmus / "gain.fmu"), str(bad), "--json", str(json_file))
    assert run.returncode == 1 and not run.stderr, run.stderr
    assert all(len(line.rstrip()) <= 100 for line in run.stdout.splitlines() if str(tmp_path) not in line)
    assert "0 errors, 0 findings" in run.stdout and "mend: say in a few words" in run.stdout
    good, broken = json.loads(json_file.read_text())
    assert (good["errors"], good["findings"], good["kind"]) == (0, 0, "FMI 2.0, gain")
    found = {row["rule"]: row for row in broken["rows"]}
    assert found["variables are described"]["verdict"] == "finding"
    assert found["binary for this machine"]["verdict"] == "error"
    assert broken["errors"] == sum(row["verdict"] == "error" for row in broken["rows"]) == 1


def test_the_exit_code_is_zero_without_errors_and_one_for_a_missing_file(native: Path, tmp_path: Path) -> None:
    good = native / "fmi2" / "constant_speed.fmu"
    assert command(str(good), "--strict").returncode == 0
    found = edited(good, tmp_path / "found.fmu", {}, {'description="input voltage" ': ""})
    run = command(str(found))
    assert run.returncode == 0 and "0 errors, 1 finding" in run.stdout
    assert command(str(found), "--strict").returncode == 1
    run = command(str(tmp_path / "none.fmu"))
    assert run.returncode == 1 and "does not exist" in run.stdout
