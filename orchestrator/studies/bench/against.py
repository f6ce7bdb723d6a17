"""This installation against another one, such as that of an earlier commit, in turns on the same FMUs and systems.

The other one is asked by its interpreter, through what both have: `load`, `run`, `summary`, and the command itself.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...errors import InputError, RunError
from ...fmu.files.places import fmu_folder
from .fmus.native import ring

ROUNDS, QUICK = 15, 3
LOOP = (
    "import json, sys\nfrom rovbrush.orchestrator import load\n"
    "model = load(sys.argv[1], fmus=sys.argv[2])\n"
    "print(json.dumps(min(model.run().summary['wall_s'] for _ in range(3))))"
)


def against(
    python: Path, folder: Path, fmus: Path | None, quick: bool = False
) -> Iterator[tuple[float, dict[str, Any]]]:
    """The loop of `feedthrough4` and `nominal`, a start to the first step: medians [s] of both and their ratio.

    The ratio of the fastest of each is given too: a busy machine disturbs it least. With each row comes the share of
    the work that is done. Raises InputError for what is no interpreter, RunError where a run fails.
    """
    built = str((fmus or fmu_folder()).resolve())
    path = ring(folder, 4, stop="200 s")
    path.write_text(f'algorithm = "jacobi"\nrecord = []\n{path.read_text(encoding="utf-8")}', encoding="utf-8")
    rounds = QUICK if quick else ROUNDS
    figures = {"feedthrough4, loop": str(path), "nominal, loop": "nominal", "nominal, start to first step": ""}
    for k, (figure, system) in enumerate(figures.items()):
        seen: dict[Path, list[float]] = {Path(sys.executable): [], python: []}
        for number in range(rounds + 1):
            for interpreter, times in sorted(seen.items(), reverse=bool(number % 2)):  # neither is always the first
                seconds = loop_seconds(interpreter, system, built) if system else start_seconds(interpreter, built)
                if number:  # the first of each compiles
                    times.append(seconds)
        here, there = (statistics.median(times) for times in seen.values())
        best = min(seen[Path(sys.executable)]) / min(seen[python])
        row = {
            "figure": figure, "here_s": here, "there_s": there, "ratio": here / there, "ratio_of_fastest": best,
            "rounds": rounds,
        }  # fmt: skip
        yield (k + 1) / len(figures), row


def loop_seconds(python: Path, system: str, fmus: str) -> float:
    """Seconds that the loop of a system takes in an installation."""
    return float(json.loads(_output([str(python), "-c", LOOP, system, fmus]).splitlines()[-1]))


def start_seconds(python: Path, fmus: str) -> float:
    """Seconds from the start of the command to the first step of `nominal` in an installation."""
    with tempfile.TemporaryDirectory() as folder:
        command = [str(python), "-m", "rovbrush.orchestrator", "run", "nominal", "--stop", "20 ms", "--fmus", fmus]
        _output([*command, "--out", folder])
        return float(json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))["start_s"])


def _output(command: list[str]) -> str:
    try:
        with tempfile.TemporaryDirectory() as folder:  # a checkout in the current folder is not to be imported
            done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    except OSError as error:
        raise InputError(f"--against {command[0]} cannot be started: {error.strerror}") from error
    if done.returncode:
        raise RunError(f"{command[0]} failed: {done.stderr.strip()}")
    return done.stdout
