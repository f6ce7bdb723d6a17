"""What keeping pace costs beside waiting, and how well deadlines are kept here and now."""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ....plan.plan import Plan, make_plan
from ....run.pacing.pace import FASTEST, Pace
from ....run.session.session import Session
from ....system.assemble import assemble
from ..fmus.native import ring

RUNS, QUICK = 9, 3
STEPS = 20_000  # of 1 ms, in a run without waiting
WATCHED, WATCHED_QUICK = 10, 2  # s of real time


def pacing_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds of a macro step of four native FMUs without a pace and with deadlines that are all over already, so
    that nobody waits; and how late deadlines 1 ms apart are kept in real time. Medians of pairs of runs.

    With each row comes the share of the work that is done.
    """
    system = assemble(str(ring(folder, 4, stop=f"{STEPS} ms")))
    plain, paced = make_plan(system), make_plan(system, "")
    pairs = []
    for _ in range(QUICK if quick else RUNS):
        pairs.append((_seconds(plain, None), _seconds(paced, Pace(FASTEST))))
    without, with_pace = (statistics.median(pair[k] for pair in pairs) for k in (0, 1))
    costs = statistics.median(b - a for a, b in pairs)
    row = {"system": "feedthrough4", "runs": len(pairs), "us_per_step": 1e6 * without / STEPS}
    row |= {"us_per_step_with_deadline": 1e6 * with_pace / STEPS, "us_per_deadline": 1e6 * costs / STEPS}
    watched = WATCHED_QUICK if quick else WATCHED
    timed = make_plan(assemble(str(ring(folder, 4, stop=f"{watched} s"))), "")
    with Session(timed, pace=Pace()) as session:
        session.advance()
        late = session.run().lateness
    assert late is not None
    row |= {"deadlines": late.deadlines, "within_2_ms": late.within(0.002), "mean_us": 1e6 * late.mean}
    yield 1.0, row | {"worst_us": 1e6 * late.worst, "missed": late.missed}


def _seconds(plan: Plan, pace: Pace | None) -> float:
    """Of wall time in a run, behind a first tenth of it that warms up."""
    with Session(plan, pace=pace) as session:
        session.advance(cycles=STEPS // 10)
        begin = time.perf_counter()
        session.advance()
        return (time.perf_counter() - begin) * STEPS / (STEPS - STEPS // 10)
