"""The systems and components of an SSD as a tree, with their connectors."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from ...errors import InputError, nearest
from ...fmu.fmu import Fmu
from .archive import Archive
from .document import Document, find, local, typed_child

FMU_TYPES = ("application/x-fmu-sharedlibrary", "")
MODEL_EXCHANGE = "ModelExchange"  # taken as co-simulation where the FMU can do both
GIVING, TAKING = ("output", "calculatedParameter"), ("input", "parameter")


@dataclass(frozen=True)
class Connector:
    """A connector and the unit that it states. `kind` is SSP's: input, output, parameter, calculatedParameter."""

    kind: str
    unit: str | None = None


@dataclass(eq=False)
class Element:
    """A component (with its FMU) or a system (with elements). `name` is made of all names from the root down."""

    name: str
    xml: Any
    fmu: Fmu | None
    connectors: dict[str, Connector]
    elements: dict[str, Element] = field(default_factory=dict)

    def components(self) -> Iterator[Element]:
        """All components, this one or below, in the order of the file."""
        if self.fmu:
            yield self
        for element in self.elements.values():
            yield from element.components()

    def systems(self) -> Iterator[Element]:
        """This system and those below, outer before inner."""
        yield self
        for element in self.elements.values():
            if not element.fmu:
                yield from element.systems()

    def connector(self, name: str, label: str) -> Connector:
        """A connector by name; a component has one for each variable of its FMU. Raises InputError."""
        if name in self.connectors:
            return self.connectors[name]
        scalars = self.fmu.expand(name) if self.fmu else []
        if self.fmu and scalars:
            variable = self.fmu.variables[scalars[0]]
            return Connector(variable.causality, variable.unit)
        known = [*self.connectors, *(self.fmu.base_names("input", "output") if self.fmu else ())]
        raise InputError(f"{label}: '{self.name}' has no connector '{name}'{nearest(name, known)}")


def read_structure(archive: Archive, document: Document) -> Element:
    """The tree of an SSD, its FMUs opened. Raises InputError or FmuError, naming what is not supported."""
    xml = find(document.root, "ssd:System")[0]
    root = Element("", xml, None, _connectors(document, xml))
    _fill(archive, document, root)
    names = [component.name for component in root.components()]
    for name in names:
        if names.count(name) > 1:
            raise InputError(
                f"two components of {archive.path.name} would be called '{name}' (a component in a system is called "
                f"by both names, and other characters than letters and digits become _); rename one"
            )
    return root


def _fill(archive: Archive, document: Document, parent: Element) -> None:
    for xml in find(parent.xml, "ssd:Elements/*"):
        own = str(xml.get("name"))
        name = re.sub(r"\W", "_", f"{parent.name}_{own}" if parent.name else own)
        if own in parent.elements:
            raise document.fail(f"there are two elements '{own}' in one system", xml)
        connectors = _connectors(document, xml)
        if local(xml) == "Component":
            element = Element(name, xml, _fmu(archive, document, xml), connectors)
            _check_connectors(document, element)
        else:
            element = Element(name, xml, None, connectors)
            _fill(archive, document, element)
        parent.elements[own] = element


def _fmu(archive: Archive, document: Document, xml: Any) -> Fmu:
    label = f"component '{xml.get('name')}'"
    if xml.get("type", "") not in FMU_TYPES:
        raise document.fail(f"{label} is of type {xml.get('type')}; only FMUs are supported", xml)
    wanted = xml.get("implementation", "any")
    refused = document.fail(f"{label}: {wanted} is not supported; CoSimulation is needed", xml)
    if wanted not in ("any", "CoSimulation", MODEL_EXCHANGE):
        raise refused
    try:
        fmu = Fmu.open(archive.resolve(xml.get("source", ""), label))
    except InputError as error:
        raise document.fail(str(error), xml) from None
    if wanted == MODEL_EXCHANGE and fmu.description.modelExchange is None:
        raise refused
    return fmu


def _connectors(document: Document, xml: Any) -> dict[str, Connector]:
    connectors = {}
    for entry in find(xml, "ssd:Connectors/ssd:Connector"):
        kind, type_ = entry.get("kind"), typed_child(entry)
        if kind not in (*GIVING, *TAKING):
            raise document.fail(f"connector '{entry.get('name')}' is of kind {kind}, which is not supported", entry)
        connectors[entry.get("name")] = Connector(kind, None if type_ is None else type_.get("unit"))
    return connectors


def _check_connectors(document: Document, component: Element) -> None:
    """A connector of a component stands for a variable of its FMU, of the same causality."""
    assert component.fmu
    for entry in find(component.xml, "ssd:Connectors/ssd:Connector"):
        name, connector = entry.get("name"), component.connectors[entry.get("name")]
        scalars = component.fmu.expand(name)
        if not scalars:
            known = component.fmu.base_names("input", "output", "parameter")
            raise document.fail(
                f"connector '{name}' of '{component.name}': the FMU has no such variable{nearest(name, known)}", entry
            )
        variable = component.fmu.variables[scalars[0]]
        if variable.causality != connector.kind:
            raise document.fail(
                f"connector '{name}' of '{component.name}' is of kind {connector.kind}, "
                f"the FMU's variable of causality {variable.causality}",
                entry,
            )
