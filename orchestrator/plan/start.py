"""The order in which values propagate at time 0: connections one by one, and algebraic loops as wholes.

A connection needs another one first if its output depends, at initialization, on the other's input (InitialUnknowns of
the model description). Strongly connected sets of connections are the algebraic loops.
"""

from __future__ import annotations

from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

from ..system.model import Connection, System


@dataclass(frozen=True)
class Block:
    """One connection, or all connections of one algebraic loop."""

    connections: tuple[Connection, ...]
    loop: bool

    @property
    def label(self) -> str:
        """The connection, or the inputs of the loop."""
        if not self.loop:
            return self.connections[0].label
        return f"loop {', '.join('.'.join(c.target) for c in self.connections)}"


def start_order(system: System) -> tuple[Block, ...]:
    """Blocks in an order in which each finds what it needs."""
    needs = _needs(system)
    try:
        order = list(TopologicalSorter(needs).static_order())
        return tuple(Block((system.connections[k],), False) for k in order)
    except CycleError:
        return _with_loops(system, needs)


def _needs(system: System) -> dict[int, list[int]]:
    """For each connection, by its position, those that must come before it."""

    known = {name: component.fmu.feedthrough(initial=True) for name, component in system.components.items()}
    answers = {c.source: known[c.source[0]][c.source[1]] for c in system.connections}
    into: dict[str, list[int]] = {}
    for k, c in enumerate(system.connections):
        into.setdefault(c.target[0], []).append(k)
    return {
        k: [j for j in into.get(c.source[0], ()) if system.connections[j].target[1] in answers[c.source]]
        for k, c in enumerate(system.connections)
    }


def _with_loops(system: System, needs: dict[int, list[int]]) -> tuple[Block, ...]:
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    pairs = [(k, j) for k, before in needs.items() for j in before]
    rows, columns = zip(*pairs, strict=True)
    graph = coo_array(([1] * len(pairs), (rows, columns)), shape=(len(needs), len(needs)))
    labels = connected_components(graph, directed=True, connection="strong")[1].tolist()
    members: dict[int, list[int]] = {}
    for k, label in enumerate(labels):
        members.setdefault(label, []).append(k)
    between = {label: {labels[j] for k in group for j in needs[k]} - {label} for label, group in members.items()}
    blocks = []
    for label in TopologicalSorter(between).static_order():
        group = members[label]
        loop = len(group) > 1 or group[0] in needs[group[0]]
        blocks.append(Block(tuple(system.connections[k] for k in group), loop))
    return tuple(blocks)
