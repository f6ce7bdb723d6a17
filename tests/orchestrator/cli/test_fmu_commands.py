"""What shows an FMU or an installation: info, map, doctor, and an FMU that is run alone."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import exchange_build
import fmpy
import pytest
from cells_fmu import cells, scalar
from helpers import build_fixture, edited, rovbrush
from native_build import built, needs_gcc
from rovbrush.orchestrator.exchange.component_tests.skeleton import skeleton
from rovbrush.orchestrator.exchange.component_tests.suites import suite_of
from rovbrush.orchestrator.fmu.contents import contents_of
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.system.replace.mapping import load_mapping


@needs_gcc
def test_info_tells_types_units_ranges_starts_and_items(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fmu = cells(tmp_path / "pump.fmu", [
        scalar("u", 0, "input", start="0.5", unit="m", min="-1", max="2", description="height"), scalar("y", 100),
        scalar("mode", 3, "parameter", "Enumeration", declaredType="Mode", start="7"),
        *(scalar(f"v{k}", 10 + k, "local") for k in range(40)),
    ], 'stopTime="2" stepSize="0.01"')  # fmt: skip
    assert rovbrush(monkeypatch, "info", fmu) == 0
    text = capsys.readouterr().out
    for words in ("stop 2 s, step 0.01 s", "-1 .. 2", "height", "off (1), on (7)", "30 of 40", "linux64"):
        assert words in text, words
    assert rovbrush(monkeypatch, "info", fmu, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found == json.loads(json.dumps(contents_of(Fmu.open(fmu)))) and len(found["variables"]) == 43
    assert found["variables"][0] == {
        "name": "u", "type": "Real", "causality": "input", "variability": "continuous", "initial": "exact", "unit": "m",
        "min": -1.0, "max": 2.0, "start": "0.5", "description": "height",
    }  # fmt: skip
    assert found["variables"][2]["items"] == {"off": 1, "on": 7}
    assert found["experiment"] == {"stop": 2.0, "step": 0.01}


@needs_gcc
def test_info_shows_every_start_value_of_an_array_of_texts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fmu = built(tmp_path) / "feedthrough3.fmu"
    starts = Fmu.open(fmu).texts["t_in"]
    assert len(starts) == 2 and starts[0] != starts[1]
    assert rovbrush(monkeypatch, "info", fmu, "--json") == 0
    found = {v["name"]: v["start"] for v in json.loads(capsys.readouterr().out)["variables"]}
    assert found["t_in"] == starts
    assert rovbrush(monkeypatch, "info", fmu) == 0
    text = capsys.readouterr().out
    assert all(json.dumps(start) in text for start in starts)  # a narrow terminal folds them


@needs_gcc
def test_info_shows_an_fmu_that_cannot_be_run_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fmu = cells(tmp_path / "pump.fmu", [scalar("y", 100)])
    edited(fmu, tmp_path / "other.fmu", {f"binaries/{fmpy.platform}/pump.so": None, "binaries/arm/pump.so": b"x"})
    assert rovbrush(monkeypatch, "info", tmp_path / "other.fmu") == 0
    text = capsys.readouterr().out
    assert "platforms     arm" in text and "not run here" in text and "│ y" in text


def test_info_is_readable_at_100_columns(fmus: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "rovbrush.orchestrator", "info", str(fmus / "wave.fmu"), "--all"],
        env={"COLUMNS": "100", "PATH": ""}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert max(map(len, done.stdout.splitlines())) <= 100 and "…" not in done.stdout


@pytest.mark.parametrize("component", ["dc_motor", "rov_controller"])
def test_map_fills_a_file_that_the_reader_accepts(component: str, tmp_path: Path) -> None:
    name = {"dc_motor": "foreign_motor", "rov_controller": "foreign_controller"}[component]
    fmu, suite = Fmu.open(build_fixture(name, tmp_path)), suite_of(component)
    path = tmp_path / "map.toml"
    path.write_text(skeleton(fmu, suite), encoding="utf-8")
    mapping = load_mapping(path)
    mapping.check([v.name for v in suite.interface], fmu.variables, component, fmu.path.name)
    assert mapping.entries.keys() == {v.name for v in suite.interface}
    named = [entry.name for entry in mapping.entries.values() if not entry.absent]
    assert len(named) == len(set(named)) > 0
    if component == "dc_motor":
        assert {ours: mapping.entry(ours).name for ours in ("R", "L_a", "K_t", "K_e")} == {
            "R": "Ra", "L_a": "La", "K_t": "kt", "K_e": "ke"
        }  # fmt: skip
    driven = set(named) | set(mapping.inputs)
    assert set(fmu.names("input")) <= driven  # nothing of theirs is left alone


def test_map_finds_our_own_names(fmus: Path) -> None:
    suite = suite_of("dc_motor")
    text = skeleton(Fmu.open(fmus / "dc_motor.fmu"), suite)
    assert all(f'{v.name} = "{v.name}"' in text for v in suite.interface)


def test_doctor_names_what_a_run_needs(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROVBRUSH_FMUS", str(fmus))
    assert rovbrush(monkeypatch, "doctor", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    for heading in ("rovbrush", "Python", "numba", "FMI platform", "C compiler", "wine", "cache", "FMUs", "the loop"):
        assert found[heading]["found"], heading
    monkeypatch.setenv("ROVBRUSH_FMUS", str(tmp_path / "none"))
    assert rovbrush(monkeypatch, "doctor") == 1
    assert "<- rovbrush build" in capsys.readouterr().out


@needs_gcc
def test_run_takes_an_fmu_and_writes_a_table_for_each_rate(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fmu = cells(tmp_path / "pump.fmu", [scalar("u", 0, "input", start="0.5", unit="m"), scalar('y "1"', 100)])
    out = tmp_path / "out"
    options = ("--set", "u=50cm", "--stop", "3 ms", "--period", "1 ms", "--csv-per-rate")
    assert rovbrush(monkeypatch, "run", fmu, "--out", out, *options) == 0
    assert "every_1_ms.csv" in capsys.readouterr().out
    lines = (out / "every_1_ms.csv").read_text().splitlines()
    assert lines == ['time [s],"pump.y ""1"" [1]"', *(f"{t},100.5" for t in ("0.0", "0.001", "0.002", "0.003"))]
    assert (out / "result.csv").read_text().splitlines() == lines
    assert "every_1_ms.csv" in json.loads((out / "manifest.json").read_text())["files"]


@needs_gcc
def test_info_counts_the_states_and_event_indicators_of_model_exchange(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for version in (2, 3):
        exchange_build.exchange(tmp_path, "ball", version)
        assert rovbrush(monkeypatch, "info", tmp_path / "ball.fmu") == 0
        assert re.search(r"equations +2 states, 1 event indicator\n", capsys.readouterr().out)
