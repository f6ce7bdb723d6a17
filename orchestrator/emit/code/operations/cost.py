"""What an operation costs at most, counted from the plan."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log2

from ....loop.formulas import FORMULAS, arithmetic
from ....loop.operations import (
    ACCUMULATE_ON,
    ADVANCE,
    AT_AN_INSTANT,
    CONTROL,
    ESTIMATE,
    FAULT,
    FIT,
    GAUGE,
    GET,
    HALVE,
    ITERATE,
    NUMBER,
    PAUSE,
    RECORD,
    REPEAT,
    RESTORE,
    REWIND,
    SAMPLE,
    SAVE,
    SERIES,
    SET,
    STEP,
    STEP_ON,
    WATCH,
    WORK_ON,
)
from ..exchange import Names

Row = tuple[int, ...]  # an operation by its columns


@dataclass(frozen=True)
class Cost:
    """At most so many: operations on floating-point numbers, calls of FMI functions, cells that are moved."""

    arithmetic: int = 0
    calls: int = 0
    moves: int = 0

    def __add__(self, other: Cost) -> Cost:
        return Cost(self.arithmetic + other.arithmetic, self.calls + other.calls, self.moves + other.moves)

    def times(self, factor: int) -> Cost:
        """As often as that."""
        return Cost(self.arithmetic * factor, self.calls * factor, self.moves * factor)

    def most(self, other: Cost) -> Cost:
        """What is enough for either."""
        return Cost(max(self.arithmetic, other.arithmetic), max(self.calls, other.calls), max(self.moves, other.moves))


def cost_of(names: Names, row: Row) -> Cost:
    """What an operation costs at most."""
    code, _, component, a, _, _, q, k = row
    if code in (SET, GET):
        name = names.components[component]
        blocks = names.given(name) if code == SET else names.taken(name, a == AT_AN_INSTANT)
        return Cost(0, len(blocks), sum(block.size for block in blocks))
    if code in (STEP, STEP_ON):
        return Cost(8, 1)
    if code in (SAVE, RESTORE):
        return Cost(0, int(component >= 0), a if component < 0 else 0)
    if code in (GAUGE, CONTROL, ITERATE, ESTIMATE):
        return Cost({GAUGE: 12, CONTROL: 200, ITERATE: 12 * q, ESTIMATE: 200 + 6 * q}[code])
    if code in (RECORD, PAUSE, REWIND, REPEAT, HALVE, ADVANCE):
        return Cost()  # of the program, and of events, not of the system
    if code in (SERIES, SAMPLE):
        rows = int(names.plan.coefficients[k])
        return Cost(2 * ceil(log2(rows + 1)) + (8 * rows + 16) * (code == SERIES), 0, 1)
    if code in FORMULAS:
        return Cost(arithmetic(code) + (code == NUMBER), 0, 1)
    return Cost({FIT: 5 + 2 * q, ACCUMULATE_ON: 5, WORK_ON: 6, WATCH: 2, FAULT: 40}[code], 0, 1)
