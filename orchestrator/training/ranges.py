"""What is drawn at a reset: ranges and lists as those of a sweep."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..errors import InputError
from ..studies.sweep.design.axis import checked_axis, listed, range_of
from ..studies.sweep.design.replanned import needs_plan
from ..system.model import System
from ..system.values import follows_tables

FORM = "low:high (or low:high:log, or a list)"


def applies_later(system: System, name: str) -> bool:
    """Whether it can be set in a state that was restored: an input, a tunable parameter."""
    component, _, variable = system.full_name(name).partition(".")
    fmu = system.components[component].fmu
    return all(follows_tables(fmu.variables[scalar]) for scalar in fmu.expand(variable))


class Drawn:
    """Values by name, drawn by a generator. Raises InputError for a name or a range that cannot be."""

    def __init__(self, system: System, ranges: Mapping[str, object]) -> None:
        self.names = list(ranges)
        self._lists = {name: listed(system, name, text) for name, text in ranges.items()}
        self._ranges = {}
        for name, text in ranges.items():
            entries = self._lists[name]
            if entries is None:
                found = self._ranges[name] = range_of(system, name, text, FORM, grid=False)
                entries = [found.low, found.high]
            checked = checked_axis(system, name, entries)
            if self._lists[name] is not None:
                self._lists[name] = list(checked.values)
            if needs_plan(system, name):
                raise InputError(f"randomise {name}: it changes the plan; make an environment for each of its values")

    def by(self, generator: np.random.Generator) -> dict[str, object]:
        """One value of each, in the order of the names."""
        found: dict[str, object] = {}
        for name in self.names:
            entries = self._lists[name]
            if entries is not None:
                found[name] = entries[int(generator.integers(len(entries)))]
            else:
                (found[name],) = self._ranges[name].at(np.array([generator.random()]))
        return found
