"""Scenarios from the command line: what happened is told, a checkpoint keeps them, sweeps see them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from helpers import rovbrush, system_text
from rovbrush.orchestrator.results.opened import open_result
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint
from rovbrush.orchestrator.studies.sweep.workers.point import Job, digest, job_system
from rovbrush.orchestrator.system.request import changes_of

SCENARIO = '[[events]]\nname = "up"\nat = "20 ms"\nset = { "i.u" = 2.0 }\n'
LINE = "30 ms: loss j.u for 10 ms"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    parts = {"w": ("wave", "2 ms", {"c1": 1.0}), "i": ("integrator", "2 ms", {"=u": 1.0}), "j": ("integrator", "2 ms")}
    (tmp_path / "case.toml").write_text(system_text(parts, ["w.y -> j.u"], stop="60 ms"))
    (tmp_path / "up.toml").write_text(SCENARIO)
    return tmp_path / "case.toml"


def test_a_run_tells_what_happened_and_what_did_not(
    path: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    never = "w.y > 5: i.u = 0"
    options = ("--scenario", tmp_path / "up.toml", "--event", LINE, "--event", never)
    assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", tmp_path / "out", *options) == 0
    said = capsys.readouterr().out
    lines = ["t = 0.02 s: up: i.u = 2", "t = 0.03 s: --event 1: j.u is 0 (loss)", "t = 0.04 s: --event 1: j.u is 0"]
    assert all(line in said for line in lines) and "did not happen: --event 2" in said
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["events"][0] == lines[0] and summary["did_not_happen"] == ["--event 2"]
    events = open_result(tmp_path / "out").events
    assert "up: i.u = 2" in events["what"].values.tolist()


def test_a_run_that_goes_on_has_the_events_that_it_began_with(
    path: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    monkeypatch.chdir(tmp_path)
    options = ("--fmus", fmus, "--scenario", "up.toml", "--event", LINE, "--checkpoint", "25 ms")
    for out in (whole, parts):
        assert rovbrush(monkeypatch, "run", path, *options, "--out", out) == 0
    assert 0.025 < read_checkpoint(parts).at.time < 0.06
    (parts / "result.nc").unlink()
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert rovbrush(monkeypatch, "run", "--resume", parts) == 0
    assert (parts / "result.nc").read_bytes() == (whole / "result.nc").read_bytes()
    (tmp_path / "up.toml").write_text(SCENARIO.replace("2.0", "3.0"))
    capsys.readouterr()
    assert rovbrush(monkeypatch, "run", "--resume", parts) == 2
    assert "scenario" in capsys.readouterr().err
    assert rovbrush(monkeypatch, "run", "--resume", parts, "--event", LINE) == 2
    assert "--resume takes event from the checkpoint" in capsys.readouterr().err


def test_sweeps_see_them_and_know_them_apart(path: Path, fmus: Path, tmp_path: Path) -> None:
    def job(**more: list[str]) -> Job:
        return Job(str(path), str(fmus), (("events.up.at", "30 ms"),), changes=changes_of((), (), (), **more))

    system = job_system(job(scenarios=[str(tmp_path / "up.toml")], events=[LINE]))
    assert [event.name for event in system.events] == ["up", "--event 1"] and float(system.events[0].at or 0) == 0.03
    assert digest(system) != digest(job_system(job(scenarios=[str(tmp_path / "up.toml")])))


@pytest.mark.parametrize("command", ["plan", "sweep", "converge", "fit", "sensitivity", "optimise"])
def test_other_commands_take_them_too(
    command: str, path: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    (tmp_path / "log.csv").write_text("time,i.x\n0,0\n0.05,1\n")
    more = {"sweep": ["--vary", "w.c1=1,2"], "fit": ["--data", "log.csv", "--vary", "w.c1=0:2", "--match", "i.x"],
            "sensitivity": ["--vary", "w.c1=0:2"],
            "optimise": ["--vary", "w.c1=0:2", "--minimise", "last i.x"]}.get(command, [])  # fmt: skip
    assert rovbrush(monkeypatch, command, path, "--fmus", fmus, *more, "--event", "1 s: i.u = 2") != 0
    assert "at = 1 s is not before the stop at" in capsys.readouterr().err
