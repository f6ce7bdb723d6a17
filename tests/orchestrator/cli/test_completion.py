"""The tab key in a shell, by the protocol of environment variables that shells speak with the command."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import h5py  # type: ignore[import-untyped]
import pytest

CALL = "import sys; sys.argv = ['rovbrush']; from rovbrush.orchestrator.cli.main import program; program()"
HEAVY = ("numpy", "fmpy", "xarray", "numba", "lxml", "pint", "h5py", "matplotlib")
DESCRIPTION = """<?xml version="1.0"?><fmiModelDescription fmiVersion="2.0"><ModelVariables>
<ScalarVariable name="k" causality="parameter" description="stiffness $(id) `x` [1]"><Real start="2.0" unit="N/m"/></ScalarVariable>
<ScalarVariable name="n" causality="parameter"><Integer start="0"/></ScalarVariable>
<ScalarVariable name="u" causality="input"><Real start="0.5"/></ScalarVariable>
<ScalarVariable name="v" causality="input"><Real start="0.5"/></ScalarVariable>
<ScalarVariable name="$(touch gone)" causality="parameter"><Real start="1"/></ScalarVariable>
<ScalarVariable name="k`id`" causality="parameter"><Real start="1"/></ScalarVariable>
<ScalarVariable name="y" causality="output"><Real/></ScalarVariable>
</ModelVariables></fmiModelDescription>
"""  # noqa: E501
SYSTEM = """\
stop_time = "1 s"
connections = ["a.y -> b.u (mean)"]
[components.a]
fmu = "their.fmu"
parameters = { k = 3.5 }
[components.b]
fmu = "their.fmu"
"""


@pytest.fixture
def place(tmp_path: Path) -> Path:
    with zipfile.ZipFile(tmp_path / "their.fmu", "w") as archive:
        archive.writestr("modelDescription.xml", DESCRIPTION)
    (tmp_path / "mine.toml").write_text(SYSTEM)
    return tmp_path


def completed(words: str, folder: Path, shell: str = "bash", code: str = CALL) -> list[str]:
    """What is offered for the last word of a line; a line that ends with a space asks for the next word."""
    parts = words.split(" ")
    asked = {"COMP_WORDS": "\n".join(parts) if shell == "bash" else "", "COMP_CWORD": str(len(parts) - 1)}
    asked |= {"_TYPER_COMPLETE_ARGS": words, "_TYPER_COMPLETE_FISH_ACTION": "get-args"}
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=folder, timeout=60, check=False,
        env={**os.environ, **asked, "_ROVBRUSH_COMPLETE": f"complete_{shell}"},
    )  # fmt: skip
    assert done.stderr == "" and done.returncode in (0, 1), done.stderr
    return [line for line in done.stdout.splitlines() if line]


def test_commands_systems_and_files_are_found(place: Path) -> None:
    assert {"plan", "systems", "sweep"} <= set(completed("rovbrush ", place))
    assert completed("rovbrush run nom", place) == ["nominal"]
    assert completed("rovbrush plan mi", place) == ["mine.toml"] and "their.fmu" in completed("rovbrush run ", place)
    assert {"monte_carlo", "map", "nominal"} <= set(completed("rovbrush sweep ", place))
    assert completed("rovbrush run nominal --parameters ro", place) == ["roller", "roller_pair"]
    assert completed("rovbrush systems --copy cup_", place) == ["cup_nominal"]


def test_what_can_be_set_comes_with_its_value_and_what_is_driven_does_not_come(place: Path) -> None:
    found = completed("rovbrush run mine.toml --set ", place)
    assert found == ["a.k=3.5", "a.n=0", "a.u=0.5", "a.v=0.5", "b.k=2.0", "b.n=0", "b.v=0.5"]
    assert completed("rovbrush run mine.toml --set b.k", place) == ["b.k=2.0"]
    assert completed("rovbrush sweep mine.toml --vary a.", place)[:2] == ["a.k=2.8:4.2:5", "a.n=0:1:5"]
    assert completed("rovbrush run their.fmu --set their.k", place) == ["their.k=2.0"]


def test_signals_and_components_of_the_system_are_found(place: Path) -> None:
    found = completed("rovbrush run mine.toml --record ", place)
    assert {"a.*", "b.*", "a.y", "b.y", "a.k"} <= set(found) and "a.u" not in found
    assert completed("rovbrush run mine.toml --record-boundary ", place) == ["a", "b"]
    assert completed("rovbrush run mine.toml --replace ", place) == ["a=", "b="]


def test_signals_of_a_results_folder_are_found(place: Path) -> None:
    (place / "run").mkdir()
    with h5py.File(place / "run" / "result.nc", "w") as file:
        for group, names in (("every_1_ms", ("time", "a.y", "a.$(id)")), ("every_2_ms", ("time", "b.y"))):
            for name in names:
                file[f"{group}/{name}"] = [0.0]
        file["events/what"] = [0.0]
    assert completed("rovbrush plot run ", place) == ["a.*", "b.*", "a.y", "b.y"]
    assert completed("rovbrush plot run a.y b", place) == ["b.*", "b.y"]
    assert completed("rovbrush compare run run --signal a", place) == ["a.*", "a.y"]


def test_names_of_strangers_are_not_offered_where_a_shell_would_run_them(place: Path) -> None:
    """zsh evaluates what it is told."""
    for shell in ("bash", "zsh", "fish"):
        said = "\n".join(completed("rovbrush run mine.toml --set ", place, shell))
        assert "a.k=3.5" in said and "touch" not in said and "`" not in said and "$" not in said, shell
    assert not (place / "gone").exists()


@pytest.mark.parametrize(
    "line",
    [
        "rovbrush run nowhere.toml --set ",
        "rovbrush run broken.toml --set ",
        "rovbrush run nosuch --record ",
        "rovbrush run bare.toml --set ",
        "rovbrush run --set ",
        "rovbrush plot nowhere ",
        "rovbrush plot . ",
    ],
)
def test_where_something_is_wrong_nothing_is_offered_and_nothing_said(line: str, place: Path) -> None:
    (place / "broken.toml").write_text("[[[")
    (place / "bare.toml").write_text('[components.a]\nfmu = "nowhere.fmu"\n')
    assert completed(line, place) == []


def test_nothing_heavy_is_loaded(place: Path) -> None:
    code = (
        "import sys, atexit; atexit.register(lambda: print('loaded', *sorted(set(sys.modules) & "
        f"{set(HEAVY)!r}))); {CALL}"
    )
    for line in ("rovbrush run ", "rovbrush run mine.toml --set ", "rovbrush run mine.toml --record "):
        assert completed(line, place, code=code)[-1] == "loaded", line


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_for_a_shell_names_the_variable(shell: str, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", CALL], capture_output=True, text=True, timeout=60, check=False, cwd=tmp_path,
        env={**os.environ, "_ROVBRUSH_COMPLETE": f"source_{shell}"},
    )  # fmt: skip
    assert done.returncode == 0 and f"_ROVBRUSH_COMPLETE=complete_{shell}" in done.stdout, done.stderr
    code = CALL.replace("['rovbrush']", "['rovbrush', '--show-completion', '" + shell + "']")
    env = {**os.environ, "_TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION": "1"}
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=env, check=False)
    assert shown.returncode == 0 and "_ROVBRUSH_COMPLETE" in shown.stdout, shown.stderr
