"""What a component costs as its size grows, native and as its compiled kernel: cases that its own package names.

The processor time of the thread is taken, which neighbours on the machine lengthen least; both in turns.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

from ....errors import InputError
from ....plan.plan import make_plan
from ....system.file.reader import load_system
from ..peers.floor import Floor

GROUP = "rovbrush.sizes"  # of entry points
ROUNDS, QUICK = 11, 3
SYSTEM = """
format = 2
description = "one component by itself"
stop_time = "1 s"
record = []
[components.x]
fmu = "{fmu}"
period = "{period} s"
parameters = {{ {parameters} }}
inputs = {{ {inputs} }}
"""


def size_rows(folder: Path, native: Path, quick: bool) -> Iterator[tuple[float, dict[str, Any]]]:
    """For each case microseconds per step, and the mean of the output that counts, with the share that is done.

    An entry point of GROUP is a function that returns cases: component, words, parameters, inputs,
    the output that counts, period [s], steps before anything is measured and of a round, and the kernel by itself.
    Raises InputError where there is none.
    """
    found = [case for entry in entry_points(group=GROUP) for case in entry.load()()]
    if not found:
        raise InputError(
            f"no installed package names cases for this part (entry points of the group {GROUP}); an installation that "
            f"is older than its sources names none: install it again"
        )
    rounds = QUICK if quick else ROUNDS
    for number, case in enumerate(found):
        alone = _alone(folder, native / f"{case.component}.fmu", case)
        alone.seconds(case.before)
        kernel = case.kernel()
        kernel(case.before)
        costs: dict[str, list[float]] = {"native_us": [], "kernel_us": []}
        counted = []
        for _ in range(rounds):
            costs["native_us"].append(_seconds(alone, case.steps))
            counted.append(alone.instances["x"].get(case.counts))
            costs["kernel_us"].append(kernel(case.steps))
        alone.close()
        row = {key: 1e6 * statistics.median(taken) for key, taken in costs.items()}
        yield (
            (number + 1) / len(found),
            {"component": case.component, "case": case.words, "runs": rounds, "counts": case.counts,
             "count": statistics.mean(counted), **row},
        )  # fmt: skip


def _alone(folder: Path, fmu: Path, case: Any) -> Floor:
    """A native FMU by itself, stepped by a compiled loop."""
    path = folder / "alone.toml"
    lists = {
        name: ", ".join(f"{key} = {value!r}" for key, value in values.items())
        for name, values in (("parameters", case.parameters), ("inputs", case.inputs))
    }
    path.write_text(SYSTEM.format(fmu=fmu.resolve().as_posix(), period=case.period, **lists))
    return Floor(make_plan(load_system(str(path))))


def _seconds(alone: Floor, steps: int) -> float:
    """Processor time of a step, as a mean over some."""
    begin = time.thread_time()
    alone.seconds(steps)
    return (time.thread_time() - begin) / steps
