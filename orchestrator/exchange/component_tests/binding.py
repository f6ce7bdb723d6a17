"""Which of their variables stands for one of ours, and how its numbers convert."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.fmu import Fmu
from ...fmu.types import REALS
from ...system.replace.crossing import Crossing, crossing
from ...system.replace.mapping import VariableMapping
from ...units import Unit, left_open
from .opened import whole_variables
from .suites import Declared

WHOLES = ("Integer", "Enumeration", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64")


@dataclass(frozen=True)
class Binding:
    """One of our variables in their FMU: one array variable of theirs, or one scalar per element of ours."""

    ours: Declared
    theirs: tuple[ModelVariable, ...]
    crossings: tuple[Crossing, ...]  # one per element
    negated: tuple[bool, ...] = ()  # of theirs, which lie behind their references with the other sign (FMI 1.0)

    @property
    def name(self) -> str:
        """What they call it."""
        first = self.theirs[0].name
        return first if len(self.theirs) == 1 else f"{first} ... {self.theirs[-1].name}"

    @property
    def references(self) -> list[int]:
        return [v.valueReference for v in self.theirs]

    @property
    def type(self) -> str:
        return str(self.theirs[0].type)

    def there(self, value: Any) -> list[Any]:
        """Our value, element by element, as theirs in their type."""
        elements = np.broadcast_to(np.asarray(value, dtype=float).ravel(), len(self.crossings))
        numbers = [c.there(float(x)) for c, x in zip(self.crossings, elements, strict=True)]
        if self.type in REALS:
            return numbers
        return [bool(x) for x in numbers] if self.type == "Boolean" else [round(x) for x in numbers]

    def back(self, values: Sequence[Any]) -> Any:
        """Their values as ours: a number, or an array where ours has a size."""
        numbers = [c.back(float(x)) for c, x in zip(self.crossings, values, strict=True)]
        if self.ours.size:
            return np.array(numbers)
        return round(numbers[0]) if self.ours.kind == "Integer" else numbers[0]

    def turned(self, values: Sequence[Any]) -> list[Any]:
        """Their values as they lie behind the references, or back."""
        if not any(self.negated):
            return list(values)
        return [-x if negated else x for x, negated in zip(values, self.negated, strict=True)]

    def starts(self) -> list[float] | None:
        """Their start values, or None where one is not stated."""
        found: list[float] = []
        for v in self.theirs:
            words = str(v.start).split() if v.start is not None else []
            if not words:
                return None
            numbers = [{"true": 1.0, "false": 0.0}.get(word) for word in words]
            found += [float(w) if x is None else x for w, x in zip(words, numbers, strict=True)]
        return found * (len(self.crossings) if len(found) == 1 else 1)


def elements_of(v: ModelVariable) -> int:
    """How many numbers an FMI variable holds."""
    return math.prod(v.shape) if v.shape else 1


def bind(ours: Declared, fmu: Fmu, mapping: VariableMapping) -> Binding | None:
    """Their variable for one of ours; None if they have none. Raises InputError if sizes or units do not fit."""
    found, known = [], whole_variables(fmu)
    for name in [ours.name, *([f"{ours.name}[{k + 1}]" for k in range(ours.size)] if ours.size else [])]:
        entry = mapping.entry(name)
        v = None if entry.absent else known.get(entry.name)
        if v is not None:
            found.append((v, entry))
            if name == ours.name:
                break
    if not found:
        return None
    count = sum(elements_of(v) for v, _ in found)
    if count != max(ours.size, 1):
        raise InputError(f"it has {count} elements, {max(ours.size, 1)} are expected")
    crossings = []
    for v, entry in found:
        # FMI 1.0 and 2.0 write units on numbers with decimals only.
        own = v.unit or (None if v.type in REALS else ours.unit)
        theirs = Unit(own, fmu.definitions.get(own), bool(v.relativeQuantity)) if own else None
        said = Unit(entry.unit, None, bool(v.relativeQuantity)) if entry.unit else None
        if said and theirs and said.name != theirs.name and not left_open(theirs, said):
            raise InputError(f"the mapping says {said}, their FMU says {theirs} {entry.where}")
        meant = theirs if said is None or (theirs and theirs.name == said.name) else said
        crossings += [crossing(v.name, ours.unit, meant, entry.sign, ours.name)] * elements_of(v)
    negated = tuple(v.name in fmu.negated for v, _ in found)
    return Binding(ours, tuple(v for v, _ in found), tuple(crossings), negated)
