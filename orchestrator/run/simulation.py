"""One run of a plan from its beginning to its stop."""

from __future__ import annotations

from collections.abc import Callable

from ..plan.plan import Plan
from ..results.tables import Run, require_complete
from .session.session import Session

__all__ = ["Run", "require_complete", "simulate"]


def simulate(
    plan: Plan, interpreted: bool = False, progress: Callable[[float], None] | None = None, fuses: bool = True
) -> Run:
    """Run a plan from its start to its stop.

    `interpreted` executes the same plan in plain Python, bitwise equal and slow; without `fuses` one operation after
    the other, bitwise equal too. `progress` is called now and then
    with the time reached [s]. A failing FMU, a value that is not finite and Ctrl-C end the run early; the tables
    hold what was computed and `failure` says who, what and when. Raises FmuError before the start.
    """
    with Session(plan, interpreted, fuses=fuses) as session, session.stop_requests.heard():
        session.advance(progress=progress)
        return session.run()
