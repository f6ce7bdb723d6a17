"""The FMUs for Model Exchange of a run, brought together to one group."""

from __future__ import annotations

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...loop.cells import THRESHOLD
from ...participant.base import Participant
from ...participant.model_exchange.group import Group
from ...participant.model_exchange.instance import Member
from ...participant.model_exchange.links import Crossed, Link, LinkBlock
from ...plan.exchange import links_of, located, settings_of
from ...plan.plan import Plan
from ...system.connection import Connection
from ..memory.memory import Memory
from .apart import sampled


def bring_together(plan: Plan, instances: dict[str, Participant], memory: Memory) -> Group | None:
    """The group, if there is one; its members know it. Raises FmuError where they cannot be connected."""
    names = plan.exchange
    members = [instance for name in names if isinstance(instance := instances[name], Member)]
    if len(members) < len(names):
        apart = next(name for name in names if not isinstance(instances[name], Member))
        if len(names) > 1:
            raise FmuError(
                f"component {apart}: {instances[apart].fmu.path.name} was used in this process before and cannot be "
                f"loaded again, but must be in one process with {', '.join(n for n in names if n != apart)}, all for "
                f"Model Exchange; run the system in a process of its own"
            )
        return None
    numbers = {name: k for k, name in enumerate(names)}
    blocks = [
        LinkBlock(tuple(_link(plan, c, numbers) for c in block.connections), block.loop)
        for block in links_of(plan.system, plan.choices)
    ]
    inside = {c.target for c in plan.inside}
    outside = {key: slot for key, slot in plan.layout.inputs.items() if key[0] in numbers and key not in inside}
    early = plan.system.components[names[0]].in_events  # otherwise events are handled inside its steps
    first = int(memory.z.ctypes.data)
    watched = [first + memory.z.itemsize * slot for slot in outside.values()]
    rests = sampled(plan, outside) and not early
    group = Group(members, blocks, settings_of(plan.system), rests, watched, early, _crossings(plan, numbers, first))
    group.goes_back = plan.algorithm.saves_states
    for member in members:
        member.join(group)
    return group


def _crossings(plan: Plan, numbers: dict[str, int], first: int) -> list[Crossed]:
    """The signals of members for which events of the system wait; `first`: the address of the first cell."""
    found = []
    for number, cell in plan.layout.watches.items():
        crossing = plan.system.events[number].when
        if crossing is not None and located(plan.system, crossing.signal):
            name, variable = crossing.signal
            limit = first + 8 * (cell + THRESHOLD)
            found.append(Crossed(numbers[name], variable, limit, crossing.rising, f"{name}.{variable} crosses a value"))
    return found


def _link(plan: Plan, c: Connection, numbers: dict[str, int]) -> Link:
    """A connection in the FMUs' own names and units."""
    source, target = (plan.system.components[name].fmu for name in (c.source[0], c.target[0]))
    ends = (numbers[c.source[0]], source.own_name(c.source[1])), (numbers[c.target[0]], target.own_name(c.target[1]))
    places = source.own.places[ends[0][1]], target.own.places[ends[1][1]]
    given, taken = (-1.0 if place.negated else 1.0 for place in places)
    if not plan.system.is_real(c):
        return Link(*ends, given * taken * c.gain, taken * c.offset)
    at_zero, at_one = (_sent(c, source, target, value) for value in (0.0, 1.0))
    gain = at_one - at_zero if (at_zero, at_one) != (c.offset, c.gain + c.offset) else c.gain
    return Link(*ends, given * taken * gain, taken * at_zero)


def _sent(c: Connection, source: Fmu, target: Fmu, value: float) -> float:
    found = source.from_own(source.own_name(c.source[1]) and c.source[1], value)
    return float(target.to_own(c.target[1], c.gain * float(found) + c.offset))
