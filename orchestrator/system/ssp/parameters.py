"""Parameter sets of an SSP: values from SSV files or inline, mapped, and brought to the variables of the FMUs.

An outer system's value goes before an inner one's, a later binding before an earlier one. A name that no variable has
is passed over, as the standard wants it for sets that serve several systems; one that is nearly a variable's is an
error.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ...errors import InputError
from ...fmu.attributes import items_of
from ...units import Definition, Unit, conversion
from .archive import Archive
from .document import MAPPINGS, Document, find, local, typed_child
from .structure import Element
from .units import IDENTITY, Linear, definitions, stated_linear
from .wires import End, Wire


@dataclass(frozen=True)
class Stated:
    """A value as a file states it, and what is done to it before it is set."""

    texts: tuple[str, ...]  # more than one: an array
    unit: str | None
    known: Mapping[str, Definition]
    where: str
    linear: Linear = IDENTITY
    convert: bool = True
    listed: bool = False

    def value(self, element: Element, variable: str) -> Any:
        """As the FMU takes it: text (the reader checks it), a number where one was computed, or a list."""
        assert element.fmu
        scalar = element.fmu.expand(variable)[0]
        v = element.fmu.variables[scalar]
        label = f"{element.name}.{variable} {self.where}"
        stated = Unit(self.unit, self.known.get(self.unit), bool(v.relativeQuantity)) if self.unit else None
        unit = Linear(*conversion(stated, element.fmu.unit(scalar), label)) if self.convert else IDENTITY
        linear = unit.then(self.linear)
        items = items_of(v)
        texts: list[Any] = [items.get(text, text) for text in self.texts]
        if linear != IDENTITY:
            try:
                texts = [linear.factor * float(text) + linear.offset for text in texts]
            except ValueError:
                raise InputError(f"{label}: {self.texts[0]!r} is no number to convert") from None
        return texts if self.listed else texts[0]


class Parameters:
    """Collects what the bindings of all systems and components state."""

    def __init__(self, archive: Archive, document: Document, wires: Mapping[End, Wire]) -> None:
        self.archive, self.document, self.wires = archive, document, wires
        self.stated: dict[End, Stated] = {}

    def collect(self, root: Element) -> dict[End, Stated]:
        """The values of all variables of components, by component and variable."""
        self._bindings(root)
        for system in root.systems():  # outer before inner
            for wire in self.wires.values():
                value = self.stated.get(wire.source)
                if value and wire.source[0] is system and not system.fmu:
                    linear = value.linear.then(wire.linear)
                    convert_here = value.convert and wire.convert
                    self.stated[wire.target] = replace(value, linear=linear, convert=convert_here)
        return {end: value for end, value in self.stated.items() if end[0].fmu}

    def _bindings(self, element: Element) -> None:
        for child in element.elements.values():
            self._bindings(child)
        for binding in find(element.xml, "ssd:ParameterBindings/ssd:ParameterBinding"):
            for name, value in self._binding(element, binding).items():
                self._assign(element, name, value)

    def _assign(self, element: Element, name: str, value: Stated) -> None:
        """Find the connector or variable behind a hierarchical name."""
        if name in element.connectors or (element.fmu and element.fmu.expand(name)):
            self.stated[element, name] = value
            return
        for own, child in element.elements.items():
            if name.startswith(f"{own}."):
                return self._assign(child, name.removeprefix(f"{own}."), value)
        known = [*element.connectors, *element.elements, *(element.fmu.base_names("parameter") if element.fmu else ())]
        close = difflib.get_close_matches(name, known, n=1, cutoff=0.8)
        if close:
            raise InputError(f"parameter '{name}': '{element.name}' has none; did you mean '{close[0]}'? {value.where}")

    def _binding(self, element: Element, xml: Any) -> dict[str, Stated]:
        if xml.get("type", "application/x-ssp-parameter-set") != "application/x-ssp-parameter-set":
            raise self.document.fail(f"a parameter source of type {xml.get('type')} is not supported", xml)
        document, sets = self._source(element, xml, "ssd:ParameterValues/ssv:ParameterSet", "ParameterSet")
        prefix, known = xml.get("prefix", ""), definitions(document)
        values = {}
        for entry in [p for s in sets for p in find(s, "ssv:Parameters/ssv:Parameter")]:
            values[prefix + entry.get("name")] = _stated(document, entry, known)
        for mapping in find(xml, "ssd:ParameterMapping"):
            source, mappings = self._source(element, mapping, "ssm:ParameterMapping", "ParameterMapping")
            values = _mapped(source, mappings, values)
        return values

    def _source(self, element: Element, xml: Any, inline: str, kind: str) -> tuple[Document, list[Any]]:
        """Where the content of a binding or mapping stands: in a file of its own, or inside."""
        name = xml.get("source")
        if name is None:
            return self.document, find(xml, inline)
        base: Path | None = None
        if xml.get("sourceBase") == "component":
            if element.fmu is None:
                raise self.document.fail("sourceBase 'component' has no meaning for a system", xml)
            base = element.fmu.folder
        file = self.archive.resolve(name, f"<{local(xml)}> {self.document.at(xml)}", base)
        document = Document(file, name if base else self.archive.shown(file), kind)
        return document, [document.root]


def _stated(document: Document, parameter: Any, known: Mapping[str, Definition]) -> Stated:
    typed = typed_child(parameter)
    name, where = parameter.get("name"), document.at(parameter)
    if typed is None:
        raise document.fail(f"parameter '{name}' has no value", parameter)
    texts = [entry.get("value") for entry in find(typed, "ssv:Value")]
    if not texts:
        text = typed.get("value", "")
        texts = text.split() if local(typed) not in ("String", "Enumeration") else [text]
    if not texts:
        raise document.fail(f"parameter '{name}' has no value", parameter)
    return Stated(tuple(texts), typed.get("unit"), known, where, listed=len(texts) > 1)


def _mapped(document: Document, mappings: list[Any], values: Mapping[str, Stated]) -> dict[str, Stated]:
    """Values under the names of the targets; what no entry mentions is dropped, as the standard wants it."""
    found = {}
    for entry in [e for m in mappings for e in find(m, "ssm:MappingEntry")]:
        value = values.get(entry.get("source"))
        if value is None:
            continue
        if entry.get("suppressUnitConversion") in ("true", "1"):
            value = replace(value, convert=False)
        table = [e for kind in MAPPINGS for e in find(entry, f"ssc:{kind}/ssc:MapEntry")]
        if table:
            value = replace(value, texts=tuple(map(_looked_up(document, entry, table), value.texts)))
        found[entry.get("target")] = replace(value, linear=value.linear.then(stated_linear(entry)))
    return found


def _looked_up(document: Document, entry: Any, table: list[Any]) -> Callable[[str], str]:
    rows = {_plain(row.get("source")): row.get("target") for row in table}

    def look_up(text: str) -> str:
        if _plain(text) not in rows:
            raise document.fail(f"mapping of '{entry.get('source')}': no entry for the value {text}", entry)
        return str(rows[_plain(text)])

    return look_up


def _plain(text: str) -> str:
    return {"1": "true", "0": "false"}.get(text, text)
