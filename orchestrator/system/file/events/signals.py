"""What events may name, numbers that they state, and how their errors are made."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from ....errors import InputError
from ....fmu.attributes import is_number
from ...component import Component
from ...connection import Connection
from ...event import Key

Fail = Callable[..., InputError]  # from a message and the word that it is about


@dataclass(frozen=True)
class Signals:
    """What events may name."""

    components: Mapping[str, Component]
    drivers: Mapping[Key, Connection]

    def scalars(self, name: str) -> list[Key]:
        """The scalars behind `component.variable`; none where there is no such variable."""
        owner, _, variable = name.partition(".")
        known = self.components.get(owner)
        return [(owner, scalar) for scalar in (known.fmu.expand(variable) if known else ())]

    def names(self, *causalities: str) -> list[str]:
        return [f"{c.name}.{v}" for c in self.components.values() for v in c.fmu.base_names(*causalities)]

    def causality(self, key: Key) -> str:
        return str(self.components[key[0]].fmu.variables[key[1]].causality)

    def is_real(self, key: Key) -> bool:
        return self.components[key[0]].fmu.is_real(key[1])


def number(value: object) -> float | None:
    """A finite number; None for whatever else it is."""
    text = str(value)
    number = float(text) if not isinstance(value, bool) and is_number(text) else math.nan
    return number if math.isfinite(number) else None
