"""Parameter sets of an SSP: values from SSV files or inline, mapped, and brought to the variables of the FMUs.

An outer system's value goes before an inner one's, a later binding before an earlier one. A name that no variable has
is passed over, as the standard wants it for sets that serve several systems; one that is nearly a variable's is told.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...errors import InputError, shown
from ...fmu.fmu import Fmu
from ...fmu.reading.structure import STRUCTURAL
from ..file.structure import is_structural, with_structure
from .files.document import Document, find, local
from .files.rules import EMPTY
from .structure import Binding, Element
from .units import definitions, stated_linear, stated_table
from .values import Stated, stated_value
from .wires import End, Wire

SET, MAPPING = "application/x-ssp-parameter-set", "application/x-ssp-parameter-mapping"


class Parameters:
    """Collects what the bindings of all systems and components state. `passed_over`: names that nothing has."""

    def __init__(self, wires: Mapping[End, Wire]) -> None:
        self.wires = wires
        self.stated: dict[End, Stated] = {}
        self.passed_over: dict[str, str] = {}

    def collect(self, root: Element) -> dict[End, Stated]:
        """The values of all variables of components, by component and variable."""
        self._bindings(root)
        for system in root.systems():  # outer before inner
            for wire in self.wires.values():
                value = self.stated.get(wire.source)
                if value and wire.source[0] is system:
                    linear = value.linear.then(wire.linear)
                    convert_here = value.convert and wire.convert
                    self.stated[wire.target] = replace(value, linear=linear, convert=convert_here)
        return {end: value for end, value in self.stated.items() if end[0].fmu}

    def sized(self, element: Element) -> Fmu:
        """The FMU of a component with the structural parameters that are bound to the component itself."""
        fmu = element.fmu
        assert fmu
        if not fmu.names(STRUCTURAL):
            return fmu
        stated: list[tuple[str, object, str]] = []
        for binding in element.bindings:
            for name, value in self._binding(element, binding).items():
                if is_structural(fmu, name):
                    stated.append((name, value.value(element, name), value.where))
        return with_structure(element.name, fmu, stated)

    def _bindings(self, element: Element) -> None:
        for child in element.elements.values():
            self._bindings(child)
        for binding in element.bindings:
            for name, value in self._binding(element, binding).items():
                if not self._assign(element, name, value):
                    self.passed_over[name] = f"{_near(element, name)} {value.where}".strip()

    def _assign(self, element: Element, name: str, value: Stated) -> bool:
        """Give a value to the connector or variable behind a hierarchical name; False where there is none."""
        if name in element.connectors or (element.fmu and element.fmu.expand(name)):
            self.stated[element, name] = value
            return True
        return any(
            self._assign(child, name.removeprefix(f"{own}."), value)
            for own, child in element.elements.items()
            if name.startswith(f"{own}.") and not child.signals
        )

    def _binding(self, element: Element, binding: Binding) -> dict[str, Stated]:
        xml = binding.xml
        if (xml.get("type") or SET) != SET:
            raise binding.document.fail(f"a parameter source of type {shown(xml.get('type'))} is not supported", xml)
        document, sets = _content(element, binding, xml, "ParameterValues/ParameterSet", "ParameterSet")
        prefix, values = xml.get("prefix", ""), {}
        for set_ in sets:
            known = definitions(document, set_)
            for entry in find(set_, "Parameters/Parameter"):
                values[prefix + entry.get("name")] = stated_value(document, entry, known)
        for mapping in find(xml, "ParameterMapping"):
            if (mapping.get("type") or MAPPING) != MAPPING:
                raise binding.document.fail(f"a mapping of type {shown(mapping.get('type'))} is not supported", mapping)
            source, mappings = _content(element, binding, mapping, "ParameterMapping", "ParameterMapping")
            if mappings:
                values = _mapped(source, mappings, values)
            else:
                source.notes.add(EMPTY, f"<ParameterMapping> {binding.document.at(mapping)}")
        return values


def _near(element: Element, name: str) -> str:
    """The name that was meant, where there is one like it."""
    known = [*element.connectors, *element.elements, *(element.fmu.base_names("parameter") if element.fmu else ())]
    close = difflib.get_close_matches(name, known, n=1, cutoff=0.8)
    return f"(did you mean '{close[0]}'?)" if close else ""


def _content(element: Element, binding: Binding, xml: Any, inline: str, kind: str) -> tuple[Document, list[Any]]:
    """Where the content of a binding or mapping stands: in a file of its own, or inside."""
    name = (xml.get("source") or "").strip()
    if not name:
        return binding.document, find(xml, inline)
    base: Path | None = None
    if xml.get("sourceBase") == "component":
        if element.fmu is None and element.archive is binding.archive:
            raise binding.document.fail("sourceBase 'component' has no meaning for a system", xml)
        base = element.fmu.folder if element.fmu else element.archive.root
    label = f"<{local(xml)}> {binding.document.at(xml)}"
    file = binding.archive.resolve(name, label, binding.document.notes, base)
    document = Document(file, name if base else binding.archive.shown(file), kind, binding.document.notes)
    return document, [document.root]


def _mapped(document: Document, mappings: list[Any], values: Mapping[str, Stated]) -> dict[str, Stated]:
    """Values under the names of the targets; what no entry mentions is dropped, as the standard wants it."""
    found = {}
    for entry in [e for m in mappings for e in find(m, "MappingEntry")]:
        if not entry.get("source") or not entry.get("target"):
            document.notes.add(EMPTY, f"<MappingEntry> {document.at(entry)}")
            continue
        value = values.get(entry.get("source"))
        if value is None:
            continue
        if entry.get("suppressUnitConversion") in ("true", "1"):
            value = replace(value, convert=False)
        table = stated_table(entry)
        if table:
            value = replace(value, texts=tuple(map(_looked_up(document, entry, table), value.texts)))
        found[entry.get("target")] = replace(value, linear=value.linear.then(stated_linear(entry)))
    return found


def _looked_up(document: Document, entry: Any, table: list[Any]) -> Callable[[str], str]:
    rows = {_plain(row.get("source")): row.get("target") for row in table}

    def look_up(text: str) -> str:
        if _plain(text) not in rows:
            message = f"mapping of '{shown(entry.get('source'))}': no entry for the value {shown(text)}"
            raise InputError(f"{message} {document.at(entry)}")
        return str(rows[_plain(text)])

    return look_up


def _plain(text: str) -> str:
    return {"1": "true", "0": "false"}.get(text, text)
