"""The run that a worker keeps: its FMUs stay loaded from point to point, where that gives the same bits."""

from __future__ import annotations

import atexit
from collections.abc import Hashable

from ....errors import RovbrushError
from ....plan.plan import Plan
from ....results.summary.summary import figures
from ....run.again.again import Again, why_anew
from ....system.assigned import Values


class Kept:
    """At most one run, of the plan that was asked for last."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._again: Again | None = None
        self._anew = True
        atexit.register(self.close)

    def figures(self, key: Hashable, plan: Plan, values: Values) -> dict[str, float] | None:
        """The figures of merit of a plan with other values; None where a fresh run is to tell them, as where
        anything goes wrong. `key`: what the plan was made of."""
        if key != self._key:
            self.close()
            self._key, self._anew = key, bool(why_anew(plan))
        if self._anew:
            return None
        try:
            if self._again is None:
                self._again = Again(plan)
            return figures(self._again.run(values))
        except RovbrushError:
            self.close()
            return None

    def close(self) -> None:
        """Give the FMUs back."""
        if self._again is not None:
            self._again.close()
            self._again = None
