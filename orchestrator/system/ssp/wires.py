"""The connections of an SSD, from the component that gives to the one that takes, through what lies between them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from ...errors import InputError, shown
from ...units import Unit
from ..file.connections.link import Link
from .files.annotations import annotated
from .files.document import find
from .files.rules import OTHER_UNIT, TWICE
from .structure import Connector, Element
from .units import IDENTITY, Linear, converted, stated_linear, stated_table

End = tuple[Element, str]  # an element and the name of one of its connectors


@dataclass(frozen=True)
class Wire:
    """One <Connection>, in the direction in which values go. `system` is the one that it stands in."""

    source: End
    target: End
    system: Element
    kind: str  # of the connector that takes
    linear: Linear
    convert: bool
    transfer: str
    counter: str
    rounded: bool
    label: str
    where: str


def wires_of(root: Element) -> dict[End, Wire]:
    """All connections of all systems, by the end that takes. Raises InputError where an end is driven twice."""
    wires: dict[End, Wire] = {}
    for system in root.systems():
        for xml in find(system.xml, "Connections/Connection"):
            wire = _wire(system, xml)
            there = wires.get(wire.target)
            if there and (there.source, there.linear, there.convert) == (wire.source, wire.linear, wire.convert):
                system.document.notes.add(TWICE, f"{wire.label} {wire.where}")
            elif there:
                raise InputError(
                    f"{wire.label}: the second connection to the same connector, after {there.label} {wire.where}"
                )
            wires[wire.target] = wire
    return wires


def _wire(system: Element, xml: Any) -> Wire:
    document = system.document
    names = [[xml.get(f"{side}Element") or None, xml.get(f"{side}Connector")] for side in ("start", "end")]
    label, where = f"connection {' -> '.join('.'.join(filter(None, name)) for name in names)}", document.at(xml)
    ends: list[End] = []
    kinds: list[Connector] = []
    gives: list[bool | None] = []
    for element, connector in names:
        owner = system.elements.get(element) if element is not None else system
        if owner is None:
            raise InputError(f"{label}: there is no element '{shown(element)}' {where}")
        try:
            found = owner.connector(connector, label)
        except InputError as error:
            raise InputError(f"{error} {where}") from None
        ends.append((owner, connector))
        kinds.append(found)
        seen = found.gives
        gives.append(seen if seen is None or owner is not system else not seen)  # from inside, a system's input gives
    start, end = gives
    if start is not None and start == end:
        raise InputError(f"{label}: {kinds[0].kind} and {kinds[1].kind} cannot be connected here {where}")
    first, last = (0, 1) if start or end is False or start == end else (1, 0)
    _refuse_table(xml, label, where)
    suppressed = xml.get("suppressUnitConversion") in ("true", "1")
    keys = annotated(document, xml, ("transfer", "counter", "rounded"))
    transfer, counter = (str(keys.get(key, "")) for key in ("transfer", "counter"))
    rounded = keys.get("rounded") is True
    return Wire(
        ends[first], ends[last], system, kinds[last].kind, stated_linear(xml), not suppressed, transfer, counter,
        rounded, label, where,
    )  # fmt: skip


def _refuse_table(xml: Any, label: str, where: str) -> None:
    """Raise InputError for a transformation that changes values one by one."""
    for entry in stated_table(xml):
        if entry.get("source") != entry.get("target"):
            raise InputError(
                f"{label}: a connection that makes {shown(entry.get('target'))} of {shown(entry.get('source'))} is not "
                f"supported; let a component do it {where}"
            )


def path_to(wires: Mapping[End, Wire], target: End) -> list[Wire]:
    """The wires that lead to an end, from the first giver on. Raises InputError for systems that feed themselves."""
    path: list[Wire] = []
    seen: set[End] = set()
    while target in wires:
        wire = wires[target]
        if target in seen:
            raise InputError(f"{wire.label}: the connectors of systems feed each other in a circle {wire.where}")
        seen.add(target)
        path.append(wire)
        target = wire.source
        if target[0].fmu:
            break  # what drives a component's output connector, if anything does, is not on the way
    return path[::-1]


def links_of(wires: Mapping[End, Wire]) -> Iterator[Link]:
    """The connections between components, with all that happens to the value on the way."""
    for (element, name), last in wires.items():
        if not element.fmu:
            continue
        path = path_to(wires, (element, name))
        giver, output = path[0].source
        if not giver.fmu:
            continue  # a connector of the whole system, which nothing drives
        if last.kind != "input":
            given = giver.connector(output, last.label).kind
            raise InputError(f"{last.label}: from {given} to {last.kind} is not supported {last.where}")
        linear, unit = IDENTITY, unit_of(giver, output, path[0])
        for wire in path:
            there = unit_of(*wire.target, wire)
            if there and unit and not wire.target[0].fmu:  # a connector of a system says nothing of differences
                there = replace(there, relative=unit.relative)
            if wire.convert:
                linear = linear.then(converted(unit, there, wire.system.document.notes, wire.label, wire.where))
            linear = linear.then(wire.linear)
            unit = there or unit
        transfer, counter = next(((wire.transfer, wire.counter) for wire in reversed(path) if wire.transfer), ("", ""))
        rounded = any(wire.rounded for wire in path) or _both_real(giver, output, element, name)
        yield Link(
            giver.name, output, element.name, name, transfer, linear.factor, linear.offset, last.where, rounded,
            counter=f"{giver.name}.{counter}" if counter else "",
        )  # fmt: skip


def _both_real(giver: Element, output: str, taker: Element, input_: str) -> bool:
    """SSP 1.0 has one type of real numbers, so that nobody could say `round` there."""
    ends = ((element.fmu, name) for element, name in ((giver, output), (taker, input_)))
    return all(fmu and (found := fmu.expand(name)) and fmu.is_real(found[0]) for fmu, name in ends)


def unit_of(element: Element, name: str, wire: Wire) -> Unit | None:
    """The unit of a connector: the FMU's, else what is stated there.

    Raises InputError where the two differ and a transformation in the connector's unit is stated.
    """
    stated = element.connector(name, wire.label).unit
    scalars = element.fmu.expand(name) if element.fmu else []
    own = element.fmu.unit(scalars[0]) if element.fmu and scalars else None
    if not stated:
        return own
    unit = Unit(stated, element.units.get(stated), bool(own and own.relative))
    if own is None:
        return unit
    try:
        alike = converted(unit, own, wire.system.document.notes, wire.label, wire.where) == IDENTITY
    except InputError:
        alike = False
    if alike:
        return unit if own.definition is None else own
    if wire.linear != IDENTITY or not wire.convert:
        raise InputError(f"{wire.label}: connector {name} is in {stated}, the FMU's variable in {own} {wire.where}")
    wire.system.document.notes.add(OTHER_UNIT, f"{stated} of {element.name}.{name}, in the FMU {own} {wire.where}")
    return own
