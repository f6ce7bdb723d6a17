"""What several threads gain where equal FMUs step at once, and that they cost nothing where they gain none."""

from __future__ import annotations

import ctypes
import statistics
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....errors import RunError
from ....plan.plan import make_plan
from ....run.session.session import Session
from ....system.file.reader import load_system
from ....system.model import System
from ...sweep.workers.workers import cores
from ..fmus.native import SOURCES, description2, native_fmu

STEPS = (1.0, 10.0, 50.0, 200.0)  # us of a step of each
LONG = 50.0  # us, from which on a call from Python counts for nothing beside the step
FMUS = 4
PIECE = 0.004  # s of a run that is measured at once
PIECES, QUICK, WARM = 400, 100, 30
TRIED = 20_000  # multiplications by which they are measured


def busy(target: Path, work: int, **defines: object) -> Path:
    """An FMI 2.0 FMU with an input u and an output y, whose step takes `work` multiplications."""
    ends = (("u", "input", "", 'start="0"'), ("y", "output", ' initial="calculated"', ""))
    variables = [
        f'<ScalarVariable name="{name}" valueReference="{k}" causality="{causality}" variability="continuous"'
        f"{more}><Real {start}/></ScalarVariable>"
        for k, (name, causality, more, start) in enumerate(ends)
    ]
    xml = description2(target.stem, variables, [2])
    return native_fmu(target, [SOURCES / "busy.c"], xml, 2, {"WORK": work, **defines})


def busy_ring(folder: Path, work: int, count: int = FMUS, stop: str = "1 s", **extra: str) -> Path:
    """A system file of such FMUs in a ring, all at once (Jacobi); `extra`: other FMU files by component."""
    fmu = folder / f"busy{work}.fmu"
    if not fmu.is_file():
        busy(fmu, work)
    wires = "".join(f'  "c{k}.y -> c{(k + 1) % count}.u",\n' for k in range(count))
    tables = "".join(
        f'[components.c{k}]\nfmu = "{extra.get(f"c{k}", fmu.name)}"\nperiod = "1 ms"\n' for k in range(count)
    )
    path = folder / f"busy_ring_{work}.toml"
    path.write_text(
        f'format = 2\nstop_time = "{stop}"\nalgorithm = "jacobi"\nconnections = [\n{wires}]\n{tables}', encoding="utf-8"
    )
    return path


def worker_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds of a macro step on one thread, with workers = "auto" and with one for each processor: pieces of runs
    in turns, recording on; the median and the fastest of all.

    With each row comes the share of the work that is done. Raises RunError without a C compiler or if a run fails.
    """
    pieces = QUICK if quick else PIECES
    each = _fastest_step(load_system(str(busy_ring(folder, TRIED, stop="1 s")))) / TRIED
    for k, wanted in enumerate(STEPS):
        cycles = max(1, round(PIECE / (FMUS * 1e-6 * wanted)))
        path = busy_ring(folder, max(1, round(1e-6 * wanted / each)), stop=f"{(pieces + WARM) * cycles} ms")
        system = load_system(str(path))
        found, words = _measured(system, cycles, pieces)
        row: dict[str, Any] = {"fmus": FMUS, "step_us": wanted, "processors": cores(), "runs": pieces, "said": words}
        row["bare_gain"] = bare_gain(system, max(1, round(0.01 / (1e-6 * wanted)))) if wanted >= LONG else None
        for name, values in found.items():
            row |= {f"{name}_us": 1e6 * statistics.median(values), f"{name}_fastest_us": 1e6 * min(values)}
        yield (k + 1) / len(STEPS), row


def bare_gain(system: System, calls: int, repeats: int = 9) -> float:
    """How many times as much two threads do that share nothing, by bare calls of two of the FMUs: what this machine
    allows at most, at this time."""
    with Session(make_plan(replace(system, workers="1"))) as session:
        kind = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int)
        steps = [(kind(one.address("fmi2DoStep")), one.pointer) for one in session.instances.values()][:2]

        def work(number: int) -> None:
            step, instance = steps[number]
            for _ in range(calls):
                step(instance, 0.0, 1e-3, 1)

        seconds: dict[int, list[float]] = {1: [], 2: []}
        for _ in range(repeats):
            for count, found in seconds.items():
                threads = [threading.Thread(target=work, args=(k,)) for k in range(count)]
                begin = time.perf_counter()
                for thread in threads:
                    thread.start()
                for thread in threads:
                    thread.join()
                found.append(time.perf_counter() - begin)
    return 2 * statistics.median(seconds[1]) / statistics.median(seconds[2])


def _measured(system: System, cycles: int, pieces: int) -> tuple[dict[str, list[float]], str]:
    """Seconds of a macro step in each piece, by the way in which it is run, and what "auto" came to."""
    ways = {"one": "1", "auto": "auto", "all": str(max(cores(), 2))}
    with ExitStack() as stack:
        sessions = {
            name: stack.enter_context(Session(make_plan(replace(system, workers=workers))))
            for name, workers in ways.items()
        }
        found: dict[str, list[float]] = {name: [] for name in ways}
        for piece in range(pieces + WARM):
            for name, session in sessions.items():
                before = session.at.wall
                session.advance(cycles=cycles)
                if session.failure:
                    raise RunError(session.failure)
                if piece >= WARM:
                    found[name].append((session.at.wall - before) / cycles)
        workers = sessions["auto"].loop.workers
        return found, workers.said if workers else ""


def _fastest_step(system: System) -> float:
    """Seconds of a step of one of the FMUs, undisturbed."""
    with Session(make_plan(system)) as session:
        found = []
        for _ in range(100):
            before = session.at.wall
            session.advance(cycles=10)
            found.append((session.at.wall - before) / 10 / FMUS)
        return min(found)
