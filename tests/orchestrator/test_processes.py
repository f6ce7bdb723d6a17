"""A foreign FMU that takes its process with it costs a command its verdict, not its message."""

from __future__ import annotations

import os
import re
import signal
import sys
from pathlib import Path
from typing import Any

import pytest
from helpers import ROOT, build_fixture, python
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.processes import EndedError, in_process

LACKING = """
[variables]
V_in = "supply"
T_brush = "load"
i = "amps"
omega_b = "speed"
"""


@pytest.fixture(scope="module")
def motor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_fixture("foreign_motor", tmp_path_factory.mktemp("foreign"))


def command(*arguments: object) -> Any:
    return python("from rovbrush.orchestrator.cli.main import main; main()", *map(str, arguments))


def test_results_and_errors_come_back_as_they_are() -> None:
    assert in_process(divmod, 7, 2) == (3, 1)
    with pytest.raises(InputError, match=r"^no such thing$"):
        in_process(refuse, "no such thing")
    with pytest.raises(ZeroDivisionError):
        in_process(divmod, 7, 0)
    with pytest.raises(SystemExit):
        in_process(sys.exit, 1)


def refuse(text: str) -> None:
    raise InputError(text)


@pytest.mark.parametrize(
    ("work", "arguments", "how"),
    [(os.abort, (), "crashed with SIGABRT (it gave up)"), (os._exit, (3,), "ended by itself with exit code 3"),
     (os._exit, (0,), "ended by itself with exit code 0"),
     (signal.raise_signal, (signal.SIGSEGV,), "crashed with SIGSEGV (it reached for memory that is not its own)"),
     (signal.raise_signal, (signal.SIGTERM,), "was ended by SIGTERM")],
)  # fmt: skip
def test_an_end_of_the_process_is_an_error_that_says_how(work: Any, arguments: Any, how: str) -> None:
    with pytest.raises(EndedError, match=f"^{re.escape(how)}$"):
        in_process(work, *arguments)


def test_a_crash_in_the_component_test_is_one_message(motor: Path, tmp_path: Path) -> None:
    (tmp_path / "map.toml").write_text(LACKING + "[parameters]\nfault = 5\n")
    run = command("test-component", motor, "--as", "dc_motor", "--map", tmp_path / "map.toml")
    assert run.returncode == 1 and "Interface" in run.stdout
    assert [line for line in run.stderr.splitlines() if line.startswith("error: ")] == [
        "error: foreign_motor.fmu ended the run: the process crashed with SIGABRT (it gave up); "
        f"`rovbrush check {motor}` finds out in which call, and how its author can repeat that"
    ]
    assert "Traceback" not in run.stderr


def test_a_crash_in_a_replay_is_one_message(motor: Path, tmp_path: Path) -> None:
    folder = ROOT / "fmus" / "recordings"
    names = [line.split(",")[0] for line in (folder / "dc_motor_parameters.csv").read_text().splitlines()[1:]]
    absent = "".join(f'{name} = ""\n' for name in names if f"{name} = " not in LACKING)
    (tmp_path / "map.toml").write_text(f"{LACKING}{absent}[parameters]\nfault = 5\n")
    run = command("replay", motor, folder, "--name", "dc_motor", "--map", tmp_path / "map.toml")
    assert run.returncode == 1, run.stderr
    assert "error: foreign_motor.fmu ended the run: the process crashed with SIGABRT" in run.stderr
    assert "Traceback" not in run.stderr
