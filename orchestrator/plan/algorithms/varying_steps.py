"""What algorithms share that choose their macro step as the run goes: limits, a fine clock, open lengths."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import ceil
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from msgspec import Meta

from ...clock import Clock, common_tick, countable, seconds_text
from ...errors import InputError
from ...loop.cells import CLOCK_CELLS, MAXIMUM, MINIMUM, STEP_TICKS, STOP
from ...system.connection import Connection
from ...system.model import System
from ...system.schema.keys.values import Span
from ..capabilities import require_variable_steps
from ..schedule.formulas import Choice
from ..schedule.layout import Layout
from ..schedule.schedule import Schedule
from .base import Algorithm, LoopArrays, only_hold

if TYPE_CHECKING:
    from ..plan import Plan

RESOLUTION = 1000  # ticks in the smallest step, at least

# Settings that every such algorithm has.
Smallest = Annotated[
    Span | None, Meta(description="smallest macro step; a hundredth of the period where nothing is stated")
]
Largest = Annotated[Span | None, Meta(description="largest macro step; a hundred periods where nothing is stated")]


class VaryingSteps(Algorithm):
    """All components take the same macro step, the first of them as long as their period.

    Settings have `minimum` and `maximum`: a hundredth and the hundredfold of the period where nothing is stated.
    """

    steps_vary = True
    why_hold: ClassVar[str]  # why another transfer than `hold` has no meaning

    def limits(self, system: System) -> tuple[Fraction, Fraction]:
        """Smallest and largest macro step [s]."""
        period = next(iter(system.components.values())).period
        return self.settings.minimum or period / 100, self.settings.maximum or 100 * period

    def check(self, system: System) -> None:
        """Every FMU takes steps of any length."""
        for component in system.components.values():
            require_variable_steps(component, f"algorithm '{self.name}'")

    def samplers(self, system: System) -> tuple[str, ...]:
        """None: all components step together."""
        return ()

    def transfer(
        self, system: System, clock: Clock, c: Connection, samplers: tuple[str, ...], leaders: tuple[str, ...]
    ) -> Choice:
        return only_hold(c, f"algorithm '{self.name}' {self.why_hold}", "all components take the same step")

    def clock(self, system: System) -> Clock:
        """A fine tick; the common period is the first step. Raises InputError where there is no such clock."""
        periods = {name: component.period for name, component in system.components.items()}
        first = next(iter(periods.values()))
        minimum, maximum = self.limits(system)
        where = f"({system.path.name})"
        if len(set(periods.values())) > 1:
            shown = ", ".join(f"{name} {seconds_text(period)}" for name, period in periods.items())
            raise InputError(
                f"algorithm '{self.name}' steps all components together, so they need one period, the first step; "
                f"there are {shown} {where}"
            )
        self.require_measure(system)
        if not minimum <= first <= maximum:
            raise InputError(
                f"{self.heading}: the period {seconds_text(first)} is the first step and must be between minimum "
                f"{seconds_text(minimum)} and maximum {seconds_text(maximum)} {where}"
            )
        fine = Fraction(1)
        while fine * RESOLUTION > minimum:
            fine /= 10
        start, stop = system.start, system.stop
        tick = common_tick((fine, first, minimum, maximum, start, stop)) / self.even
        if not countable(tick, start, stop):
            largest = seconds_text(max(abs(start), abs(stop)))
            raise InputError(
                f"no tick as fine as {seconds_text(fine)} counts exactly to {largest}; "
                f"take a larger minimum step {where}"
            )
        ticks = int(first / tick)
        return Clock(
            tick.numerator, tick.denominator, dict.fromkeys(periods, ticks), int((stop - start) / tick), ticks,
            int(start / tick),
        )  # fmt: skip

    def require_measure(self, system: System) -> None:
        """Raise InputError where there is nothing by which steps could be judged."""

    def extend(self, system: System, clock: Clock, order: tuple[str, ...], choices: Mapping[Connection, Choice],
               layout: Layout) -> None:  # fmt: skip
        """Signals of the step controller, one behind the other: the instant, the step, and what it was judged by."""
        tick = seconds_text(clock.seconds(1))
        since = f" from {seconds_text(system.start)} on" if system.start else ""
        layout.extra("tick", "1", f"the instant in ticks of {tick}{since}", clock.hyperperiod)
        layout.extra("step", "s", "length of the step that ends now", clock.hyperperiod)
        layout.extra("indicator", "1", "error indicator of that step, 1 at the tolerance", clock.hyperperiod)

    def arrays(self, plan: Plan) -> LoopArrays:
        tick = plan.clock.seconds(1)
        minimum, maximum = self.limits(plan.system)
        clock = np.zeros(CLOCK_CELLS, dtype=np.int64)
        clock[STEP_TICKS], clock[STOP] = min(plan.clock.hyperperiod, plan.clock.stop), plan.clock.stop
        clock[MINIMUM], clock[MAXIMUM] = ceil(minimum / tick), int(maximum / tick)
        return LoopArrays(clock, np.zeros(3), np.zeros(1))

    def figures(self, values: Callable[[str], np.ndarray]) -> dict[str, Any]:
        step = values("step")[1:]
        return {"step_min_s": float(np.min(step)), "step_max_s": float(np.max(step))} if len(step) else {}


class VaryingSchedule(Schedule):
    """A Jacobi step of all components; the operations leave its length open (0), the loop knows it."""

    def length(self, name: str, start: int) -> int:
        return 0  # the loop's own

    def counter(self, tick: int) -> int:
        return 0  # the loop's own instant

    def duration(self, name: str, start: int) -> float:
        return 0.0  # the loop's own
