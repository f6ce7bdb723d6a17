"""The pace of one run: the cells by which the loop waits, set from what is asked for and read for a report."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction

import numpy as np

from ...errors import InputError
from ...loop import cells
from ...loop.pacing import LONGEST_SLEEP, deadline
from ...plan.plan import Plan
from ...results.lateness import ELSEWHERE, Lateness
from .pace import FASTEST, Pace, require_factor
from .wall import SECOND, clock_functions, now

FINEST = 10**6  # the largest denominator of nanoseconds per tick
POLICIES = {"warn": cells.WARN, "stop": cells.STOP_LATE, "skip": cells.SKIP}


class Pacer:
    """Waits with a run. It counts from the first step on: `rebase` begins anew from where the run is."""

    def __init__(self, plan: Plan, pace: Pace, control: np.ndarray) -> None:
        if not plan.deadlines:
            raise InputError("this plan has no deadlines: make it with a pace")
        self.plan, self.pace, self.control = plan, pace, control
        control[[cells.READ_CLOCK, cells.SLEEP]] = clock_functions()
        control[cells.POLICY] = POLICIES[pace.policy]
        control[cells.SLOWEST] = -1
        self._factor = pace.factor
        self._begun = False

    @property
    def factor(self) -> float:
        """Simulated seconds in one second; another one counts from now on. Raises InputError for one that is none."""
        return self._factor

    @factor.setter
    def factor(self, value: float) -> None:
        require_factor(value)
        self._factor = value
        self.rebase()

    def rebase(self) -> None:
        """The next step begins now, whatever the clock on the wall was before: after a pause, or a jump."""
        self._begun = False

    @contextmanager
    def at_ease(self) -> Iterator[None]:
        """Within, no deadline is waited for or counted; the pace begins anew behind it."""
        counted, factor = self.control[cells.WORST :].copy(), self._factor
        self.factor = FASTEST
        try:
            yield
        finally:
            self.control[cells.WORST :] = counted
            self.factor = factor

    def enter(self, tick: int) -> None:
        """The loop is about to go on from a tick."""
        control, wall = self.control, now()
        if not self._begun:
            self._begun = True
            each = self.plan.clock.seconds(1) * SECOND / Fraction(self._factor).limit_denominator(FINEST)
            each = each.limit_denominator(FINEST)
            control[[cells.NANOSECONDS, cells.PER_TICKS]] = each.numerator, each.denominator
            control[[cells.ORIGIN, cells.ORIGIN_TICK]] = wall, tick
            control[cells.SLOWEST_TIME] = 0
        elif wall - control[cells.MARKED] > control[cells.SLOWEST_TIME]:  # the program had the most time
            control[cells.SLOWEST_TIME], control[cells.SLOWEST] = wall - control[cells.MARKED], -1
        control[cells.MARKED] = wall

    def behind(self, tick: int) -> float:
        """How long ago the deadline of a tick was over [s]; 0 if it is yet to come, or nothing has begun."""
        return max(now() - int(deadline(self.control, tick)), 0) / SECOND if self._begun else 0.0

    def wait(self, tick: int) -> float:
        """Sleep until shortly before the deadline of a tick, a piece at a time, as long as nobody asks to stop; how
        long that was [s]."""
        control, begin = self.control, now()
        until = int(deadline(control, tick)) - LONGEST_SLEEP // 2
        while (wall := now()) < until and not control[cells.STOP_REQUEST]:
            time.sleep(min(until - wall, LONGEST_SLEEP) / SECOND)
        return (now() - begin) / SECOND

    @contextmanager
    def over(self) -> Iterator[None]:
        """Deadlines that come meanwhile were waited for before: they are neither waited for nor counted again."""
        kept, begun, self._begun = self.control[cells.CONTROL_CELLS :].copy(), self._begun, True
        self.control[[cells.ORIGIN, cells.NANOSECONDS, cells.PER_TICKS, cells.POLICY]] = 0, 0, 1, cells.WARN
        try:
            yield
        finally:
            self.control[cells.CONTROL_CELLS :], self._begun = kept, begun

    def lateness(self) -> Lateness:
        """How late its deadlines were kept until now."""
        control, plan = self.control, self.plan
        names = [ELSEWHERE, *plan.system.components]
        count, worst_by = int(control[cells.DEADLINES]), int(control[cells.WORST_COMPONENT])
        causes = control[cells.CAUSES :].tolist()
        missed_before = int(control[cells.MISSED])
        return Lateness(
            self._factor,
            count,
            missed_before,
            int(control[cells.LATENESS]) / SECOND / max(count, 1),
            int(control[cells.WORST]) / SECOND,
            plan.clock.time(int(control[cells.WORST_TICK])),
            names[worst_by + 1] if missed_before and worst_by >= 0 else "",
            dict(zip(edges(), control[cells.HISTOGRAM : cells.CAUSES].tolist(), strict=True)),
            {name: number for name, number in zip(names, causes, strict=True) if number},
        )


def edges() -> list[float]:
    """The upper bounds of the histogram [s]: 1, 2, 5, 10 us and so on, the last one open."""
    steps = [round(m * 10.0**k * 1e-6, 9) for k in range(7) for m in (1, 2, 5)]
    return [*steps[: cells.BINS - 1], math.inf]


def room_for(plan: Plan) -> int:
    """Cells of `control` in all, for a plan that keeps pace."""
    return cells.CAUSES + 1 + len(plan.system.components)
