"""How a run keeps pace: what is asked for."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Literal, get_args

from ...errors import InputError, nearest

Policy = Literal["warn", "stop", "skip"]
SLOWEST, FASTEST = 1e-6, 1e6  # times the clock on the wall


@dataclass(frozen=True)
class Pace:
    """Real time for a run: the instants of the plan that have a deadline are reached no earlier than the clock on the
    wall.

    `factor`: simulated seconds in one second. `policy`: what a missed deadline means; "warn": the run catches up and
    says so in the end; "stop": it ends; "skip": the time that was lost is given up, later deadlines move by it.
    `every`: the time between two deadlines, such as "20 ms"; see `deadlines_of` for an empty one. `fifo`: the
    priority of SCHED_FIFO, 1 to 99, 0 for the usual scheduling; `cores`: the processors that the run is held on.
    Raises InputError for what has no meaning; whether the system allows `fifo` and `cores` shows as the run begins.
    """

    factor: float = 1.0
    policy: Policy = "warn"
    every: str = ""
    fifo: int = 0
    cores: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        require_factor(self.factor)
        if self.policy not in get_args(Policy):
            near = nearest(self.policy, get_args(Policy))
            raise InputError(f"realtime policy '{self.policy}': there are warn, stop and skip{near}")
        if not 0 <= self.fifo <= 99:
            raise InputError(f"SCHED_FIFO has priorities from 1 to 99, not {self.fifo}")
        if self.fifo and not hasattr(os, "sched_setscheduler"):
            raise InputError("there is no SCHED_FIFO on this system; leave it out")
        if self.cores and not hasattr(os, "sched_setaffinity"):
            raise InputError("a process cannot be held on processors on this system; leave that out")


def require_factor(factor: float) -> None:
    """Raise InputError for a speed that is none."""
    if not (math.isfinite(factor) and SLOWEST <= factor <= FASTEST):
        raise InputError(
            f"real-time factor {factor:g}: take a number from {SLOWEST:g} to {FASTEST:g}; 2 is twice as fast as the "
            f"clock on the wall"
        )
