"""From a system to a plan of which everything is known to be right before time 0: what it reports too."""

from __future__ import annotations

from collections.abc import Collection

from ..errors import InputError
from ..plan.plan import Plan, make_plan
from ..results.requested import check_reporting
from ..system.model import System


def planned(system: System, boundaries: Collection[str] = (), deadlines: str | None = None) -> Plan:
    """The plan of a system, its figures of merit and figures checked, and the components of which recordings are
    wanted. `deadlines`: of a run in real time, see `deadlines_of`. Raises InputError."""
    plan = make_plan(system, deadlines)
    if boundaries and plan.adaptive:
        raise InputError(
            f"--record-boundary needs steps of one length; with algorithm '{system.algorithm}' they vary "
            f"({system.name})"
        )
    check_reporting({".".join(key) for group in plan.groups for key in group.columns}, system)
    return plan
