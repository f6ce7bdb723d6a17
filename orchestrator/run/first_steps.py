"""The first steps of a plan, for nothing but what they tell."""

from __future__ import annotations

from ..plan.plan import Plan
from .blocks.workers import ENOUGH
from .session.session import Session


def first_steps(plan: Plan, run: float = 0.2) -> str:
    """What the first steps of a plan with workers = "auto" take, and what is decided, in words; the FMUs are loaded
    for it. Raises FmuError or InputError if the start cannot be reached."""
    with Session(plan) as session:
        last = -(-plan.clock.stop // plan.cycle_ticks)
        workers = session.loop.workers
        while workers and not workers.said and session.at.cycle < last and not session.over and session.at.wall < run:
            session.advance(cycles=min(ENOUGH, last - session.at.cycle))
        return workers.said if workers else ""
