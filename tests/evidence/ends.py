"""Every way a run can end, in memory, streamed to disk and with isolated FMUs: its complete rows are there, marked.

The system is two FMUs whose steps take a millisecond each where somebody from outside ends the run. Of every run that
ends the rows are compared, bit by bit, with the first rows of one that reached its stop.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from native_build import FAULTS2, feedthrough2

NAME = "ends"
CLAIM = "however a run ends, its complete rows are in result.nc, closed and marked"
UNIT = "ways x modes"
LIMIT = 120.0  # s
SAMPLE = 0  # tests/orchestrator/run/ends/test_every_end.py tries all of them

MODES = ("in memory", "streamed", "isolated")
STOP = 0.3  # s, of what is not to be ended from outside

# The command; what would be many bytes are few where the rows go to disk, and a fault of ours comes where it is asked.
COMMAND = """
import os, signal, sys
from rovbrush.orchestrator.cli import main, progress
from rovbrush.orchestrator.results.files import writing
from rovbrush.orchestrator.run.recording import observers, recorder
progress.PLAIN_INTERVAL = 0.0
for number in (signal.SIGTERM, signal.SIGHUP):
    signal.signal(number, signal.SIG_DFL)  # which `nohup` has ignored, and that is inherited
mode, ours, *arguments = sys.argv[1:]
if mode == "streamed":
    recorder.IN_MEMORY, recorder.PIECE, recorder.CHUNK = 4000, 2000, 5
def fail(*_arguments):
    raise ZeroDivisionError("a fault of ours")
if ours == "run":
    observers.Progress.see = fail
if ours == "summary":
    writing.summarize = fail
