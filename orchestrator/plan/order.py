"""Who steps when: components that step first, and the order of the others."""

from __future__ import annotations

from ..clock import Clock
from ..errors import InputError
from ..system.model import Connection, System
from .formulas import Choice


def discrete(system: System, end: tuple[str, str]) -> bool:
    return bool(system.components[end[0]].fmu.variables[end[1]].variability == "discrete")


def samplers_of(system: System) -> tuple[str, ...]:
    """Components with connected inputs, all of which are sampled (FMI variability `discrete`).

    Where nothing is connected, inputs that follow tables count instead.
    """
    into = {name: [c.target for c in system.connections if c.target[0] == name] for name in system.components}
    for name, component in system.components.items():
        into[name] = into[name] or [(name, variable) for variable in component.series]
    return tuple(name for name, ends in into.items() if ends and all(discrete(system, end) for end in ends))


def leaders_of(system: System, samplers: tuple[str, ...]) -> tuple[str, ...]:
    """Components whose outputs are interpolated: they step before those that receive them."""
    sources = {c.source[0] for c in system.connections if c.transfer == "interpolate"}
    return tuple(name for name in system.components if name in sources and name not in samplers)


def order_of(system: System, clock: Clock) -> tuple[tuple[str, ...], str]:
    """Faster components first; among equals, a source before its target where the graph allows it."""
    if system.order:
        slower = [
            (a, b) for a, b in zip(system.order, system.order[1:], strict=False) if clock.periods[a] > clock.periods[b]
        ]
        if slower:
            raise InputError(
                f"order: {slower[0][0]} is slower than {slower[0][1]} and must come after it ({system.path.name})"
            )
        return system.order, "stated in the system file"
    waiting, done = sorted(system.components, key=lambda name: clock.periods[name]), []
    while waiting:
        rate = [name for name in waiting if clock.periods[name] == clock.periods[waiting[0]]]
        sources = {
            name: {
                c.source[0]
                for c in system.connections
                if c.target[0] == name and c.source[0] in rate and c.source[0] != name
            }
            for name in rate
        }
        ready = [name for name in rate if not sources[name]] or rate
        done.append(ready[0])
        waiting.remove(ready[0])
    return tuple(done), "fast before slow; at one rate a source before its target, cycles cut in the order of the file"


def check_leaders(choices: dict[Connection, Choice], leaders: tuple[str, ...], order: tuple[str, ...]) -> None:
    """Raise InputError where of two components each would have to step before the other."""
    for c, choice in choices.items():
        a, b = c.source[0], c.target[0]
        if choice.transfer == "interpolate" and b in leaders and order.index(a) >= order.index(b):
            raise InputError(
                f"connection {c.label}: 'interpolate' needs {a} to step first, but outputs of {b} are interpolated too "
                f"and it comes before {a} in the order ({', '.join(order)}); state another order or transfer {c.where}"
            )
