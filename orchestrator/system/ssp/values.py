"""One value of a parameter set: as the file states it, and as the variable takes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ...errors import InputError, shown
from ...fmu.attributes import items_of
from ...units import Definition, Unit
from .files.document import Document, find, local, typed_child
from .structure import Element
from .units import IDENTITY, Linear, converted


@dataclass(frozen=True)
class Stated:
    """A value as a file states it, and what is done to it before it is set."""

    texts: tuple[str, ...]  # more than one: an array
    unit: str | None
    known: Mapping[str, Definition]
    document: Document
    where: str
    linear: Linear = IDENTITY
    convert: bool = True
    listed: bool = False
    items: Mapping[str, str] = field(default_factory=dict)  # of the enumeration that it names

    def value(self, element: Element, variable: str) -> Any:
        """As the FMU takes it: text (the reader checks it), a number where one was computed, or a list."""
        assert element.fmu
        scalar = element.fmu.expand(variable)[0]
        v = element.fmu.variables[scalar]
        label = f"{element.name}.{variable} {self.where}"
        unit = IDENTITY
        if self.convert and self.unit:
            stated = Unit(self.unit, self.known.get(self.unit), bool(v.relativeQuantity))
            unit = converted(stated, element.fmu.unit(scalar), self.document.notes, label, self.where)
        linear, own = unit.then(self.linear), items_of(v)
        items = {**self._connector_items(element, variable), **self.items, **{k: str(n) for k, n in own.items()}}
        texts: list[Any] = [text if v.type in ("String", "Binary") else items.get(text, text) for text in self.texts]
        if linear != IDENTITY:
            try:
                texts = [linear.factor * float(text) + linear.offset for text in texts]
            except ValueError:
                raise InputError(f"{label}: {shown(self.texts[0])!r} is no number to convert") from None
        return texts if self.listed else texts[0]

    def _connector_items(self, element: Element, variable: str) -> Mapping[str, str]:
        """The items of the enumeration that the variable's connector names."""
        connector = element.connectors.get(variable)
        return element.document.enumerations.get(connector.enumeration, {}) if connector else {}


def stated_value(document: Document, parameter: Any, known: Mapping[str, Definition]) -> Stated:
    """Raises InputError for a parameter without a value."""
    typed = typed_child(parameter)
    name, where = parameter.get("name"), document.at(parameter)
    if typed is None:
        raise document.fail(f"parameter '{shown(name)}' has no value", parameter)
    texts = [entry.get("value", "") for entry in find(typed, "Value")]
    if not texts:
        text = typed.get("value", "")
        texts = text.split() if local(typed) not in ("String", "Enumeration", "Binary") else [text]
    if not texts:
        raise document.fail(f"parameter '{shown(name)}' has no value", parameter)
    items = document.enumerations.get(typed.get("name", ""), {}) if local(typed) == "Enumeration" else {}
    unit = typed.get("unit") or None
    return Stated(tuple(texts), unit, known, document, where, listed=len(texts) > 1, items=items)
