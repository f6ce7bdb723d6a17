"""Which components can be stepped at once, each on a thread, and the operations in an order that lets them.

A group steps at the same instants over the same steps, and none needs what another one of it makes there. The inputs of
all are set before the first of them steps; all else stays where it is, so that the rows, and who fails first, are those
of one thread.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from ..fmu.files.places import is_python
from ..fmu.kinds import CO_SIMULATION
from ..fmu.sharing import made_by_pythonfmu
from ..fmu.types import FLOAT
from ..loop.operations import (
    ACCUMULATE,
    COPY,
    GET,
    LINEAR,
    MEAN,
    MIX,
    MOVE,
    NUMBER,
    PUSH,
    QUADRATIC,
    RISE,
    SAMPLE,
    SERIES,
    SET,
    STEP,
    WORK,
)
from ..system.component import Component
from ..system.model import System
from .design import Design

# Cells that an operation reads and writes, as columns of its row.
A, B, P, Q = 3, 4, 5, 6
READS = {
    COPY: (A,), MOVE: (A,), PUSH: (A,), NUMBER: (A,), LINEAR: (A, P), MEAN: (A, P, Q), QUADRATIC: (A, P, Q),
    MIX: (A, B, P), ACCUMULATE: (A, B, P), RISE: (A, B, P), WORK: (A, B, P, Q), SERIES: (), SAMPLE: (),
}  # fmt: skip
WRITES = {code: (B, Q) if code == MEAN else (B,) for code in READS}


@dataclass(frozen=True)
class Together:
    """Groups of components, in the order of their steps, and why the others are stepped by themselves."""

    groups: tuple[tuple[str, ...], ...] = ()
    alone: Mapping[str, str] | None = None


def why_alone(component: Component) -> str:
    """Why a component is not stepped on another thread; empty if it can be."""
    fmu = component.fmu
    if component.parallel == "off":
        return 'parallel = "off"'
    if not fmu.is_file or fmu.kind != CO_SIMULATION or component.scheduled:
        return "it is no FMU for co-simulation"
    if component.isolation:
        return ""
    if fmu.own.windows:
        return "it runs under wine"
    if is_python(fmu.description) or made_by_pythonfmu(fmu.own):
        return 'Python runs in it, one thread at a time; isolation = "process" lets it go along'
    if fmu.interface.canBeInstantiatedOnlyOncePerProcess:
        return "it allows one instance per process, so that it may share what others use"
    return ""


def together_of(design: Design, cycle: np.ndarray, last: np.ndarray) -> tuple[Together, np.ndarray, np.ndarray]:
    """The groups of a plan, and its operations so that their steps can overlap."""
    system, algorithm = design.system, design.algorithm
    if system.events or design.events or algorithm.saves_states or algorithm.steps_vary or design.deadlines:
        why = "events, deadlines and steps that are repeated or vary go on one thread"
        return Together((), dict.fromkeys(system.components, why)), cycle, last
    alone = {name: why for name, c in system.components.items() if (why := why_alone(c))}
    order = Order(design, frozenset(alone))
    groups = list(order.groups(cycle))
    if len(last):
        groups = [group for group in groups if group in list(order.groups(last))]
    for name in system.components:
        if not any(name in group for group in groups):
            alone.setdefault(name, "nobody else steps at its instants without waiting for it")
    return Together(tuple(groups), alone), order.changed(cycle, groups), order.changed(last, groups)


class Order:
    """Moves the setting of inputs before the first step of a group."""

    def __init__(self, design: Design, alone: frozenset[str]) -> None:
        self.names = list(design.system.components)
        self.period = design.clock.periods
        self.alone = alone | {name for name in self.names if _may_be_unfit(design.system, name)}
        exchanged = {k: design.layout.exchanged(name) for k, name in enumerate(self.names)}
        self.given, self.taken = (
            {k: frozenset(sides[n].values()) for k, sides in exchanged.items()} for n in (0, 1)
        )  # fmt: skip

    def groups(self, rows: np.ndarray) -> Iterator[tuple[str, ...]]:
        """Those that can be stepped together at every instant at which one of them steps."""
        found: dict[str, tuple[str, ...]] = {}
        wrong: set[str] = set()
        for members in self._at_instants(rows):
            names = tuple(self.names[rows[m, 2]] for m in members)
            for name in names:
                if found.setdefault(name, names) != names:
                    wrong |= {*names, *found[name]}
        for names in dict.fromkeys(found.values()):
            if len(names) > 1 and not wrong & set(names):
                yield names

    def _at_instants(self, rows: np.ndarray) -> Iterator[list[int]]:
        """The numbers of rows that step a group, in every place where there is one or a step alone."""
        listed, taken = rows.tolist(), set[int]()
        for first, row in enumerate(listed):
            if row[0] != STEP or first in taken:
                continue
            members = [first]
            if self.names[row[2]] not in self.alone:
                for m in range(first + 1, len(listed)):
                    other = listed[m]
                    if other[1] != row[1] or (other[0] not in READS and other[0] not in (SET, GET, STEP)):
                        break
                    if other[0] != STEP or m in taken or other[3:5] != row[3:5]:
                        continue
                    name = self.names[other[2]]
                    if name in self.alone or self.period[name] != self.period[self.names[row[2]]]:
                        continue
                    if self._needed(listed, first, m, members) is not None:
                        members.append(m)
            taken.update(members)
            yield members

    def changed(self, rows: np.ndarray, groups: list[tuple[str, ...]]) -> np.ndarray:
        """The rows with the inputs of each group set before its first step."""
        listed = rows.tolist()
        for names in groups:
            numbers = [self.names.index(name) for name in names]
            firsts = [m for m, row in enumerate(listed) if row[0] == STEP and row[2] == numbers[0]]
            for first in firsts:
                ahead: set[int] = set()
                members = [first]
                for number in numbers[1:]:
                    m = next(m for m in range(first, len(listed)) if listed[m][0] == STEP and listed[m][2] == number)
                    ahead |= self._needed(listed, first, m, members) or set()
                    members.append(m)
                rest = [m for m in range(first, members[-1] + 1) if m not in ahead]
                listed[first : members[-1] + 1] = [listed[m] for m in [*sorted(ahead), *rest]]
        return np.array(listed, dtype=np.int64).reshape(rows.shape)

    def _needed(self, rows: list[list[int]], first: int, m: int, members: list[int]) -> set[int] | None:
        """The rows behind `first` that a step in row m needs before it; None where they need a step of a member, or
        anything else that stays behind `first`."""
        component = rows[m][2]
        ahead = set[int]()
        cells = set[int]()  # that must be written before
        for k in range(m - 1, first, -1):
            row = rows[k]
            own = row[0] in (SET, GET, STEP) and row[2] == component
            if own and row[0] != SET:
                return None
            reads, writes = self._cells(row)
            if own or cells & writes:
                if row[0] in (GET, STEP, SET) and not own:
                    return None
                ahead.add(k)
                cells |= reads
        moved_reads, moved_writes = set[int](), set[int]()
        for k in sorted(ahead):
            reads, writes = self._cells(rows[k])
            moved_reads |= reads
            moved_writes |= writes
        for k in range(first, m):
            if k not in ahead:
                reads, writes = self._cells(rows[k])
                if writes & (moved_reads | moved_writes) or reads & moved_writes:
                    return None
        return ahead

    def _cells(self, row: list[int]) -> tuple[set[int], set[int]]:
        """What an operation reads and writes of the run's vector."""
        if row[0] == SET:
            return set(self.given[row[2]]), set()
        if row[0] == GET:
            return set(), set(self.taken[row[2]])
        if row[0] == STEP:
            return set(), set()
        return {row[k] for k in READS[row[0]]}, {row[k] for k in WRITES[row[0]]}


def _may_be_unfit(system: System, name: str) -> bool:
    """Whether setting the inputs of a component can end a run, which is not to come before the steps of others."""
    fmu = system.components[name].fmu
    kinds = [fmu.type_of(variable) for variable in fmu.names("input")]
    return any(kind is not None and kind.code == FLOAT and kind.size < 8 for kind in kinds)


def explained(together: Together, workers: str) -> list[str]:
    """Who is stepped together, and why the others are not."""
    if not together.groups:
        reasons = dict.fromkeys((together.alone or {}).values())
        return [f"workers = {workers}: all steps on one thread ({'; '.join(reasons)})"]
    lines = [f"workers = {workers}: stepped at once: {', '.join(group)}" for group in together.groups]
    return lines + [f"  by itself: {name}, {why}" for name, why in (together.alone or {}).items()]
