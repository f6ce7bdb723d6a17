"""A run that writes checkpoints is killed, kill -9, at any instant: what is left is whole, or is not taken for whole.

Half of the kills come after a time, to the command or to the process that does its work; the others before the n-th
thing that the run does with a file. Then the run goes on with `--resume`, where there is a checkpoint.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from functools import cache
from pathlib import Path

import numpy as np
from native_build import feedthrough2

from . import seeded

NAME = "kills"
CLAIM = "after kill -9 nothing half-written is taken for whole, and --resume ends bitwise as if nothing had been"
COUNT = 200
UNIT = "kills"
LIMIT = 180.0  # s
SAMPLE = 2

ACTS = 60  # of a run on files: kills come before one of them
WINDOW = 2.0  # s after the first line that is printed: kills come within

COMMAND = """
import os, shutil, signal, sys
from pathlib import Path
from rovbrush.orchestrator.cli import main
from rovbrush.orchestrator.run.recording import recorder
streamed, left, *arguments = sys.argv[1:]
if streamed == "True":
    recorder.IN_MEMORY, recorder.PIECE, recorder.CHUNK = 4000, 2000, 5
left = int(left)
def counted(function):
    def act(*values, **keys):
        global left
        left -= 1
        if left == 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return function(*values, **keys)
    return act
if left:
    for place, name in ((Path, "rename"), (Path, "replace"), (Path, "write_bytes"), (Path, "write_text"),
                        (Path, "mkdir"), (os, "fsync"), (shutil, "rmtree"), (os, "posix_fallocate")):
        setattr(place, name, counted(getattr(place, name)))
sys.argv = ["rovbrush", *arguments]
main.program()
"""


def prepare(folder: Path) -> None:
    """A system of two FMUs whose steps take a millisecond."""
    feedthrough2(folder / "slow.fmu", STEP_US=500)
    free = "n_in = 1, mode_in = 2, on_in = true, s_in = 'on'"
    text = 'format = 2\nstop_time = "0.4 s"\nconnections = ["a.x -> b.u"]\n'
    for name, more in (("a", "u = 1.5, "), ("b", "")):
        text += f'[components.{name}]\nfmu = "{folder}/slow.fmu"\nperiod = "1 ms"\ninputs = {{ {more}{free} }}\n'
    (folder / "case.toml").write_text(text)


def one(index: int, folder: Path) -> str:
    chance = seeded(NAME, index)
    streamed, by_count = bool(index % 2), bool(index // 2 % 2)
    out, system = folder / "out", folder.parent / "case.toml"
    begin = ["run", str(system), "--checkpoint", "20 ms", "--out", str(out)]
    left = chance.randrange(1, ACTS) if by_count else 0
    _killed(streamed, left, begin, chance.uniform(0.0, WINDOW), chance.random() < 0.5)
    if wrong := _visible(out, folder.parent):
        return wrong
    done = _command(streamed, 0, ["run", "--resume", str(out)])
    _, error = done.communicate()
    if done.returncode == 2 and "there is no checkpoint" in error:
        left_over = list(out.glob("*checkpoint*")) if out.is_dir() else []
        whole = [path.name for path in left_over if (path / "checkpoint.sha256").exists()]
        return f"a checkpoint is there and was not found: {whole}" if whole else ""
    if done.returncode:
        return f"--resume: exit code {done.returncode}: {error}"
    if half := [path.name for path in out.iterdir() if path.name.startswith(".")]:
        return f"not swept up: {half}"
    return _same(out / "result.nc", folder.parent)


def _command(streamed: bool, left: int, arguments: list[str]) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", COMMAND, str(streamed), str(left), *arguments], stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True,
    )  # fmt: skip


def _killed(streamed: bool, left: int, arguments: list[str], delay: float, worker: bool) -> None:
    with _command(streamed, left, arguments) as process:
        assert process.stdout is not None
        process.stdout.readline()
        if not left:
            time.sleep(delay)
            children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
            found = children.read_text().split() if worker and process.poll() is None else []
            with suppress(ProcessLookupError):  # it has come to its end before
                os.kill(int(found[0]) if found else process.pid, signal.SIGKILL)
        process.communicate()


def _visible(out: Path, shared: Path) -> str:
    """What is wrong with the files that bear their own names."""
    for path in out.iterdir() if out.is_dir() else ():
        if path.suffix == ".json" and path.is_file():
            json.loads(path.read_text())
    return _same(out / "result.nc", shared) if (out / "result.nc").exists() else ""


def _same(path: Path, shared: Path) -> str:
    """What differs between results and those of a run that nobody disturbed."""
    found, complete = _rows(path)
    whole = _reference(shared)
    if not complete:
        return "a result.nc that is not complete"
    wrong = [name for name in whole if found[name].tobytes() != whole[name].tobytes()]
    return f"other values: {wrong}" if wrong else ""


def _rows(path: Path) -> tuple[dict[str, np.ndarray], bool]:
    import h5py

    with h5py.File(path) as file:
        (table,) = file.values()
        rows = {name: values[:] for name, values in table.items() if values.dtype.kind != "O"}
        return rows, bool(table.attrs["complete"])


@cache
def _reference(shared: Path) -> dict[str, np.ndarray]:
    out = shared / f"reference_{os.getpid()}"
    process = _command(False, 0, ["run", str(shared / "case.toml"), "--out", str(out)])
    _, error = process.communicate()
    assert process.returncode == 0, error
    return _rows(out / "result.nc")[0]
