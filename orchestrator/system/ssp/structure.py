"""The systems and components of an SSD as a tree, with their connectors; nested SSPs are part of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from ...errors import InputError, nearest, shown
from ...fmu.fmu import Fmu
from ...units import Definition
from .files.archive import Archive
from .files.dictionaries import Entry, dictionaries_of, typed_entry
from .files.document import Document, find, local
from .files.hints import stated_step
from .files.rules import NO_SIGNAL, NO_VARIABLE, OTHER_KIND, OTHER_TYPE
from .sources import Nested, Open, implementation_note, source_of
from .units import definitions

GIVING = ("output", "calculatedParameter", "local", "constant", "independent")
MOST = 10_000  # elements; systems that hold each other twice grow with every level
TAKING = ("input", "parameter", "structuralParameter")  # in both directions, as the connections say: all others


@dataclass(frozen=True)
class Connector:
    """A connector, the unit that it states, and the enumeration. `kind` is SSP's: input, output, parameter, ..."""

    kind: str
    unit: str | None = None
    enumeration: str = ""

    @property
    def gives(self) -> bool | None:
        """Whether values come out of it, as its owner's surroundings see it; None: the connections decide."""
        return True if self.kind in GIVING else False if self.kind in TAKING else None


@dataclass(frozen=True)
class Binding:
    """A <ParameterBinding>, and the files that it stands in."""

    xml: Any
    document: Document
    archive: Archive


@dataclass(eq=False)
class Element:
    """A component (with its FMU), a system (with elements) or a signal dictionary.

    `name` is made of all names from the root down, in letters, digits and _.
    """

    name: str
    xml: Any
    document: Document
    archive: Archive
    fmu: Fmu | None = None
    connectors: dict[str, Connector] = field(default_factory=dict)
    elements: dict[str, Element] = field(default_factory=dict)
    bindings: list[Binding] = field(default_factory=list)
    signals: bool = False  # a dictionary: connectors of all its references are one
    step: str = ""  # s, what other tools' annotations say of it or of what it stands in
    note: str = ""  # what the user must know of it

    def components(self) -> Iterator[Element]:
        """All components, this one or below, in the order of the file."""
        if self.fmu:
            yield self
        for element in self.elements.values():
            yield from element.components()

    def systems(self) -> Iterator[Element]:
        """This system and those below, outer before inner."""
        if not self.signals and not self.fmu:
            yield self
        for element in self.elements.values():
            yield from element.systems()

    @cached_property
    def units(self) -> dict[str, Definition]:
        """What the file in which it stands says of units."""
        return definitions(self.document)

    def connector(self, name: str, label: str) -> Connector:
        """A connector by name; a component has one for each variable of its FMU. Raises InputError."""
        if name in self.connectors:
            return self.connectors[name]
        scalars = self.fmu.expand(name) if self.fmu else []
        if self.fmu and scalars:
            variable = self.fmu.variables[scalars[0]]
            return Connector(variable.causality, variable.unit)
        known = [*self.connectors, *(self.fmu.base_names("input", "output") if self.fmu else ())]
        raise InputError(f"{label}: '{self.name}' has no connector '{shown(name)}'{nearest(name, known)}")


def read_structure(archive: Archive, document: Document, sized: Callable[[Element], Fmu]) -> Element:
    """The tree of an SSD, its FMUs opened. Raises InputError or FmuError, naming what is not supported.

    `sized`: the FMU of a component with the arrays that the values bound to the component give it.
    """
    xml = find(document.root, "System")[0]
    root = Element("", xml, document, archive, step=stated_step(xml) or stated_step(document.root))
    _Reader(sized).fill(root, Open((archive.structure,)), {})
    return root


