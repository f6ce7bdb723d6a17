"""A connection of two terminals, `a.port -> b.port`: the connections of the variables that they have in common.

What is an output on one side drives the input on the other, in both directions. A flow counts positive inwards
(`inflow`) or outwards (`outflow`): between two of the same kind its sign turns. Parameters that a terminal holds are
not passed on: they must be the same on both sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple, TypeVar

from ....errors import InputError, nearest
from ....fmu.binary import as_text
from ....fmu.fmu import Fmu
from ....fmu.reading.terminals import BUS, BY_NAME, INFLOW, OUTFLOW, SEQUENCE, SIGNAL, Member, Stream, Terminal
from ...component import Component
from .link import Link

FLOWS = (INFLOW, OUTFLOW)
PARAMETERS = ("parameter", "structuralParameter")
T = TypeVar("T")


class End(NamedTuple):
    """One side of a connection."""

    component: Component
    path: str
    terminal: Terminal


def links_of_terminals(components: Mapping[str, Component], link: Link, where: str) -> list[Link] | None:
    """What a link of two terminals stands for; None for one of variables.

    Raises InputError for a terminal and something else, and for terminals that do not fit: which members, and why.
    """
    ends = [
        _terminal(components.get(name), variable, causality)
        for name, variable, causality in ((link.source, link.output, "output"), (link.target, link.input_, "input"))
    ]
    a, b = ends
    for end, other in ((a, b), (b, a)):
        if end is not None and other is None:
            raise _half(components, link, end, where)
    if a is None or b is None:
        return None
    pairing = _Pairing(replace(link, where=f"as a part of {link} {where}"))
    found = list(pairing.links(a, b))
    if pairing.faults:
        raise InputError(f"connection {link}: the terminals do not fit: {'; '.join(pairing.faults)} {where}")
    if not found:
        raise InputError(f"connection {link}: the terminals have no signals in common {where}")
    return found


def _terminal(component: Component | None, name: str, causality: str) -> End | None:
    """The terminal of a name; a variable of that name and the right causality comes before it."""
    if component is None or name not in component.fmu.terminals:
        return None
    fmu = component.fmu
    if any(fmu.variables[scalar].causality == causality for scalar in fmu.expand(name)):
        return None
    return End(component, name, fmu.terminals[name])


def _half(components: Mapping[str, Component], link: Link, end: End, where: str) -> InputError:
    """There is a terminal at one end, and none at the other."""
    name, other = (link.target, link.input_) if end.path == link.output else (link.source, link.output)
    if name not in components:
        return InputError(f"connection {link}: no component '{name}'{nearest(name, components)} {where}")
    return InputError(
        f"connection {link}: {_shown(end)} is a terminal and {name}.{other} is none"
        f"{nearest(other, components[name].fmu.terminals)}; connect two terminals, or variables one by one {where}"
    )


class _Pairing:
    """Walks two terminals side by side; `faults` says what does not fit."""

    def __init__(self, link: Link) -> None:
        self.link = link
        self.faults: list[str] = []

    def links(self, a: End, b: End) -> Iterator[Link]:
        x, y = a.terminal, b.terminal
        for end in (a, b):
            if end.terminal.rule not in (BY_NAME, BUS, SEQUENCE):
                self.faults.append(
                    f"{_shown(end)} follows the rule {end.terminal.rule!r}, which is none of {BY_NAME}, {BUS} and "
                    f"{SEQUENCE}; connect its variables one by one"
                )
                return
        if x.rule != y.rule:
            self.faults.append(f"{_shown(a)} is matched by {x.rule}, {_shown(b)} by {y.rule}")
            return
        for one, other in self.pairs(a, b, x.members, y.members, "member"):
            yield from self.link_of(a, b, one, other)
        for ours, theirs in self.pairs(a, b, x.streams, y.streams, "stream"):
            yield from self.link_of(a, b, ours.outside, theirs.inside)
            yield from self.link_of(a, b, ours.inside, theirs.outside)
        for inner, opposite in self.pairs(a, b, x.terminals, y.terminals, "terminal"):
            yield from self.links(_inside(a, inner), _inside(b, opposite))

    def pairs(self, a: End, b: End, ours: Sequence[T], theirs: Sequence[T], what: str) -> Iterator[tuple[T, T]]:
        """By order, or by name."""
        if a.terminal.rule == SEQUENCE:
            if len(ours) != len(theirs):
                self.faults.append(f"{_shown(a)} has {len(ours)} {what}s, {_shown(b)} has {len(theirs)}")
            elif ours:
                yield from zip(ours, theirs, strict=True)
            return
        known = {_name(other): other for other in theirs}
        for one in ours:
            if (other := known.pop(_name(one), None)) is not None:
                yield one, other
            elif a.terminal.rule == BY_NAME:
                self.faults.append(f"{_shown(a)} has the {what} {_name(one)!r}, which {_shown(b)} lacks")
        if a.terminal.rule == BY_NAME:
            self.faults += [f"{_shown(b)} has the {what} {name!r}, which {_shown(a)} lacks" for name in known]

    def link_of(self, a: End, b: End, one: Member, other: Member) -> Iterator[Link]:
        """From the output to the input of the two."""
        label = f"{_shown(a)} and {_shown(b)}: member {one.name or one.variable!r}"
        kinds = (one.kind, other.kind)
        sign = -1.0 if one.kind == other.kind and one.kind in FLOWS else 1.0
        if not (kinds == (SIGNAL, SIGNAL) or (one.kind in FLOWS and other.kind in FLOWS)):
            self.faults.append(f"{label} is {one.kind} and {other.kind}, which are no pair")
            return
        ways = (_causality(a, one.variable), _causality(b, other.variable))
        if ways == ("output", "input"):
            ends = (a, one, b, other)
        elif ways == ("input", "output"):
            ends = (b, other, a, one)
        elif set(ways) <= set(PARAMETERS):
            self.same(label, a, b, one, other)
            return
        else:
            both = f"{ways[0]} on both sides" if ways[0] == ways[1] else f"{ways[0]} and {ways[1]}"
            self.faults.append(f"{label} is {both}; an output must meet an input")
            return
        source, output, target, input_ = ends
        yield replace(
            self.link, source=source.component.name, output=output.variable, target=target.component.name,
            input_=input_.variable, sign=sign,
        )  # fmt: skip

    def same(self, label: str, a: End, b: End, one: Member, other: Member) -> None:
        """Parameters on both sides must have one value."""
        values = [
            [end.component.parameters.get(s, end.component.fmu.start(s)) for s in end.component.fmu.expand(m.variable)]
            for end, m in ((a, one), (b, other))
        ]
        if values[0] != values[1]:
            names = [f"{end.component.name}.{m.variable}" for end, m in ((a, one), (b, other))]
            shown = [", ".join(map(as_text, v)) for v in values]
            self.faults.append(
                f"{label} is a parameter of both, {names[0]} = {shown[0]} and {names[1]} = {shown[1]}; give them one "
                f"value"
            )


def _name(one: object) -> str:
    if isinstance(one, Stream):
        return f"{one.inside.name} and {one.outside.name}"
    assert isinstance(one, (Member, Terminal))
    return one.name


def _inside(end: End, terminal: Terminal) -> End:
    return End(end.component, f"{end.path}.{terminal.name}", terminal)


def _shown(end: End) -> str:
    return f"{end.component.name}.{end.path}"


def _causality(end: End, variable: str) -> str:
    fmu: Fmu = end.component.fmu
    scalars = fmu.expand(variable)
    return str(fmu.variables[scalars[0]].causality) if scalars else "an array without elements"
