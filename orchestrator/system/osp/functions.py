"""The functions of an OspSystemStructure.xml: a linear transformation is part of a connection, a sum is a component."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from ...errors import InputError, shown
from ...fmu.outside.declared import Declared, DeclaredFmu, declared_fmu
from ...fmu.outside.model import Model
from ..ssp.units import IDENTITY, Linear
from .document import OspDocument, in_order, local

MOST = 10_000  # signals of a function


@dataclass(frozen=True)
class Function:
    """One function. `terms`: the signals that each output is the sum of."""

    name: str
    xml: Any
    terms: Mapping[str, tuple[str, ...]]
    linear: Linear = IDENTITY
    groups: bool = False  # its signals are connected in groups: in[0] is in[0][0], in[0][1], ...

    def signals(self, name: str, label: str) -> list[str]:
        """The signals behind a name: itself, or those of a group. Raises InputError."""
        every = [*self.terms, *(signal for terms in self.terms.values() for signal in terms)]
        found = [name] if name in every else [s for s in every if re.fullmatch(rf"{re.escape(name)}\[\d+\]", s)]
        if not found:
            some = ", ".join(dict.fromkeys(re.sub(r"\[\d+\]$", "[0]", s) if self.groups else s for s in every[:12]))
            raise InputError(f"{label}: the function '{self.name}' has no signal '{shown(name)}'; there are {some}")
        return found


def functions_of(document: OspDocument, elements: Iterable[Any]) -> dict[str, Function]:
    """All functions by name. Raises InputError."""
    found: dict[str, Function] = {}
    for element in elements:
        for xml in in_order(element, "LinearTransformation", "Sum", "VectorSum"):
            name = str(xml.get("name"))
            if name in found:
                raise document.fail(f"there are two functions '{shown(name)}'", xml)
            found[name] = _function(document, name, xml)
    return found


def _function(document: OspDocument, name: str, xml: Any) -> Function:
    label = f"function '{shown(name)}'"
    if local(xml) == "LinearTransformation":
        factor = document.number(xml.get("factor") or "", f"{label}: factor", xml, 1.0)
        offset = document.number(xml.get("offset") or "", f"{label}: offset", xml, 0.0)
        return Function(name, xml, {"out": ("in",)}, Linear(factor, offset))
    count = _count(document, xml, "inputCount", label)
    if local(xml) == "Sum":
        return Function(name, xml, {"out": tuple(f"in[{i}]" for i in range(count))})
    size = _count(document, xml, "dimension", label)
    if count * size > MOST:
        raise document.fail(f"{label}: {count} inputs of {size} signals are more than {MOST}", xml)
    terms = {f"out[{j}]": tuple(f"in[{i}][{j}]" for i in range(count)) for j in range(size)}
    return Function(name, xml, terms, groups=True)


def _count(document: OspDocument, xml: Any, attribute: str, label: str) -> int:
    text = (xml.get(attribute) or "").strip()
    if not re.fullmatch(r"[0-9]{1,5}", text) or not 1 <= int(text) <= MOST:
        raise document.fail(f"{label}: {attribute} = '{shown(text)}' is no number from 1 to {MOST}", xml)
    return int(text)


class Sum(Model):
    """Outputs that are sums of inputs, at once; it has no state."""

    def __init__(self, starts: Mapping[str, float], terms: Mapping[str, tuple[str, ...]]) -> None:
        super().__init__(starts)
        self.terms = terms

    def get(self, names: Iterable[str]) -> list[float]:
        return [
            sum(self.values[term] for term in self.terms[name]) if name in self.terms else self.values[name]
            for name in names
        ]


def sum_fmu(name: str, terms: Mapping[str, tuple[str, ...]]) -> DeclaredFmu:
    """A component that adds; `terms`: the inputs of each output."""
    inputs = [Declared(term, "input") for several in terms.values() for term in several]
    variables = [*inputs, *(Declared(output, "output") for output in terms)]
    path, model = Path(f"{name} (sum)"), partial(Sum, terms=terms)
    return declared_fmu(name, variables, path, "sum", model=model, feedthrough=terms)  # type: ignore[no-any-return]
