"""The connections of an SSD, from the component that gives to the one that takes, through the systems between them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from ...errors import InputError
from ...units import Definition, Unit, conversion
from ..connections import Link
from .annotations import annotated
from .document import Document, find
from .structure import GIVING, Connector, Element
from .units import Linear, stated_linear

End = tuple[Element, str]  # an element and the name of one of its connectors


@dataclass(frozen=True)
class Wire:
    """One <Connection>, in the direction in which values go."""

    source: End
    target: End
    kind: str  # of the connector that takes
    linear: Linear
    convert: bool
    transfer: str
    label: str
    where: str


def wires_of(document: Document, root: Element) -> dict[End, Wire]:
    """All connections of all systems, by the end that takes. Raises InputError where an end is driven twice."""
    wires: dict[End, Wire] = {}
    for system in root.systems():
        for xml in find(system.xml, "ssd:Connections/ssd:Connection"):
            wire = _wire(document, system, xml)
            if wire.target in wires:
                raise InputError(f"{wire.label}: the second connection to the same connector {wire.where}")
            wires[wire.target] = wire
    return wires


def _wire(document: Document, system: Element, xml: Any) -> Wire:
    names = [[xml.get(f"{side}Element"), xml.get(f"{side}Connector")] for side in ("start", "end")]
    label = " -> ".join(".".join(filter(None, name)) for name in names)
    label, where = f"connection {label}", document.at(xml)
    ends: list[End] = []
    gives: list[bool] = []
    kinds: list[Connector] = []
    for element, connector in names:
        owner = system.elements.get(element) if element is not None else system
        if owner is None:
            raise InputError(f"{label}: there is no element '{element}' {where}")
        try:
            found = owner.connector(connector, label)
        except InputError as error:
            raise InputError(f"{error} {where}") from None
        ends.append((owner, connector))
        kinds.append(found)
        gives.append((found.kind in GIVING) == (owner is not system))  # seen from inside, a system's input gives
    if gives[0] == gives[1]:
        raise InputError(f"{label}: {kinds[0].kind} and {kinds[1].kind} cannot be connected here {where}")
    first, last = (0, 1) if gives[0] else (1, 0)
    if ("arameter" in kinds[0].kind) != ("arameter" in kinds[1].kind) or kinds[first].kind == "calculatedParameter":
        raise InputError(f"{label}: from {kinds[first].kind} to {kinds[last].kind} is not supported {where}")
    suppressed = xml.get("suppressUnitConversion") in ("true", "1")
    transfer = str(annotated(document, xml, ("transfer",)).get("transfer", ""))
    return Wire(
        ends[first], ends[last], kinds[last].kind, stated_linear(xml), not suppressed, transfer, label, where
    )  # fmt: skip


def path_to(wires: Mapping[End, Wire], target: End) -> list[Wire]:
    """The wires that lead to an end, from the first giver on. Raises InputError for systems that feed themselves."""
    path: list[Wire] = []
    while target in wires:
        wire = wires[target]
        if wire in path:
            raise InputError(f"{wire.label}: the connectors of systems feed each other in a circle {wire.where}")
        path.insert(0, wire)
        target = wire.source
    return path


def links_of(wires: Mapping[End, Wire], known: Mapping[str, Definition]) -> Iterator[Link]:
    """The connections between components, with all that happens to the value on the way."""
    for (element, name), last in wires.items():
        if not element.fmu or last.kind != "input":
            continue
        path = path_to(wires, (element, name))
        giver, output = path[0].source
        if not giver.fmu:
            continue  # a connector of the whole system, which nothing drives
        linear, unit = Linear(), unit_of(giver, output, known, path[0])
        for wire in path:
            there = unit_of(*wire.target, known, wire)
            if there and unit and not wire.target[0].fmu:  # a connector of a system says nothing of differences
                there = replace(there, relative=unit.relative)
            if wire.convert:
                linear = linear.then(Linear(*_converted(unit, there, wire)))
            linear = linear.then(wire.linear)
            unit = there or unit
        transfer = next((wire.transfer for wire in reversed(path) if wire.transfer), "")
        yield Link(giver.name, output, element.name, name, transfer, linear.factor, linear.offset, last.where)


def unit_of(element: Element, name: str, known: Mapping[str, Definition], wire: Wire) -> Unit | None:
    """The unit of a connector: stated there or by the FMU. Raises InputError where the two are not the same."""
    stated = element.connector(name, wire.label).unit
    scalars = element.fmu.expand(name) if element.fmu else []
    own = element.fmu.unit(scalars[0]) if element.fmu and scalars else None
    if not stated:
        return own
    unit = Unit(stated, known.get(stated), bool(own and own.relative))
    if own and _converted(unit, own, wire) != (1.0, 0.0):
        raise InputError(f"{wire.label}: connector {name} is in {stated}, the FMU's variable in {own} {wire.where}")
    return unit


def _converted(source: Unit | None, target: Unit | None, wire: Wire) -> tuple[float, float]:
    try:
        return conversion(source, target, wire.label)
    except InputError as error:
        raise InputError(f"{error} {wire.where}") from None
