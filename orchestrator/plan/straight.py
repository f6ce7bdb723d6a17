"""When a run is worth machine code of its own (`loop/straight/`): by what that saves a cycle, and what it costs.

Nothing is measured for it, so that the same run does the same on every machine. It is made where a run has gone on so
long that it would have paid: whoever stops a moment later has lost no more than he had spent before.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import counted
from ..loop.operations import GET, SET
from ..loop.straight.calls import can_exchange
from ..loop.straight.text import why_not
from .design import Design
from .plan import Plan
from .together import given, internal, together

SAVED = 5e-9  # s an operation
LOADING = 0.1  # s, and what loads it
COMPILING = 0.05, 2e-3  # s, and for each operation


@dataclass(frozen=True)
class Worth:
    """Behind how many cycles it pays to load what was compiled before, and to compile it; `why_not`: it never does."""

    operations: int
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
    codes = plan.cycle[:, 0].tolist()
    why = why_not(codes)
    if plan.adaptive or plan.algorithm.saves_states:
        why = "steps that are repeated or vary"
    elif not why and not _exchanged(plan):
        why = "texts or bytes that FMUs give"
    return Worth(max(len(codes), 1), why)


def _exchanged(plan: Design) -> bool:
    """Whether all that is exchanged has a text."""
    inside = internal(plan)
    return all(
        can_exchange(code, kind.code)
        for name in plan.system.components
        for code, side in ((SET, given(plan, name, inside)), (GET, plan.layout.exchanged(name)[1]))
        for kind, _ in together(plan, name, side)
    )


def straight_words(plan: Plan) -> list[str]:
    """What becomes of a plan."""
    worth = worth_of(plan)
    if worth.why_not:
        return ["", f"machine code of its own: none ({worth.why_not})"]
    cycles, load, compiled = plan.clock.cycles, worth.to_load, worth.to_compile
    costs = (
        f"{counted(worth.operations, 'operation')}; loaded in {LOADING:g} s, compiled once in {worth.compiling:.2g} s"
    )
    if cycles <= load:
        said = f"not in this run of {counted(cycles, 'cycle')}, it pays from {load} on"
    elif cycles <= compiled:
        said = f"behind {load} of {counted(cycles, 'cycle')}, if it was compiled before"
    else:
        said = f"behind {load} of {counted(cycles, 'cycle')}, or behind {compiled} where it is compiled"
    return ["", f"machine code of its own: {said} ({costs})"]
