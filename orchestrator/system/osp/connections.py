"""The connections of an OspSystemStructure.xml, between variables, groups of them, and signals of functions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from ...errors import InputError, nearest, shown
from ...units import Unit
from ..file.connections.link import Link
from ..ssp.files.rules import TWICE
from ..ssp.units import IDENTITY, Linear, converted
from .document import EARLY, OspDocument, find, in_order, local
from .functions import Function
from .groups import Groups, pairs
from .simulators import Simulator

GIVING = ("output", "calculatedParameter")


@dataclass(frozen=True)
class Port:
    """A variable of a simulator, or a signal of a function."""

    owner: str
    name: str
    function: bool = False

    def __str__(self) -> str:
        return f"{self.owner}.{self.name}"


@dataclass(frozen=True)
class Wire:
    """What drives a port."""

    source: Port
    target: Port
    bond: str
    where: str

    @property
    def label(self) -> str:
        return f"connection {self.source} -> {self.target}"


@dataclass(frozen=True)
class Origin:
    """The output behind a chain of functions, and what happens to its value; `plain`: there is no function."""

    component: str
    output: str
    linear: Linear = IDENTITY
    plain: bool = True


class Network:
    """All connections by the port that they drive. Raises InputError."""

    def __init__(
        self, document: OspDocument, simulators: Mapping[str, Simulator], functions: Mapping[str, Function],
        groups: Groups,
    ) -> None:  # fmt: skip
        self.document, self.simulators, self.functions, self.groups = document, simulators, functions, groups
        self.wires: dict[Port, Wire] = {}
        for top in (*find(document.root, "Connections"), *find(document.root, "VariableConnections")):
            for xml in top:
                for a, b in self._ends(xml):
                    self._add(a, b, xml)

    def _add(self, a: Port, b: Port, xml: Any) -> None:
        where = self.document.at(xml)
        label = f"connection {a} -> {b}"
        kinds = [self._kind(port, label, where) for port in (a, b)]
        gives = [kind in GIVING for kind in kinds]
        if gives[0] == gives[1]:
            raise InputError(f"{label}: {kinds[0]} and {kinds[1]} cannot be connected {where}")
        source, target = (a, b) if gives[0] else (b, a)
        wire = Wire(source, target, xml.get("powerBond") or "", where)
        there = self.wires.setdefault(target, wire)
        if there.source != source:
            raise InputError(f"{wire.label}: {target} is driven twice, by {there.source} too {there.where} {where}")
        if there is not wire:
            self.document.notes.add(TWICE, f"{wire.label} {where}")

    def _kind(self, port: Port, label: str, where: str) -> str:
        """The causality of a port. Raises InputError for one that is not there."""
        if port.function:
            return "output" if port.name.startswith("out") else "input"
        fmu = self.simulators[port.owner].fmu
        scalars = fmu.expand(port.name)
        if not scalars:
            near = nearest(port.name, fmu.base_names("input", "output"))
            raise InputError(f"{label}: '{port.owner}' has no variable '{shown(port.name)}'{near} {where}")
        return str(fmu.variables[scalars[0]].causality)

    def _ends(self, xml: Any) -> list[tuple[Port, Port]]:
        """The pairs of ports that one element connects."""
        label = f"<{local(xml)}> {self.document.at(xml)}"
        if local(xml) == "ScalarConnection":
            self.document.notes.add(EARLY, label)
        ends = list(in_order(xml, "Variable", "Signal", "VariableGroup", "SignalGroup", "Source", "Target"))
        if len(ends) != 2:
            raise InputError(f"{label}: it needs two ends, not {len(ends)}")
        if local(xml) == "VariableGroupConnection":
            owners = [self._simulator(end, label) for end in ends]
            a, b = (self.groups.group(s, e.get("name"), label) for s, e in zip(owners, ends, strict=True))
            return [(Port(owners[0].name, u), Port(owners[1].name, v)) for u, v in pairs(a, b, label)]
        several = [self._ports(end, label) for end in ends]
        if len(several[0]) != len(several[1]):
            raise InputError(f"{label}: {len(several[0])} signals cannot be connected with {len(several[1])}")
        return list(zip(*several, strict=True))

    def _ports(self, end: Any, label: str) -> list[Port]:
        """What one end stands for: several ports where it is a group."""
        if local(end) in ("Signal", "SignalGroup"):
            name = str(end.get("function"))
            if name not in self.functions:
                raise InputError(f"{label}: there is no function '{shown(name)}'{nearest(name, self.functions)}")
            return [Port(name, signal, True) for signal in self.functions[name].signals(end.get("name"), label)]
        simulator = self._simulator(end, label)
        if local(end) == "VariableGroup":
            return [Port(simulator.name, v) for v in self.groups.group(simulator, end.get("name"), label).variables]
        return [Port(simulator.name, str(end.get("name") or end.get("endpoint")))]

    def _simulator(self, end: Any, label: str) -> Simulator:
        name = str(end.get("simulator"))
        if name not in self.simulators:
            raise InputError(f"{label}: there is no simulator '{shown(name)}'{nearest(name, self.simulators)}")
        return self.simulators[name]

    def sums(self) -> dict[str, Function]:
        """The functions that add more than one signal, by name: each is a component."""
        return {
            name: function
            for name, function in self.functions.items()
            if any(len(self.connected(function, out)) > 1 for out in function.terms)
        }

    def connected(self, function: Function, output: str) -> tuple[str, ...]:
        """The inputs of an output of a function that something drives."""
        return tuple(term for term in function.terms[output] if Port(function.name, term, True) in self.wires)

    def links(self, sums: Mapping[str, str]) -> Iterator[tuple[Link, Wire]]:
        """The connections between components, with all that happens to a value on its way.

        `sums`: what the components of functions that add are called.
        """
        for target, wire in self.wires.items():
            if target.function and target.owner not in sums:
                continue
            if not target.function and (kind := self._kind(target, wire.label, wire.where)) != "input":
                raise InputError(f"{wire.label}: an output cannot drive a {kind} {wire.where}")
            origin = self._origin(wire, sums, ())
            linear = origin.linear
            if origin.plain and not target.function:
                linear = self._converted(wire).then(linear)
            component = sums[target.owner] if target.function else self.simulators[target.owner].component
            numbers = (linear.factor, linear.offset)
            yield Link(origin.component, origin.output, component, target.name, "", *numbers, wire.where), wire

    def _converted(self, wire: Wire) -> Linear:
        """Between the units of two variables; through functions numbers go as they are."""
        a, b = (self._unit(port) for port in (wire.source, wire.target))
        return converted(a, b, self.document.notes, wire.label, wire.where, AS_IT_IS)

    def _unit(self, port: Port) -> Unit | None:
        fmu = self.simulators[port.owner].fmu
        return fmu.unit(fmu.expand(port.name)[0])

    def _origin(self, wire: Wire, sums: Mapping[str, str], through: tuple[str, ...]) -> Origin:
        """Where a wire's value comes from. Raises InputError where functions feed each other, or nothing feeds one."""
        source = wire.source
        if not source.function:
            return Origin(self.simulators[source.owner].component, source.name)
        function = self.functions[source.owner]
        terms = self.connected(function, source.name)
        if not terms:
            raise InputError(f"{wire.label}: nothing drives the function '{shown(source.owner)}' {wire.where}")
        if source.owner in sums:
            return Origin(sums[source.owner], source.name, plain=False)
        if source.owner in through:
            raise InputError(f"{wire.label}: functions feed each other in a circle {wire.where}")
        before = self._origin(self.wires[Port(source.owner, terms[0], True)], sums, (*through, source.owner))
        return Origin(before.component, before.output, before.linear.then(function.linear), plain=False)


AS_IT_IS = "where the number is to be passed on as it is, connect it through a LinearTransformation"