class _Reader:
    """Fills the tree; every component gets a name of its own."""

    def __init__(self, sized: Callable[[Element], Fmu]) -> None:
        self.sized = sized
        self.taken: set[str] = set()
        self.count = 0

    def fill(self, system: Element, open_: Open, dictionaries: dict[str, Element]) -> None:
        """The connectors, bindings and elements of a system. `dictionaries`: those of the systems around it."""
        document, archive = system.document, system.archive
        system.connectors |= _connectors(document, system.xml)
        system.bindings += _bindings(system)
        dictionaries = dictionaries | {
            name: Element(f"{system.name}.{name}".strip("."), entry.xml, document, archive, signals=True,
                          connectors={n: Connector("inout", e.unit, e.enumeration) for n, e in entry.entries.items()})
            for name, entry in dictionaries_of(document, archive, system.xml).items()
        }  # fmt: skip
        for xml in find(system.xml, "Elements/*"):
            own = str(xml.get("name"))
            self.count += 1
            if self.count > MOST:
                raise document.fail(f"there are more than {MOST} elements", xml)
            if own in system.elements:
                raise document.fail(f"there are two elements '{shown(own)}' in one system", xml)
            name = re.sub(r"\W", "_", f"{system.name}_{own}" if system.name else own)
            element = Element(name, xml, document, archive, step=stated_step(xml) or system.step)
            if local(xml) == "SignalDictionaryReference":
                element = _dictionary(document, xml, dictionaries)
            elif local(xml) == "System":
                self.fill(element, open_, dictionaries)
            else:
                self._component(element, open_, dictionaries)
            system.elements[own] = element

    def _component(self, element: Element, open_: Open, dictionaries: dict[str, Element]) -> None:
        document, xml = element.document, element.xml
        source = source_of(document, element.archive, xml, open_)
        if isinstance(source, Nested):
            own, inner = _connectors(document, xml), _bindings(element)
            element.xml, element.document, element.archive = source.system, source.document, source.archive
            element.step = stated_step(source.system) or stated_step(source.document.root) or element.step
            self.fill(element, source.open_, dictionaries)
            element.connectors = own | element.connectors
            element.bindings += inner  # as if they came last in the nested system
            return
        element.fmu, element.bindings = source, _bindings(element)
        element.fmu = self.sized(element)
        element.note = implementation_note(element.name, xml, source)
        element.connectors = _of_variables(document, element, _connectors(document, xml))
        name, count = element.name, 2
        while element.name in self.taken:
            element.name = f"{name}_{count}"
            count += 1
        self.taken.add(element.name)


def _dictionary(document: Document, xml: Any, dictionaries: dict[str, Element]) -> Element:
    """The dictionary that a reference names: one element for all references to it."""
    name = xml.get("dictionary") or ""
    if name not in dictionaries:
        raise document.fail(f"there is no signal dictionary '{shown(name)}'{nearest(name, dictionaries)}", xml)
    found = dictionaries[name]
    for signal, connector in _connectors(document, xml).items():
        if signal not in found.connectors:
            document.notes.add(NO_SIGNAL, f"{signal} {document.at(xml)}")
            found.connectors[signal] = Connector("inout", connector.unit, connector.enumeration)
    return found


def _bindings(element: Element) -> list[Binding]:
    path = "ParameterBindings/ParameterBinding"
    return [Binding(xml, element.document, element.archive) for xml in find(element.xml, path)]


def _connectors(document: Document, xml: Any) -> dict[str, Connector]:
    connectors = {}
    for entry in find(xml, "Connectors/Connector"):
        typed = typed_entry(entry)
        connectors[entry.get("name")] = Connector(entry.get("kind") or "", typed.unit, typed.enumeration)
    return connectors


def _of_variables(document: Document, component: Element, stated: dict[str, Connector]) -> dict[str, Connector]:
    """Those connectors that stand for a variable of the component's FMU, with its causality."""
    fmu, found = component.fmu, {}
    assert fmu
    for entry in find(component.xml, "Connectors/Connector"):
        name, place = entry.get("name"), f"{component.name}.{entry.get('name')} {document.at(entry)}"
        scalars = fmu.expand(name)
        if not scalars:
            document.notes.add(NO_VARIABLE, place)
            continue
        variable, connector = fmu.variables[scalars[0]], stated[name]
        if variable.causality != connector.kind:
            document.notes.add(OTHER_KIND, f"{connector.kind or 'no kind'} of {place}")
        typed: Entry = typed_entry(entry)
        if not typed.fits(variable.type):
            document.notes.add(OTHER_TYPE, f"{typed.type} of {place}")
        found[name] = Connector(variable.causality, connector.unit, connector.enumeration)
    return found
