"""Keeping pace with the clock on the wall: deadlines that do not drift, and how late each of them was kept.

The deadline of a tick is ORIGIN + (tick - ORIGIN_TICK) NANOSECONDS / PER_TICKS, whatever happened before it. All cells
are those of `control`, see `cells.py`.
"""

from __future__ import annotations

import numpy as np

from .calls import read_clock, sleep_until
from .cells import (
    BINS,
    CAUSES,
    DEADLINES,
    HISTOGRAM,
    LATE,
    LATENESS,
    MARKED,
    MISSED,
    NANOSECONDS,
    ORIGIN,
    ORIGIN_TICK,
    PARTS,
    PER_TICKS,
    POLICY,
    READ_CLOCK,
    SECONDS,
    SKIP,
    SLEEP,
    SLOWEST,
    SLOWEST_TIME,
    STOP_LATE,
    WAITING,
    WORST,
    WORST_COMPONENT,
    WORST_TICK,
)
from .lives import compilable

WENT_ON = 0  # what `keep_pace` returns beside WAITING and LATE
LONGEST_SLEEP = 20_000_000  # ns, with the loop: who waits longer is to hear Ctrl-C
SECOND = 1_000_000_000  # ns


@compilable
def clock_now(control: np.ndarray) -> int:
    """The clock on the wall [ns]."""
    read_clock(control[READ_CLOCK], control.ctypes.data + 8 * SECONDS)
    return control[SECONDS] * SECOND + control[PARTS]  # type: ignore[no-any-return]


@compilable
def mark(control: np.ndarray, component: int) -> None:
    """A component has made its step: how long that took counts, should the next deadline be missed."""
    now = clock_now(control)
    if now - control[MARKED] > control[SLOWEST_TIME]:
        control[SLOWEST_TIME], control[SLOWEST] = now - control[MARKED], component
    control[MARKED] = now


@compilable
def deadline(control: np.ndarray, tick: int) -> int:
    """When a tick is due [ns]."""
    ahead = (tick - control[ORIGIN_TICK]) * control[NANOSECONDS]
    return control[ORIGIN] + ahead // control[PER_TICKS]  # type: ignore[no-any-return]


@compilable
def keep_pace(control: np.ndarray, tick: int) -> int:
    """Wait for the deadline of a tick and note how late that was: WENT_ON; WAITING if it is not over yet, and is to be
    asked for again; LATE where a missed deadline ends the run.

    A deadline is missed if the steps before it were not done in time.
    """
    due, now = deadline(control, tick), clock_now(control)
    missed = now > due
    if not missed:
        if due - now > LONGEST_SLEEP:
            return WAITING
        control[SECONDS], control[PARTS] = due // SECOND, due % SECOND
        if sleep_until(control[SLEEP], control.ctypes.data + 8 * SECONDS) != 0:
            return WAITING
        now = clock_now(control)
    late = max(now - due, 0)
    control[DEADLINES] += 1
    control[LATENESS] += late
    edge, k = 1000, 0
    while late >= edge and k < BINS - 1:
        k += 1
        edge = edge * 5 // 2 if k % 3 == 2 else edge * 2
    control[HISTOGRAM + k] += 1
    if late > control[WORST]:
        control[WORST], control[WORST_TICK] = late, tick
        control[WORST_COMPONENT] = control[SLOWEST] if missed else -1
    slowest = control[SLOWEST]
    control[MARKED], control[SLOWEST_TIME], control[SLOWEST] = now, 0, -1
    if missed:
        control[MISSED] += 1
        control[CAUSES + 1 + slowest] += 1
        if control[POLICY] == STOP_LATE:
            return LATE
        if control[POLICY] == SKIP:
            control[ORIGIN] += late
    return WENT_ON
