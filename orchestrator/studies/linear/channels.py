"""What a linear model goes from and to: free inputs, connections to whose signal something is added, and signals."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from ...errors import InputError, listed, nearest
from ...system.connection import Connection
from ...system.event import Event, Fault, Key
from ...system.file.recorded import recorded_names
from ...system.model import System
from ...system.values import follows_tables


@dataclass(frozen=True)
class Channel:
    """A scalar input of a linear model: a free input, or what is added to a connection's signal on its way."""

    name: str
    key: Key  # the input that takes it
    unit: str
    nominal: float  # its size as the FMU states it, 1 where it states none
    connection: Connection | None = None

    @property
    def target(self) -> str:
        """The input that takes it, by its full name."""
        return ".".join(self.key)


def channels_of(system: System, names: Iterable[str], option: str) -> list[Channel]:
    """The scalar inputs that names mean; an array is all of its elements. Raises InputError for what cannot be one."""
    found: dict[str, Channel] = {}
    for name in names:
        for channel in _connected(system, name, option) if "->" in name else _free(system, name, option):
            found[channel.name] = channel
    return list(found.values())


def connections_of(system: System, name: str, option: str) -> list[Connection]:
    """The connections that `a.y -> b.u` means, of arrays all of their elements. Raises InputError for none."""
    source, _, target = (part.strip() for part in name.partition("->"))
    target = target.partition("(")[0].strip()  # with its transfer, as the system file has it
    ends = [_scalars(system, end, option, "->") for end in (source, target)]
    found = [c for c in system.connections if c.source in ends[0] and c.target in ends[1]]
    if not found:
        drivers = [system.drivers[key].label for key in ends[1] if key in system.drivers]
        driven = [c.label for c in system.connections if c.source in ends[0]]
        known = [c.label for c in system.connections]
        near = drivers or driven
        hint = f"; there is {listed(near)}" if near else nearest(f"{source} -> {target}", known)
        raise InputError(f"{option} {source} -> {target}: there is no such connection{hint}")
    return found


def _connected(system: System, name: str, option: str) -> list[Channel]:
    channels = []
    for c in connections_of(system, name, option):
        for end in (c.source, c.target):
            require_number(system, end, option)
        channels.append(Channel(c.label, c.target, *_size(system, c.target), c))
    return channels


def _free(system: System, name: str, option: str) -> list[Channel]:
    channels = []
    for key in _scalars(system, system.full_name(name), option, "an input"):
        owner, variable = key
        component = system.components[owner]
        label = f"{option} {owner}.{variable}"
        described = component.fmu.variables[variable]
        if not follows_tables(described):
            raise InputError(
                f"{label}: it is of causality {described.causality}; take a free input, or a connection, "
                f'for instance "{_example(system)}"'
            )
        if driver := system.drivers.get(key):
            raise InputError(
                f'{label} is driven by the connection {driver.label}; write "{driver.label}" to add to what it sends'
            )
        if series := component.series.get(variable):
            raise InputError(f"{label} follows {series.origin}; leave that table out")
        require_number(system, key, option)
        channels.append(Channel(f"{owner}.{variable}", key, *_size(system, key)))
    return channels


def signals_of(system: System, names: Sequence[str], option: str) -> list[str]:
    """The scalar signals that names and patterns mean, in their order. Raises InputError for one that is no number."""
    found: list[str] = []
    for name in names:
        full = system.full_name(name.strip())
        fail: Callable[[str, str], InputError] = lambda pattern, why: InputError(f"{option} {pattern}: {why}")  # noqa: E731
        pattern = "*" in full or "?" in full
        hits = recorded_names(system.components, [full], fail)
        if pattern:
            every = [f"{n}.{v}" for n, c in system.components.items() for v in c.fmu.names("output")]
            from ...system.file.recorded import matches

            hits = tuple(n for n in every if matches((full,), n) and _is_number(system, n))
        for hit in hits:
            if not pattern:
                owner, _, variable = hit.partition(".")
                require_number(system, (owner, variable), option)
            found.append(hit)
    return list(dict.fromkeys(found))


def require_number(system: System, key: Key, option: str) -> None:
    """Raise InputError for a signal that is no floating-point number: it has no derivative."""
    fmu = system.components[key[0]].fmu
    if not fmu.is_real(key[1]):
        kind = fmu.variables[key[1]].type
        raise InputError(
            f"{option} {'.'.join(key)}: it is of type {kind}, and only floating-point numbers have derivatives"
        )


def _is_number(system: System, name: str) -> bool:
    owner, _, variable = name.partition(".")
    return system.components[owner].fmu.is_real(variable)


def _scalars(system: System, name: str, option: str, what: str) -> list[Key]:
    """The scalars of `component.variable`. Raises InputError where there are none."""
    owner, _, variable = name.strip().partition(".")
    if owner not in system.components:
        raise InputError(f"{option} {name}: no component '{owner}'{nearest(owner, system.components)}")
    fmu = system.components[owner].fmu
    scalars = fmu.expand(variable)
    if not scalars:
        causalities = ("input", "output") if what == "->" else ("input", "parameter")
        raise InputError(
            f"{option} {name}: {owner} has no variable '{variable}'{nearest(variable, fmu.base_names(*causalities))}"
        )
    return [(owner, scalar) for scalar in scalars]


def _size(system: System, key: Key) -> tuple[str, float]:
    described = system.components[key[0]].fmu.variables[key[1]]
    return described.unit or "1", abs(float(described.nominal or 0.0)) or 1.0


def _example(system: System) -> str:
    return system.connections[0].label if system.connections else "a.y -> b.u"


def free_inputs(system: System) -> list[str]:
    """The floating-point inputs that nothing drives."""
    return [
        f"{name}.{v}"
        for name, component in system.components.items()
        for v in component.fmu.names("input")
        if (name, v) not in system.drivers and v not in component.series and component.fmu.is_real(v)
    ]


def with_disturbances(system: System, channels: Sequence[Channel]) -> tuple[System, dict[Key, int]]:
    """The system with a fault for each channel that is a connection, which nothing begins: a bias, whose cells whoever
    steps it by hand may fill. And the numbers of these events, by the input."""
    events, numbers = list(system.events), {}
    for channel in channels:
        if channel.connection is not None and channel.key not in numbers:
            numbers[channel.key] = len(events)
            fault = Fault("bias", channel.key, {channel.key: 0.0})
            never = system.stop + Fraction(10**6)
            events.append(Event(f"disturbance of {channel.target}", at=never, fault=fault))
    return replace(system, events=tuple(events)), numbers
