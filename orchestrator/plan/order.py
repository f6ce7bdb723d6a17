"""Who steps when: components that step first, and the order of the others."""

from __future__ import annotations

from heapq import heappop, heappush
from itertools import groupby

from ..clock import Clock
from ..errors import InputError
from ..system.connection import Connection
from ..system.model import System
from .exchange import exchanged
from .schedule.formulas import Choice


def discrete(system: System, end: tuple[str, str]) -> bool:
    return bool(system.components[end[0]].fmu.variables[end[1]].variability == "discrete")


def samplers_of(system: System) -> tuple[str, ...]:
    """Components with connected inputs, all of which are sampled (FMI variability `discrete`).

    Where nothing is connected, inputs that follow tables count instead.
    """
    into: dict[str, list[tuple[str, str]]] = {name: [] for name in system.components}
    for c in system.connections:
        into[c.target[0]].append(c.target)
    into = {name: ends for name, ends in into.items() if not system.components[name].in_events}
    for name in into:
        into[name] = into[name] or [(name, variable) for variable in system.components[name].series]
    together = exchanged(system)  # these step as a whole, after the others
    return tuple(
        name
        for name, ends in into.items()
        if ends and name not in together and all(discrete(system, end) for end in ends)
    )


def leaders_of(system: System, samplers: tuple[str, ...]) -> tuple[str, ...]:
    """Components whose outputs are interpolated: they step before those that receive them."""
    sources = {c.source[0] for c in system.connections if c.transfer == "interpolate"}
    return tuple(name for name in system.components if name in sources and name not in samplers)


def order_of(system: System, clock: Clock) -> tuple[tuple[str, ...], str]:
    """Faster components first; among equals those that may end a step early, so that others can be brought to their
    events; then a source before its target where the graph allows it."""
    if system.order:
        slower = [
            (a, b) for a, b in zip(system.order, system.order[1:], strict=False) if clock.periods[a] > clock.periods[b]
        ]
        if slower:
            raise InputError(
                f"order: {slower[0][0]} is slower than {slower[0][1]} and must come after it ({system.path.name})"
            )
        return system.order, "stated in the system file"
    order: list[str] = []
    for _, rate in groupby(sorted(system.components, key=clock.periods.__getitem__), clock.periods.__getitem__):
        names = _sources_first(list(rate), system)
        order += sorted(names, key=lambda name: not system.components[name].in_events)
    return tuple(order), "fast before slow; at one rate a source before its target, cycles cut in the order of the file"


def _sources_first(names: list[str], system: System) -> list[str]:
    """Always the first that waits for no other; where all wait, the first of them."""
    position = {name: k for k, name in enumerate(names)}
    ends = {(c.source[0], c.target[0]) for c in system.connections if c.source[0] != c.target[0]}
    targets: dict[str, list[str]] = {name: [] for name in names}
    waiting = dict.fromkeys(names, 0)  # and for how many
    for source, target in ends:
        if source in position and target in position:
            targets[source].append(target)
            waiting[target] += 1
    ready = [position[name] for name in names if not waiting[name]]  # in order, so a heap
    order: list[str] = []
    first = 0
    while waiting:
        if ready:
            name = names[heappop(ready)]
        else:
            while names[first] not in waiting:
                first += 1
            name = names[first]
        order.append(name)
        del waiting[name]
        for target in targets[name]:
            if target in waiting:
                waiting[target] -= 1
                if not waiting[target]:
                    heappush(ready, position[target])
    return order


def check_leaders(choices: dict[Connection, Choice], leaders: tuple[str, ...], order: tuple[str, ...]) -> None:
    """Raise InputError where of two components each would have to step before the other."""
    place = {name: k for k, name in enumerate(order)}
    for c, choice in choices.items():
        a, b = c.source[0], c.target[0]
        if choice.transfer == "interpolate" and b in leaders and place[a] >= place[b]:
            raise InputError(
                f"connection {c.label}: 'interpolate' needs {a} to step first, but outputs of {b} are interpolated too "
                f"and it comes before {a} in the order ({', '.join(order)}); state another order or transfer {c.where}"
            )
