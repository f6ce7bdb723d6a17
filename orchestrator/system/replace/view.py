"""Somebody else's FMU as the system sees it: our names, units and directions, its variables behind them.

What runs it calls it by its own names (`Fmu.own`); what plans and records speaks of ours.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ...fmu.variables import Place
from ...units import Definition, Unit
from .crossing import Crossing

OWN = "theirs."  # what stands in front of the names of their variables that we do not know


@dataclass(frozen=True)
class View(Fmu):
    """An FMU in the place of a component: the variables that the system sees, and where they cross to its own."""

    presented: tuple[ModelVariable, ...] = ()
    crossings: Mapping[str, Crossing] = field(default_factory=dict)
    ours: Mapping[str, Definition] = field(default_factory=dict)  # what the units of our variables mean

    @classmethod
    def of(cls, fmu: Fmu, presented: tuple[ModelVariable, ...], crossings: Mapping[str, Crossing], ours: Fmu) -> View:
        """`fmu` in the place of `ours`, under the names of `presented`; each of them has a crossing."""
        same = {f.name: getattr(fmu.own, f.name) for f in fields(Fmu)}
        return cls(**same, presented=presented, crossings=crossings, ours=ours.definitions)

    @cached_property
    def own(self) -> Fmu:
        return Fmu(**{f.name: getattr(self, f.name) for f in fields(Fmu)})

    def own_name(self, name: str) -> str:
        return self.crossings[name].name

    def to_own(self, name: str, value: Value) -> Value:
        return self.crossings[name].there(value) if isinstance(value, float) else value

    def from_own(self, name: str, value: Value) -> Value:
        return self.crossings[name].back(value) if isinstance(value, float) else value

    def unit_called(self, unit: str, name: str) -> Unit:
        known = self.definitions if name.startswith(OWN) else self.ours
        return Unit(unit, known.get(unit), bool(self.variables[name].relativeQuantity))

    @cached_property
    def variables(self) -> dict[str, ModelVariable]:
        """The variables that the system sees, by its names."""
        return {v.name: v for v in self.presented}

    @cached_property
    def places(self) -> dict[str, Place]:
        return {name: self.own.places[crossing.name] for name, crossing in self.crossings.items()}

    @cached_property
    def aliases(self) -> dict[str, str]:
        """None: a variable of ours is one of theirs, by whichever name."""
        return {}

    @cached_property
    def arrays(self) -> dict[str, list[str]]:
        return {name: self._together(name) for name in self.crossings}

    def feedthrough(self, initial: bool = False, unstated: bool = True) -> dict[str, frozenset[str]]:
        known = self.own.feedthrough(initial, unstated)
        return {
            name: frozenset(self._ours[x] for x in known[self.crossings[name].name] if x in self._ours)
            for name in self.names("output")
        }

    @cached_property
    def _ours(self) -> dict[str, str]:
        """Names in the system by the FMU's own."""
        return {crossing.name: name for name, crossing in self.crossings.items()}

    def _together(self, name: str) -> list[str]:
        theirs = self.own.arrays[self.crossings[name].name]
        lacking = [x for x in theirs if x not in self._ours]
        if lacking:
            raise InputError(
                f"{self.path.name}: '{lacking[0]}' belongs to the same array as '{self.crossings[name].name}' and is "
                f"not mapped; map the whole array"
            )
        return [self._ours[x] for x in theirs]


def crossings_of(fmu: Fmu) -> Mapping[str, Crossing]:
    """How its variables cross, where an FMU stands in a component's place; nothing for any other."""
    return fmu.crossings if isinstance(fmu, View) else {}
