"""How the states of a group are integrated: what a system file may say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

Method = Literal["dormand-prince", "rk4", "cvode"]
METHODS: tuple[str, ...] = get_args(Method)
TOLERANCE = 1e-6  # relative, where neither the system nor an FMU says one


@dataclass(frozen=True)
class SolverSettings:
    """`method`: empty where the plan chooses. `tolerance`: relative; None for that of the FMUs. `step` [s]: of the
    fixed-step method, None for the communication step. `max_step` [s]: None for no limit. `max_order`: of CVODE.
    `restart`: CVODE begins anew at every communication point, so that a run can be taken up there bit by bit."""

    method: Method | None = None
    tolerance: float | None = None
    step: float | None = None
    max_step: float | None = None
    max_order: int = 5
    restart: bool = False
