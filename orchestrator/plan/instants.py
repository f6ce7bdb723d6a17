"""What is true at an instant: which inputs are given the value of their instant, and which outputs are read again.

An output that answers at once to an input (ModelStructure) is as old as that input. Where a held input is new at the
end of a step, it is set and the output is read again, in the order of direct dependence: the value *after*. An input
that is averaged, extrapolated, interpolated, iterated, from a table or from a sampler keeps what it held.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np

from ..loop.operations import AT_AN_INSTANT, GET
from ..system.component import Component
from ..system.connection import Connection
from ..system.model import System
from .schedule.formulas import Choice
from .schedule.layout import Key
from .start import Block, blocks_of

Known = frozenset[str]  # components that have made their step to an instant


class Instants:
    """The held connections on which outputs depend at once, and the order in which they take their values."""

    def __init__(
        self, system: System, choices: Mapping[Connection, Choice], early: Collection[str], used: Collection[Key]
    ) -> None:
        """`early`: components whose step is done at its beginning; `used`: outputs that are sent or recorded."""
        self.answers = {name: direct_answers(system, name) for name in system.components}
        self.system = system
        answering: dict[str, set[frozenset[str]]] = {}  # many outputs depend on one set of inputs
        for name, output in used:
            answering.setdefault(name, set()).add(self.answers[name].get(output, frozenset()))
        asked = {name: frozenset[str]().union(*sets) for name, sets in answering.items()}
        self.held = tuple(
            c
            for c, choice in choices.items()
            if choice.transfer == "hold"
            and not {c.source[0], c.target[0]} & set(early)
            and c.target[1] in asked.get(c.target[0], ())
        )
        self.cuts: dict[Connection, str] = {}  # connections at which a loop is cut, and which
        self._blocks: dict[Known, tuple[Block, ...]] = {}

    def blocks(self, known: Known) -> tuple[Block, ...]:
        """The connections between components of `known`, each behind those that it needs; loops as wholes."""
        if known not in self._blocks:
            connections = [c for c in self.held if c.source[0] in known and c.target[0] in known]
            self._blocks[known] = self._cut(connections)
        return self._blocks[known]

    def _cut(self, connections: list[Connection]) -> tuple[Block, ...]:
        """Their blocks; a loop through what is no floating-point signal is cut at its last such connection."""
        while True:
            blocks = blocks_of(connections, self.answers) if connections else ()
            for block in blocks:
                whole = [c for c in block.connections if not self.system.is_real(c)] if block.loop else []
                if whole:
                    self.cuts[whole[-1]] = block.label
                    connections.remove(whole[-1])
                    break
            else:
                return blocks

    def answering(self, name: str) -> frozenset[str]:
        """The outputs of a component that are read again: those that answer, of an array all elements."""
        inputs = {c.target[1] for c in self.held if c.target[0] == name}
        found = [output for output, known in self.answers[name].items() if known & inputs] if inputs else []
        arrays = self.system.components[name].fmu.arrays
        return frozenset(element for output in found for element in arrays[output])

    def reasons(self) -> dict[str, str]:
        """The inputs to which outputs of a component answer at once, by component."""
        found: dict[str, list[str]] = {}
        for c in self.held:
            found.setdefault(c.target[0], []).append(c.target[1])
        return {name: ", ".join(inputs) for name, inputs in found.items()}

    def read_again(self, cycle: np.ndarray) -> dict[str, str]:
        """Components that the operations of a cycle read again at an instant, and the inputs because of which."""
        names = list(self.system.components)
        found = {names[c] for c in cycle[(cycle[:, 0] == GET) & (cycle[:, 3] == AT_AN_INSTANT), 2].tolist()}
        return {name: inputs for name, inputs in self.reasons().items() if name in found}


def direct_answers(system: System, name: str) -> dict[str, frozenset[str]]:
    """For each output of a component the inputs to which it answers at once while stepping.

    What ModelStructure states; nothing where it states nothing. `direct = "all"` of the component assumes all, `"off"`
    none: it forbids reading again.
    """
    component = system.components[name]
    if component.at_events:  # what is exchanged in event mode is not read again by the loop
        return {
            output: inputs - component.at_events if output not in component.at_events else frozenset()
            for output, inputs in _answers(component).items()
        }
    return _answers(component)


def _answers(component: Component) -> dict[str, frozenset[str]]:
    if component.direct != "stated":
        inputs = frozenset(component.fmu.names("input") if component.direct == "all" else ())
        return dict.fromkeys(component.fmu.names("output"), inputs)
    return component.fmu.feedthrough(unstated=False)
