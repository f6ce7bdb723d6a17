"""The values of an instant once more, where something was changed at it by hand."""

from __future__ import annotations

from collections.abc import Mapping

from ...participant.base import Participant
from ...plan.plan import Plan
from ..memory.memory import Memory
from .initialize import Propagation


def settle(plan: Plan, instances: Mapping[str, Participant], memory: Memory, component: str = "") -> None:
    """Bring outputs to where inputs are, along the connections on which they depend at once; see `plan.instants`.

    `component`: its own outputs are read first, since a free input of it was set. Raises FmuError.
    """
    propagation = Propagation(plan, dict(instances), memory)
    propagation.initialized = True
    if component:
        propagation.read({component})
    propagation.settle_instant()
