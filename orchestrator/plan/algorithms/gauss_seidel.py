"""One after the other in an order: an input is formed just before its step, from the latest values."""

from __future__ import annotations

from ...system.connection import Connection
from ..design import Design
from ..schedule.schedule import Schedule
from .base import Algorithm


class GaussSeidel(Algorithm):
    """One pass, inputs from the latest values."""

    name = "gauss-seidel"
    one_pass = True
    takes_events = True

    def explanation(self) -> str:
        return "one after the other, inputs from the latest values"

    def schedule(self, design: Design) -> Schedule:
        return GaussSeidelSchedule(design)


class GaussSeidelSchedule(Schedule):
    """Every input is formed where its component steps; of one that goes ahead of others where its step begins."""

    def formed_at_beginning(self, c: Connection) -> bool:
        return self.goes_ahead(c.target[0])
