"""How the command ends: exit codes, messages without tracebacks, and what an early end leaves behind."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pytest
import xarray
from helpers import interrupted, rovbrush, system_text
from rovbrush.orchestrator.cli.main import LOADING, main, program
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.run import carry_out

# The command with progress lines at every look, so that a test sees when the run is under way.
COMMAND = """
import sys
from rovbrush.orchestrator.cli import main, progress
progress.PLAIN_INTERVAL = 0.0
sys.argv[0] = "rovbrush"
main.main()
"""


def marked_incomplete(folder: Path, failure: str) -> float:
    """Checks that every file of an early end says so; returns the time that was reached."""
    summary = json.loads((folder / "summary.json").read_text())
    assert summary["complete"] is False and failure in summary["failure"]
    assert json.loads((folder / "manifest.json").read_text())["complete"] is False
    assert not list(folder.glob(".*.tmp*")), "nothing half-written"
    return float(summary["simulated_s"])


def test_a_short_run_ends_with_0(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = tmp_path / "new" / "folder"
    assert rovbrush(monkeypatch, "run", "test_stand", "--stop", "50 ms", "--fmus", fmus, "--out", out) == 0
    assert json.loads((out / "summary.json").read_text())["complete"] is True


def test_a_value_outside_its_bound_ends_with_1_when_checked(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    parts, bound = {"w": ("wave", "1 ms", {"c0": 1.0})}, '[summary]\nmean = "mean w.y"\n[[compare]]\nlabel = "y"\n'
    (tmp_path / "case.toml").write_text(
        system_text(parts, stop="10 ms") + bound + 'value = "mean"\nunit = "1"\nreference = 2.0\ntolerance = 0.1\n'
    )
    options = ("run", tmp_path / "case.toml", "--fmus", fmus, "--out", tmp_path / "out")
    assert rovbrush(monkeypatch, *options) == 0
    assert rovbrush(monkeypatch, *options, "--check") == 1
    assert "outside their bounds" in capsys.readouterr().err


def test_a_run_that_ends_before_it_is_steady_gets_no_verdict(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ("run", "nominal", "--stop", "40 ms", "--fmus", fmus, "--out", tmp_path)
    assert rovbrush(monkeypatch, *options) == 0
    seen = capsys.readouterr().out
    assert "not steady: no verdict" in seen and "within" not in seen and "outside" not in seen
    assert json.loads((tmp_path / "summary.json").read_text())["steady"] is False
    assert rovbrush(monkeypatch, *options, "--check") == 1
    assert "nothing could be compared" in capsys.readouterr().err


def test_an_interrupted_nominal_run_keeps_what_was_computed(fmus: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-c", COMMAND, "run", "nominal", "--stop", "100 s", "--fmus", str(fmus), "--out",
               str(tmp_path)]  # fmt: skip
    code, err = interrupted(command, "running nominal")
    assert code == 1
    assert "interrupted by the user at t = " in err and "marked incomplete" in err and "Traceback" not in err
    end = marked_incomplete(tmp_path, "interrupted by the user")
    assert 0.0 < end < 100.0
    with xarray.open_dataset(tmp_path / "result.nc", group="every_500_us") as dataset:
        assert dataset.attrs["complete"] == 0
        assert dataset["time"].values[-1] == pytest.approx(end, abs=5.1e-4)
        assert np.all(np.isfinite(dataset["brush.F_z"].values))


@pytest.mark.parametrize(
    ("values", "message"),
    [({"nan_at": 0.0149}, "output fragile became nan"), ({"raise_at": 0.0149}, "ValueError: gave up: 100 % of %s%n")],
)
def test_a_failing_component_ends_with_1_and_keeps_what_was_computed(
    values: dict[str, float], message: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    system, out = tmp_path / "case.toml", tmp_path / "out"
    system.write_text(system_text({"bad": ("faulty", "1 ms", values), "w": ("wave", "1 ms")}, stop="30 ms"))
    assert rovbrush(monkeypatch, "run", system, "--fmus", fmus, "--out", out) == 1
    err = capsys.readouterr().err
    assert "component bad" in err and message in err and "t = 0.015 s" in err and "marked incomplete" in err
    assert marked_incomplete(out, message) == pytest.approx(0.014)
    with xarray.open_dataset(out / "result.nc", group="every_1_ms") as dataset:
        assert dataset.sizes["time"] == 15 and dataset.attrs["complete"] == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("run", "nominl"), "no system 'nominl'; did you mean 'nominal'?"),
        (("run", "no/such/file.toml"), "cannot be read"),
        (("run", "nominal", "--set", "moter.R=0.1"), "no component 'moter' in 'moter.R'; did you mean 'motor'?"),
        (("run", "nominal", "--set", "brush.tolerence=1"), "brush.tolerence is unknown; did you mean 'tolerance'?"),
        (("run", "nominal", "--set", "motor.R=-1"), "motor.R = -1 Ohm is out of range"),
        (("run", "nominal", "--set", "motor.R=nan"), "motor.R = nan is not a finite number"),
        (("run", "nominal", "--set", "motor.R=much"), "motor.R = much is not a finite number"),
        (("run", "nominal", "--set", "motor.gear_stages=1.5"), "is not a whole number"),
        (("run", "nominal", "--set", "motor.R"), "write component.variable=value"),
        (("run", "nominal", "--set", "brush.zeta=[0.02,0.03"), "a list needs both brackets"),
        (("build", "dc_moter"), "no component 'dc_moter'; did you mean 'dc_motor'?"),
        (("run", "nominal", "--stop", "soon"), "--stop"),
        (("run", "nominal", "--fast"), "No such option"),
        (("runn",), "No such command"),
    ],
)
def test_wrong_usage_ends_with_2_and_one_message_before_anything_is_run(
    arguments: tuple[str, ...], message: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    out = tmp_path / "out"
    options = ("--fmus", str(fmus), "--out", str(out)) if arguments[0] == "run" else ()
    assert rovbrush(monkeypatch, *arguments, *options) == 2
    seen = capsys.readouterr()
    assert message in seen.err and seen.err.startswith("error: ") and "Traceback" not in seen.err + seen.out
    assert not out.exists()


@pytest.mark.parametrize("below", [".", "further/down"])
def test_a_folder_that_cannot_be_written_ends_with_2_before_the_run(
    below: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    # A file in the way stops every user, also one who may write anywhere.
    (tmp_path / "taken").write_text("mine")
    monkeypatch.setattr(carry_out, "Session", lambda *_args, **_keys: pytest.fail("the run began"))
    out = tmp_path / "taken" / below
    assert rovbrush(monkeypatch, "run", "nominal", "--fmus", fmus, "--out", out) == 2
    assert "cannot write to the output folder" in capsys.readouterr().err
    assert (tmp_path / "taken").read_text() == "mine"


@pytest.mark.parametrize("content", [None, b"", b"no archive"])
def test_a_missing_or_corrupt_fmu_ends_with_1(
    content: bytes | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    system = tmp_path / "case.toml"
    system.write_text(system_text({"a": (str(tmp_path / "a.fmu"), "1 ms")}))
    if content is not None:
        (tmp_path / "a.fmu").write_bytes(content)
    assert rovbrush(monkeypatch, "run", system, "--out", tmp_path / "out") == 1
    err = capsys.readouterr().err
    assert "a.fmu" in err and "Traceback" not in err
    assert not (tmp_path / "out").exists()


def test_debug_gives_the_traceback(fmus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["rovbrush", "run", "nominl", "--debug", "--fmus", str(fmus)])
    with pytest.raises(InputError, match="did you mean 'nominal'"):
        main()
    command = [sys.executable, "-m", "rovbrush.orchestrator", "run", "nominl"]
    quiet, loud = (subprocess.run([*command, *more], capture_output=True, text=True) for more in ([], ["--debug"]))
    assert quiet.returncode == 2 and "Traceback" not in quiet.stderr
    assert loud.returncode != 0 and "Traceback" in loud.stderr and "did you mean 'nominal'" in loud.stderr


def test_the_version_is_that_of_the_package(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import rovbrush

    monkeypatch.setattr(sys, "argv", ["rovbrush", "--version"])
    with pytest.raises(SystemExit) as ending:
        main()
    assert ending.value.code == 0
    assert capsys.readouterr().out == f"rovbrush {version('rovbrush')}\n" and rovbrush.__version__ == version(
        "rovbrush"
    )


@pytest.mark.parametrize("command", LOADING)
@pytest.mark.parametrize("before", [(), ("--debug",)])
def test_every_command_that_loads_fmus_is_guarded_whatever_stands_before_it(
    command: str, before: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    guarded: list[object] = []
    monkeypatch.setattr(sys, "argv", ["rovbrush", *before, command, "nominal", "--set", "motor.R=plan"])
    monkeypatch.setattr("rovbrush.orchestrator.cli.main.guarded", guarded.append)
    monkeypatch.setattr("rovbrush.orchestrator.cli.main.main", lambda: None)
    program()
    assert len(guarded) == 1


def test_at_100_columns_no_name_or_number_is_cut(fmus: Path, tmp_path: Path) -> None:
    path = tmp_path / "long.toml"
    name = "a_component_with_a_name_of_some_length_that_a_table_must_fold_and_not_cut"
    parts = {f"{name}_{k}": ("integrator", "1 ms", {"=u": 1.0}) for k in (1, 2)}
    path.write_text(system_text(parts, stop="10 ms") + f'\n[summary]\nx_mean = "mean {name}_1.x"\n')
    for command in ("plan", "run", "converge"):
        out = () if command == "plan" else ("--out", str(tmp_path / "out"))
        done = subprocess.run(
            [sys.executable, "-m", "rovbrush.orchestrator", command, str(path), "--fmus", str(fmus), *out],
            capture_output=True, text=True, check=False, env={**os.environ, "COLUMNS": "100"},
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        words = [line for line in done.stdout.splitlines() if len(line) > 100]
        assert all(len(line.split()) == 1 for line in words), words  # a word that is longer goes over the edge
        shown = "".join(re.findall(r"^│ (\S*)", done.stdout, re.M)) if "│" in done.stdout else done.stdout
        assert "…" not in done.stdout
        assert command == "run" or all(f"{name}_{k}" in shown for k in (1, 2)), done.stdout


LONG = "x" * 5000  # a name that no file can have


@pytest.mark.parametrize(
    "arguments",
    [
        ("run", LONG), ("plan", f"{LONG}.toml"), ("run", f"{LONG}.fmu"), ("info", LONG), ("check", LONG),
        ("map", LONG, "--as", "dc_motor"), ("replay", "x.fmu", LONG), ("run", "nominal", "--input", LONG),
        ("run", "nominal", "--replace", f"motor={LONG}"),
    ],
    ids=lambda arguments: " ".join(arguments).replace(LONG, "LONG"),
)  # fmt: skip
def test_a_name_that_no_file_can_have_is_one_clear_error(
    arguments: tuple[str, ...], fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROVBRUSH_FMUS", str(fmus))
    assert rovbrush(monkeypatch, *arguments) in (1, 2)
    printed = capsys.readouterr()
    assert "unexpected" not in printed.err and LONG[:50] in printed.out + printed.err
