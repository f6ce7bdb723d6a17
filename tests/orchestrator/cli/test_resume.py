"""`rovbrush run` is interrupted and goes on another day, in another process."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from helpers import interrupted, rovbrush, system_text
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint
from test_command_line import COMMAND, marked_incomplete

NOMINAL = ("run", "nominal", "--set", "motor.R=0.1", "--record", "brush.F_?", "--stop")


@pytest.mark.evidence
def test_a_run_goes_on_after_ctrl_c_and_ends_bitwise_as_one_that_was_not_interrupted(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    command = [*NOMINAL, "4 s", "--fmus", str(fmus), "--out"]
    assert rovbrush(monkeypatch, *command, whole) == 0
    code, err = interrupted([sys.executable, "-c", COMMAND, *command, str(parts)], "running nominal")
    assert code == 1 and f"go on with `rovbrush run --resume {parts}`" in err
    assert 0.0 < marked_incomplete(parts, "interrupted by the user") < 4.0
    monkeypatch.chdir(tmp_path)
    capsys.readouterr()
    assert rovbrush(monkeypatch, "run", "--resume", "parts") == 0
    assert "going on from t = " in capsys.readouterr().out
    for name in ("result.nc", "result.csv"):
        assert (parts / name).read_bytes() == (whole / name).read_bytes()
    assert json.loads((parts / "summary.json").read_text())["complete"] is True
    assert not list(parts.glob(".*")), "nothing half-written"


def test_checkpoints_are_written_every_so_often_and_the_last_one_stays(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text({"a": ("wave", "2 ms", {"c1": 1.0}), "b": ("wave", "3 ms")}, stop="60 ms"))
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", whole) == 0
    assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", parts, "--checkpoint", "20 ms") == 0
    assert read_checkpoint(parts).at.time == 0.042  # the first whole cycle of 6 ms that ends at 40 ms or later
    (parts / "result.nc").unlink()
    assert rovbrush(monkeypatch, "run", "--resume", parts) == 0
    assert (parts / "result.nc").read_bytes() == (whole / "result.nc").read_bytes()


def test_an_fmu_that_cannot_be_saved_is_named_before_the_run_and_after_ctrl_c(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    presses = {"mode": 5, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0}  # Ctrl-C in the step to 6 ms
    path, out = tmp_path / "case.toml", tmp_path / "out"
    path.write_text(system_text({"fast": ("wave", "1 ms"), "p": ("plain", "1 ms", presses)}))
    words = "component p: plain.fmu cannot write its state to disk"
    arguments = ("run", path, "--fmus", fmus, "--out", out)
    assert rovbrush(monkeypatch, *arguments, "--checkpoint", "5 ms") == 2
    err = capsys.readouterr().err
    assert words in err and "FMUstate = false" in err and not out.exists()
    assert rovbrush(monkeypatch, *arguments) == 1
    err = capsys.readouterr().err
    assert "marked incomplete" in err and "the run cannot go on later" in err and words in err
    assert marked_incomplete(out, "interrupted by the user") == 0.006 and not (out / "checkpoint").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "which system?"),
        (("--resume", "nowhere"), "there is no checkpoint in nowhere"),
        (("nominal", "--resume", "nowhere"), "--resume takes system from the checkpoint"),
        (("--set", "a.b=1", "--stop", "1 s", "--resume", "nowhere"), "--resume takes set, stop from the checkpoint"),
        (("nominal", "--checkpoint", "soon"), "--checkpoint = 'soon' is not a time"),
        (("nominal", "--record", "moter.*"), "--record moter.*: no variable is called so"),
    ],
)
def test_wrong_usage_ends_with_2(
    arguments: tuple[str, ...], message: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert rovbrush(monkeypatch, "run", *arguments, "--fmus", fmus) == 2
    assert message in capsys.readouterr().err and not list(tmp_path.iterdir())
