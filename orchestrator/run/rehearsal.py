"""Time 0 without a run, to see how well its algebraic loops are solved."""

from __future__ import annotations

from ..participant.base import Instance
from ..participant.opening import start
from ..plan.plan import Plan
from .initialize import initialize
from .memory import Memory


def loop_residuals(plan: Plan) -> dict[str, float]:
    """The residual of every algebraic loop at time 0, relative to its inputs; FMUs are loaded only if there is one.

    Raises FmuError or InputError if time 0 cannot be reached.
    """
    if not any(block.loop for block in plan.start):
        return {}
    instances: dict[str, Instance] = {}
    try:
        for name, component in plan.system.components.items():
            instances[name] = start(component)
        return initialize(plan, instances, Memory(plan)).loops
    finally:
        for instance in instances.values():
            instance.close()
