"""The order in which values propagate at time 0: connections one by one, and algebraic loops as wholes.

A connection needs others first if its output depends, at initialization, on their inputs (InitialUnknowns of the model
description). Strongly connected sets of connections are the algebraic loops. What an output depends on is one set for
many outputs where the description says nothing of them, so it is a node of its own in the graph: connections need
sets, sets need connections, and the graph stays as large as what is stated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush

from ..extras import needed as require_library
from ..system.connection import Connection
from ..system.model import System

LOOPED = "an algebraic loop at the start"

Answers = Mapping[str, Mapping[str, frozenset[str]]]  # by component and output: the inputs on which it depends at once


NAMED = 8  # inputs of a loop that its label names
WHOLE = 30  # inputs up to which all of a loop are unknowns: every start value counts, and passes are few anyway


@dataclass(frozen=True)
class Block:
    """One connection, or all connections of one algebraic loop.

    `torn`: connections of a loop whose values, if they were known, would give those of `behind` one after the other.
    """

    connections: tuple[Connection, ...]
    loop: bool
    torn: tuple[Connection, ...] = ()
    behind: tuple[Connection, ...] = ()

    @property
    def label(self) -> str:
        """The connection, or the inputs of the loop, the first of them where there are many."""
        if not self.loop:
            return self.connections[0].label
        more = len(self.connections) - NAMED
        inputs = ", ".join(".".join(c.target) for c in self.connections[:NAMED])
        return f"loop {inputs}" + (f" and {more} more" if more > 0 else "")


def start_order(system: System) -> tuple[Block, ...]:
    """The blocks of all connections at time 0.

    An FMU of FMI 1.0 can be read only when it is initialized, so all its inputs come first. Where that would close a
    loop, it is initialized with the start values of what it is not given yet, and given it at once: its outputs depend
    on what they state then.
    """
    fmus = {name: component.fmu for name, component in system.components.items()}
    answers = {name: fmu.feedthrough(initial=True) for name, fmu in fmus.items()}
    blocks = blocks_of(system.connections, answers)
    looped = {c.source[0] for block in blocks if block.loop for c in block.connections}
    unprepared = {name: fmus[name].feedthrough() for name in looped if fmus[name].version == 1}
    return blocks_of(system.connections, answers | unprepared) if unprepared else blocks


def blocks_of(connections: Sequence[Connection], answers: Answers) -> tuple[Block, ...]:
    """Blocks in an order in which each finds what it needs; `answers`: on which inputs each output depends."""
    set_of, members = _needs(connections, answers)
    order = _by_levels({k: [set_of[k]] if members[set_of[k]] else [] for k in range(len(set_of))}, members)
    if order is None:
        return _with_loops(connections, set_of, members)
    return tuple(Block((connections[k],), False) for k in order)


def _needs(connections: Sequence[Connection], known: Answers) -> tuple[list[int], list[list[int]]]:
    """For each connection, by its position, the set that must come before it; the members of every set."""
    into: dict[str, dict[str, int]] = {}
    for k, c in enumerate(connections):
        into.setdefault(c.target[0], {})[c.target[1]] = k
    numbers: dict[tuple[str, frozenset[str]], int] = {}
    set_of: list[int] = []
    members: list[list[int]] = []
    for c in connections:
        name, answers = c.source[0], known[c.source[0]][c.source[1]]
        if (name, answers) not in numbers:
            numbers[name, answers] = len(members)
            driven = into.get(name, {})
            members.append(sorted(driven[variable] for variable in driven.keys() & answers))
        set_of.append(numbers[name, answers])
    return set_of, members


def _by_levels(sets_of: Mapping[int, Sequence[int]], members: Sequence[Sequence[int]]) -> list[int] | None:
    """Nodes, each behind all members of its sets: those that need nothing, those that need only these, and so on, one
    that waits for less before one that waits for more. None if there is a cycle."""
    waiting = {node: len(sets) for node, sets in sets_of.items()}
    missing = [len(found) for found in members]
    sets_with: dict[int, list[int]] = {}
    for number, found in enumerate(members):
        for node in found:
            sets_with.setdefault(node, []).append(number)
    waiting_for: dict[int, list[int]] = {}
    for node, sets in sets_of.items():
        for number in sets:
            waiting_for.setdefault(number, []).append(node)
    order: list[int] = []
    level = [node for node in _mentioned(sets_of, members) if not waiting[node]]
    while level:
        order += level
        following: list[int] = []
        for node in level:
            ready = []
            for number in sets_with.get(node, ()):
                missing[number] -= 1
                for other in waiting_for.get(number, ()) if not missing[number] else ():
                    waiting[other] -= 1
                    if not waiting[other]:
                        ready.append(other)
            following += sorted(ready)
        level = following
    return order if len(order) == len(sets_of) else None


def _mentioned(sets_of: Mapping[int, Sequence[int]], members: Sequence[Sequence[int]]) -> list[int]:
    """All nodes, what one needs behind it."""
    found: dict[int, None] = {}
    opened: set[int] = set()
    for node, sets in sets_of.items():
        found[node] = None
        for number in sets:
            if number not in opened:
                opened.add(number)
                found |= dict.fromkeys(members[number])
    return list(found)


def _with_loops(
    connections: Sequence[Connection], set_of: Sequence[int], members: Sequence[Sequence[int]]
) -> tuple[Block, ...]:
    """As `start_order`, where some connections need each other."""
    require_library("scipy", LOOPED)
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    n = len(set_of)
    pairs = [(k, n + number) for k, number in enumerate(set_of)]
    pairs += [(n + number, k) for number, found in enumerate(members) for k in found]
    rows, columns = zip(*pairs, strict=True)
    graph = coo_array(([1] * len(pairs), (rows, columns)), shape=(n + len(members),) * 2)
    labels = connected_components(graph, directed=True, connection="strong")[1].tolist()
    numbers = {label: number for number, label in enumerate(dict.fromkeys(labels[:n]))}
    groups: list[list[int]] = [[] for _ in numbers]
    for k in range(n):
        groups[numbers[labels[k]]].append(k)
    inside = [numbers.get(labels[n + number], -1) for number in range(len(members))]  # the loop that a set is part of
    between = [[numbers[label] for label in sorted({labels[k] for k in found})] for found in members]
    between += [
        [x for x in found if x != own] for found, own in zip(between, inside, strict=True)
    ]  # for the loop itself
    sets_of = {}
    for number, group in enumerate(groups):
        needed = dict.fromkeys(set_of[k] + len(members) * (inside[set_of[k]] == number) for k in group)
        sets_of[number] = [x for x in needed if between[x]]
    order = _by_levels(sets_of, between)
    assert order is not None
    blocks = []
    for number in order:
        group = groups[number]
        loop = len(group) > 1 or labels[group[0]] == labels[n + set_of[group[0]]]
        torn = _torn(group, set_of, members) if len(group) > WHOLE else (group, [])
        ways = torn if loop else ([], [])
        parts = [tuple(connections[k] for k in way) for way in ways]
        blocks.append(Block(tuple(connections[k] for k in group), loop, *parts))
    return tuple(blocks)


def _torn(group: Sequence[int], set_of: Sequence[int], members: Sequence[Sequence[int]]) -> tuple[list[int], list[int]]:
    """Connections of a loop without which there would be none, and the others in an order in which each finds what it
    needs. Always torn is the first that the set which misses least is waiting for; the fewest cannot be had in bounded
    time (the minimum feedback vertex set is NP-complete: Karp 1972)."""
    inside = set(group)
    missing = {number: inside.intersection(members[number]) for number in dict.fromkeys(set_of[k] for k in group)}
    needs: dict[int, list[int]] = {}
    waiting: dict[int, list[int]] = {}
    for number, found in missing.items():
        for k in found:
            needs.setdefault(k, []).append(number)
    for k in group:
        waiting.setdefault(set_of[k], []).append(k)
    fewest = [(len(found), number) for number, found in missing.items()]
    heapify(fewest)
    torn: dict[int, None] = {}
    behind: list[int] = []
    known: list[int] = []
    while len(torn) + len(behind) < len(group):
        while known:
            k = known.pop()
            for number in needs.get(k, ()):
                missing[number].discard(k)
                heappush(fewest, (len(missing[number]), number))
        size, number = heappop(fewest)
        if size != len(missing[number]):
            continue  # it misses less by now
        if not missing[number]:
            known = [k for k in waiting.pop(number, []) if k not in torn]
            behind += known
        else:
            known = [min(missing[number])]
            torn |= dict.fromkeys(known)
    return list(torn), behind
