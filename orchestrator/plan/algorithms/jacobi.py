"""All at once: an input takes values of the beginning of its step; means excepted, they need the whole interval."""

from __future__ import annotations

from ..design import Design
from ..schedule.schedule import Schedule
from .base import Algorithm


class Jacobi(Algorithm):
    """One pass, inputs from the beginning of each step."""

    name = "jacobi"
    parallel = True
    one_pass = True
    takes_events = True

    def explanation(self) -> str:
        return "all at once, inputs from the beginning of the step"

    def schedule(self, design: Design) -> Schedule:
        return Schedule(design)
