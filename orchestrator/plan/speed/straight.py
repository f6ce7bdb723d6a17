"""Which operations get machine code of their own (`loop/straight/`), and when a run is worth it: by what that saves a
cycle, and what it costs.

A cycle that it knows whole is one function. Of another, each segment has one: operations of one instant, one behind the
other, with nothing between them where a run goes back or on, where steps are chosen or events looked for.

Nothing is measured for it, so that the same run does the same on every machine. It is made where a run has gone on so
long that it would have paid: whoever stops a moment later has lost no more than he had spent before.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from ...errors import counted
from ...loop.operations import GET, SET, WORK
from ...loop.straight.calls import can_exchange
from ...loop.straight.text import COVERED, Segments
from ..plan import Plan
from .fused import gone_on_with
from .together import given, internal, together

MOST = 256  # operations; beyond that it is no quicker than what looks them up
LEAST = 2  # operations of a segment
SAVED = 5e-9  # s an operation
LOADING = 0.1  # s, and what loads it
COMPILING = 0.05, 2e-3  # s, and for each operation


@dataclass(frozen=True)
class Worth:
    """Behind how many cycles it pays to load what was compiled before, and to compile it; `why_not`: it never does.
    `segments`: what it is made for, empty where that is whole cycles; `operations`: how many these are."""

    operations: int
    segments: Segments = ()
    why_not: str = ""

    @property
    def to_load(self) -> int:
        """Cycles that must have been done."""
        return round(LOADING / (SAVED * self.operations))

    @property
    def to_compile(self) -> int:
        """The same where nobody has compiled it."""
        return round((LOADING + self.compiling) / (SAVED * self.operations))

    @property
    def compiling(self) -> float:
        """How long that takes, about [s]."""
        return COMPILING[0] + COMPILING[1] * self.operations


def worth_of(plan: Plan) -> Worth:
    """That of a plan's cycle."""
    known = _known(plan)
    if all(known) and not gone_on_with(plan.cycle):
        segments: Segments = ()
        count = len(known)
    else:
        segments = tuple(_segments(plan, known))
        count = sum(last - first for first, last in segments)
        if not segments:
            return Worth(1, why_not="every operation is looked up")
    why = f"{count} operations, {MOST} at most are written one behind the other" if count > MOST else ""
    return Worth(max(count, 1), segments, why)


def _known(plan: Plan) -> list[bool]:
    """Of each operation whether it has a text."""
    inside, names = internal(plan), list(plan.system.components)
    exchanged = {
        (code, k): all(can_exchange(code, kind.code) for kind, _ in together(plan, name, side))
        for k, name in enumerate(names)
        for code, side in ((SET, given(plan, name, inside)), (GET, plan.layout.exchanged(name)[1]))
    }
    return [
        code in COVERED and exchanged.get((code, component), True) and not (code == WORK and plan.adaptive)
        for code, component in plan.cycle[:, (0, 2)].tolist()
    ]


def _segments(plan: Plan, known: list[bool]) -> Iterator[tuple[int, int]]:
    """From where to where operations are known, of one instant, and nobody goes on in their midst."""
    ticks, entered = plan.cycle[:, 1].tolist(), gone_on_with(plan.cycle)
    ends = [m for m in range(1, len(known)) if known[m] != known[m - 1] or ticks[m] != ticks[m - 1] or m in entered]
    for first, last in pairwise([0, *ends, len(known)]):
        if known[first] and last - first >= LEAST:
            yield first, last


def straight_words(plan: Plan) -> list[str]:
    """What becomes of a plan."""
    worth = worth_of(plan)
    if worth.why_not:
        return ["", f"machine code of its own: none ({worth.why_not})"]
    cycles, load, compiled = plan.clock.cycles, worth.to_load, worth.to_compile
    made = counted(worth.operations, "operation")
    if worth.segments:
        made = f"{worth.operations} of {len(plan.cycle)} operations, in {counted(len(worth.segments), 'segment')}"
    costs = f"{made}; loaded in {LOADING:g} s, compiled once in {worth.compiling:.2g} s"
    if cycles <= load:
        said = f"not in this run of {counted(cycles, 'cycle')}, it pays from {load} on"
    elif cycles <= compiled:
        said = f"behind {load} of {counted(cycles, 'cycle')}, if it was compiled before"
    else:
        said = f"behind {load} of {counted(cycles, 'cycle')}, or behind {compiled} where it is compiled"
    return ["", f"machine code of its own: {said} ({costs})"]
