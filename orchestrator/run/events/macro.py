"""Events of a system whose steps are repeated or vary in length: they act where a macro step begins."""

from __future__ import annotations

from fractions import Fraction
from math import ceil

import numpy as np

from ...loop import cells
from ...loop.solvers.step_control import fitted
from ...plan.plan import Plan
from ..memory.memory import Memory
from ..recording.happened import Happened
from .scenario import Scenario


class MacroSteps:
    """`clock`: that of steps that vary, see `loop/cells`; these end where an event is known to come."""

    def __init__(
        self, plan: Plan, memory: Memory, control: np.ndarray, clock: np.ndarray, scenario: Scenario, happened: Happened
    ) -> None:
        self.plan, self.memory, self.control, self.clock = plan, memory, control, clock
        self.scenario, self.happened = scenario, happened
        self.slots = plan.recorded_slots
        self.aim()
        if plan.adaptive:
            clock[cells.STEP_TICKS] = fitted(clock, int(clock[cells.STEP_TICKS]), plan.algorithm.even)

    def begin(self) -> None:
        """What is there from the start, or happens behind the initialization."""
        due = self.scenario.next_instant()
        if self.scenario.words or (due is not None and due <= self.plan.clock.seconds(self.plan.clock.start)):
            self.act(0)

    def act(self, tick: int) -> None:
        """Do what is due at an instant [ticks from the start]. Raises RunError if the disk refuses its rows."""
        before = self.memory.z[self.slots]
        words = self.scenario.happen(self.plan.clock.seconds(self.plan.clock.start + tick))
        self.aim()
        if self.plan.adaptive and tick:  # what comes is not what the last steps were chosen by
            step = int(self.clock[cells.STEP_TICKS])
            first = self.plan.clock.hyperperiod if self.scenario.acted or not step else step
            self.clock[cells.STEP_TICKS] = fitted(self.clock, first, self.plan.algorithm.even)
        if words:
            time = self.plan.clock.time(tick)
            self.happened.add(time, "", before)
            self.happened.add(time, words, self.memory.z[self.slots])

    def aim(self) -> None:
        """Where the loop is to return next; steps that vary end there."""
        clock, time = self.plan.clock, self.scenario.next_instant()
        following = cells.NEVER if time is None else ceil(Fraction(time) / clock.seconds(1)) - clock.start
        self.control[cells.EVENT_AT] = clock.start + following if following < cells.NEVER else cells.NEVER
        if self.plan.adaptive:
            self.clock[cells.STOP] = min(clock.stop, following)