sys.argv = ["rovbrush", *arguments]
main.program()
"""

Running = subprocess.Popen[str]


@dataclass(frozen=True)
class Way:
    """How a run ends: what the FMU does, what is done to the process, and what is expected."""

    name: str
    words: str = ""  # of the message; that of a good end is empty
    fault: str = "none"  # of FMU `a`, in the step to 40 ms
    slow: bool = False  # its steps take a millisecond each
    complete: bool = False
    act: Callable[[Running, Path], None] | None = None  # when the run is under way
    stdout: str = ""  # where it goes, if not to us
    ours: str = ""  # where a fault of ours comes
    disk: str = ""  # the size of the disk
    isolated: bool = False  # FMU `a` is, in every mode
    moved: bool = False  # the rows may be in another folder, which the message names


def _send(number: int) -> Callable[[Running, Path], None]:
    return lambda process, _out: process.send_signal(number)


def _close(process: Running, _out: Path) -> None:
    assert process.stdout is not None
    process.stdout.close()


def _delete(process: Running, out: Path) -> None:
    shutil.rmtree(out)
    process.send_signal(signal.SIGINT)


WAYS = (
    Way("stop reached", complete=True),
    Way("FMU returns error", "returned fmi2Error", "error"),
    Way("FMU returns fatal", "returned fmi2Fatal", "fatal"),
    Way("output not finite", "output y became nan", "nan"),
    Way("crash in a child", "crashed with SIGSEGV", "crash", isolated=True),
    Way("exit in a child", "ended by itself with exit code 3", "exit", isolated=True),
    Way("SIGINT", "interrupted by the user", slow=True, act=_send(signal.SIGINT)),
    Way("SIGTERM", "ended from outside (SIGTERM)", slow=True, act=_send(signal.SIGTERM)),
    Way("SIGHUP", "its terminal was closed (SIGHUP)", slow=True, act=_send(signal.SIGHUP)),
    Way("broken pipe", "printed: Broken pipe", slow=True, complete=True, act=_close),
    Way("full stdout", "printed: No space left", complete=True, stdout="/dev/full"),
    Way("full disk", "No space left on device", disk="24k", moved=True),
    Way("folder deleted", "interrupted by the user", slow=True, act=_delete),
    Way("fault of ours in the run", "unexpected ZeroDivisionError", slow=True, ours="run"),
    Way("fault of ours in the summary", "summary.json could not be made: unexpected ZeroDivisionError", complete=True,
        ours="summary"),
)  # fmt: skip
CASES = [(way, mode) for way in WAYS for mode in MODES]
COUNT = len(CASES)
FINITE = True


def prepare(folder: Path) -> None:
    """The two FMUs, quick and slow."""
    for name, defines in (("quick", {}), ("slow", {"STEP_US": 1000})):
        feedthrough2(folder / f"{name}.fmu", **defines)


def one(index: int, folder: Path) -> str:
    way, mode = CASES[index]
    return ended(way, mode, folder, folder.parent)


def ended(way: Way, mode: str, folder: Path, fmus: Path) -> str:
    """What is wrong with the rows that a run leaves in `folder` when it ends in this way; empty if nothing is."""
    code, error = _run(way, mode, folder, fmus)
    if code != (0 if way.complete and not way.words else 1):
        return f"exit code {code}: {error}"
    if way.words not in error or "Traceback" in error:
        return f"the message is: {error}"
    place = _place(error, folder) if way.moved else folder / "out"
    path = place / "result.nc"
    if not path.is_file():
        return f"no result.nc in {place}: {error}"
    if half := [p.name for p in place.iterdir() if p.name.startswith(".")]:
        return f"left half-written: {half}"
    rows, complete, groups = _rows(path)
    end = rows["time"][-1]
    if complete != (end == STOP if way.disk else way.complete):
        return f"marked complete = {complete} at {end} s"
    if not way.disk and (place / "summary.json").is_file():
        said = json.loads((place / "summary.json").read_text())["simulated_s"]
        if said != end:
            return f"the rows end at {end} s, the summary says {said}"
    if way.fault != "none" and end != 0.039:
        return f"the last complete instant is 0.039 s, the rows end at {end}"
    if len(rows["time"]) < (2 if way.act or way.disk else 1):
        return "hardly any rows"
    whole = _reference(fmus)
    wrong = [name for name in groups if rows[name].tobytes() != whole[name][: len(rows[name])].tobytes()]
    return f"other values: {wrong}" if wrong else ""


def _system(way: Way, mode: str, folder: Path, fmus: Path) -> Path:
    kind = "slow" if way.slow else "quick"
    text = f'format = 2\nstop_time = "{2 if way.slow and not way.complete else STOP} s"\nconnections = ["a.x -> b.u"]\n'
    for name in ("a", "b"):
        text += f'[components.{name}]\nfmu = "{fmus / kind}.fmu"\nperiod = "1 ms"\n'
        if mode == "isolated" or (way.isolated and name == "a"):
            text += 'isolation = "process"\n'
        if name == "a":
            text += f"parameters = {{ fault = {FAULTS2[way.fault]}, bad_at = 0.0395 }}\n"
        free = "n_in = 1, mode_in = 2, on_in = true, s_in = 'on'"
        text += f"inputs = {{ {'u = 1.5, ' if name == 'a' else ''}{free} }}\n"
    path = folder / "case.toml"
    path.write_text(text)
    return path


def _run(way: Way, mode: str, folder: Path, fmus: Path) -> tuple[int, str]:
    """Exit code and stderr of the command."""
    out, said = folder / "out", folder / "stderr"
    arguments = [mode, way.ours, "run", str(_system(way, mode, folder, fmus)), "--out", str(out)]
    environment = {**os.environ, "TMPDIR": str(folder)}
    command = [sys.executable, "-c", COMMAND, *arguments]
    if way.disk:
        out.mkdir()
        command = [*_on_a_disk(way.disk, out), *command]
    with open(way.stdout or folder / "stdout", "w") as stdout, said.open("w") as stderr:
        output = subprocess.PIPE if way.act else stdout
        process = subprocess.Popen(command, stdout=output, stderr=stderr, text=True, env=environment)
        try:
            if way.act:
                assert process.stdout is not None
                while (line := process.stdout.readline()) and not line.startswith("running"):
                    pass
                way.act(process, out)
                if not process.stdout.closed:
                    process.stdout.read()
            code = process.wait()
        finally:
            process.kill()
            process.wait()
            if process.stdout:
                process.stdout.close()
    if way.disk and (folder / "out.kept").is_dir():
        out.rmdir()
        (folder / "out.kept").rename(out)
    return code, said.read_text()


def _on_a_disk(size: str, out: Path) -> list[str]:
    """What to put before a command, for a disk of its own, which its processes see and nobody else."""
    inner = f'mount -t tmpfs -o size={size} tmpfs "$0" || exit 90; "$@"; code=$?; cp -r "$0" "$0.kept"; exit $code'
    return ["unshare", "--map-root-user", "--mount", "sh", "-c", inner, str(out)]


def _place(error: str, folder: Path) -> Path:
    """The folder that a message names for the results."""
    words = "the results went to "
    return Path(error.split(words)[1].split()[0]) if words in error else folder / "out"


def _rows(path: Path) -> tuple[dict[str, np.ndarray], bool, list[str]]:
    """The rows of the one table, whether it is marked complete, and the names in it."""
    import h5py

    with h5py.File(path) as file:
        (table,) = file.values()
        rows = {name: values[:] for name, values in table.items()}
        complete = bool(table.attrs["complete"])
    if len({len(values) for values in rows.values()}) != 1:
        raise AssertionError("columns of different lengths")
    numbers = [name for name, values in rows.items() if values.dtype.kind != "O"]
    return rows, complete, numbers


@cache
def _reference(fmus: Path) -> dict[str, np.ndarray]:
    """The rows of a run that reaches 2 s, with quick steps; those of slow ones are the same."""
    from rovbrush.orchestrator.plan.plan import make_plan
    from rovbrush.orchestrator.results.files.netcdf import datasets
    from rovbrush.orchestrator.run.simulation import simulate
    from rovbrush.orchestrator.system.assemble import assemble

    folder = fmus / f"reference_{os.getpid()}"
    folder.mkdir(exist_ok=True)
    system = assemble(str(_system(Way(""), "in memory", folder, fmus)), stop="2 s")
    (table,) = datasets(simulate(make_plan(system))).values()
    return {str(name): table[name].values for name in table.variables}
