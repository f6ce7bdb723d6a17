"""On which states the derivatives of a group depend, as the model descriptions state it: the band of its Jacobian."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ...fmu.fmu import Fmu
from ...fmu.reading.states import derivatives_of, state_names

Key = tuple[int, str]  # member, variable
FEW = 12  # states, up to which a band is not worth while
WORTH = 3  # a band is narrower than the Jacobian by this factor


def _elements(fmu: Fmu, name: str) -> list[str]:
    return fmu.own.expand(name)


def bands_of(fmus: Sequence[Fmu], sources: Mapping[Key, Key]) -> tuple[int, int] | None:
    """How far below and above the diagonal the Jacobian reaches; None where that is not stated, or not worth while.

    `sources`: the output behind each connected input.
    """
    places: dict[Key, int] = {}
    for m, fmu in enumerate(fmus):
        for name in state_names(fmu):
            places[m, name] = len(places)
    n = len(places)
    if n <= FEW or any(fmu.version == 1 for fmu in fmus):  # which says nothing of its states
        return None
    behind = _Behind(fmus, sources, places)
    lower = upper = row = 0
    for m, fmu in enumerate(fmus):
        for unknown, state in derivatives_of(fmu):
            found = behind.states(m, unknown)
            if found is None:
                return None
            for _ in _elements(fmu, state.name):
                if found:
                    lower, upper = max(lower, row - min(found)), max(upper, max(found) - row)
                row += 1
    return (lower, upper) if (lower + upper + 1) * WORTH < n else None


class _Behind:
    """The states behind derivatives and outputs, through connected inputs."""

    def __init__(self, fmus: Sequence[Fmu], sources: Mapping[Key, Key], places: Mapping[Key, int]) -> None:
        self.fmus, self.sources, self.places = fmus, sources, places
        self.outputs = [{u.variable.name: u for u in fmu.own.description.outputs} for fmu in fmus]

    def states(self, member: int, unknown: Any) -> set[int] | None:
        """Of a derivative or an output; None where something is not stated."""
        found: set[int] = set()
        waiting, seen = [(member, unknown)], set()
        while waiting:
            m, one = waiting.pop()
            if one is None or one.dependencies is None:
                return None
            for variable in one.dependencies:
                for name in _elements(self.fmus[m], variable.name):
                    if (m, name) in self.places:
                        found.add(self.places[m, name])
                    source = self.sources.get((m, name))
                    if source and source not in seen:
                        seen.add(source)
                        owner = source[1].split("[")[0] if source[1] not in self.outputs[source[0]] else source[1]
                        waiting.append((source[0], self.outputs[source[0]].get(owner)))
        return found
