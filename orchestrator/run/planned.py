"""From a system to a plan of which everything is known to be right before time 0: what it reports too."""

from __future__ import annotations

from ..plan.plan import Plan, make_plan
from ..results.requested import check_reporting
from ..system.model import System


def planned(system: System) -> Plan:
    """The plan of a system, its figures of merit and figures checked. Raises InputError."""
    plan = make_plan(system)
    check_reporting({".".join(key) for group in plan.groups for key in group.columns}, system)
    return plan
