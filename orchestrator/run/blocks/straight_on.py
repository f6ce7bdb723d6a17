"""Machine code for the cycles of one run: when it is made, and with whose addresses it is called."""

from __future__ import annotations

from importlib.util import find_spec

import numpy as np

from ...loop.machine.frame import Loop
from ...plan.plan import Plan
from ...plan.speed.straight import Worth, worth_of
from .program import Program, as_it_is, in_segments

PAYS, ALWAYS, NEVER = "pays", "always", "never"


class StraightOn:
    """Of a plan; `when`: PAYS, once it has (see `plan/speed/straight.py`), ALWAYS from the beginning, or NEVER."""

    def __init__(self, plan: Plan, when: str = PAYS) -> None:
        self.plan = plan
        self._worth: Worth | None = None
        self._text: str | None = None
        self._waiting = when == PAYS
        self._on, self._compiles = when == ALWAYS, when == ALWAYS
        self._done, self._at = 0, 0  # cycles, however often the run went back
        # Where LLVM is there, which comes with the compiler; what it pays for is only looked at where it might.
        self._next = 10_000 if self._waiting else 0
        if self._on:
            self._worth = worth_of(plan)
            self._on = not self._worth.why_not and find_spec("llvmlite") is not None

    def is_time(self, cycle: int) -> bool:
        """Whether there may be code from now on that there was not before; the run is at a cycle."""
        if not self._waiting:
            return False
        self._done += max(cycle - self._at, 0)
        self._at = cycle
        if self._done < self._next:
            return False
        if self._worth is None:
            self._worth = worth_of(self.plan)
            if self._worth.why_not or find_spec("llvmlite") is None:
                self._waiting = False
                return False
            self._next = self._worth.to_load
        if self._done >= self._worth.to_compile:
            self._on, self._compiles, self._waiting = True, True, False
            return True
        if self._done >= self._next and not self._on:
            self._on, self._next = True, self._worth.to_compile
            return True
        return False

    def program(self, components: np.ndarray, blocks: np.ndarray, waits: bool) -> Program | None:
        """What does a cycle with these tables; None where it is not to be used, or not there."""
        if not self._on or self._worth is None:
            return None
        from ...loop.straight.code import straight_code
        from ...loop.straight.text import Straight

        plan, segments = self.plan, self._worth.segments
        recorded = [group.slots for group in plan.groups]
        written = Straight(plan.cycle, components, blocks, recorded, segments, plan.adaptive)
        text = written.whole_text()
        self._text = self._text or text
        if text != self._text:  # a component has asked to end: the rest is not worth another one
            return None
        found = straight_code(text, self._compiles)
        if found is None:
            return None
        addresses = written.addresses(components, blocks)
        if segments:
            return in_segments(plan.cycle, segments, found, addresses)
        return as_it_is(plan.cycle)._replace(code=Loop(found.function, found, waits, addresses, found.one))
