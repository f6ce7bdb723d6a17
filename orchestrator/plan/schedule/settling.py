"""The operations that make the values of an instant: inputs formed, set, outputs read again; loops solved by Newton."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import TYPE_CHECKING

from ...loop.operations import COPY, PUSH, SOLVE
from ...loop.solvers.iteration import NEWTON, workspace
from ...system.connection import Connection
from ..instants import Known
from ..start import Block
from .layout import Key
from .values import Row

if TYPE_CHECKING:
    from .schedule import Schedule


class Settling:
    """Which inputs are older than the present instant, and the operations that mend it."""

    def __init__(self, schedule: Schedule) -> None:
        self.schedule, self.instants, self.layout = schedule, schedule.design.instants, schedule.layout
        self.old: set[Connection] = set()  # their source has changed since the target was given its value
        self.into: dict[str, list[Connection]] = {}
        self.out: dict[str, list[Connection]] = {}
        for c in self.instants.held:
            self.into.setdefault(c.target[0], []).append(c)
            self.out.setdefault(c.source[0], []).append(c)
        self.kept: dict[Key, int] = {}  # what an input was over the step that ends now: its rows are that
        self.changed: dict[Key, None] = {}  # inputs that were given the value of this instant
        self.loops: dict[tuple[Connection, ...], tuple[int, int, int]] = {}  # unknowns, images, memory of each

    def begin(self) -> None:
        """Steps to a new instant begin."""
        self.old.clear()

    def stepped(self, name: str) -> None:
        """A component has made its step: all that it sends is new."""
        self.old.update(self.out.get(name, ()))

    def formed(self, connections: Iterable[Connection]) -> None:
        """These inputs have just been given what their sources have."""
        self.old.difference_update(connections)

    def all_of(self, tick: int, known: Known) -> Iterator[Row]:
        """Give all inputs on which outputs depend at once the value of this instant."""
        yield from self._values(tick, known, None)
        for key in self.changed:
            yield (PUSH, tick, self.schedule.index[key[0]], self.kept[key], self.layout.inputs[key], 0, 0, 0)
        self.changed.clear()

    def sources_of(self, tick: int, known: Known, connections: Iterable[Connection]) -> Iterator[Row]:
        """The same as far as the sources of some connections need it, with what `known` components have."""
        if any(c.target[0] in known for c in self.old):
            yield from self._values(tick, known, self._upstream([c.source for c in connections], known))

    def afresh(self, tick: int, known: Known) -> Iterator[Row]:
        """The same at an event, where all that some components send may be new; what inputs were is not kept."""
        self.old = {c for name in known for c in self.out.get(name, ())}
        yield from self._values(tick, known, None)
        self.old.clear()
        self.changed.clear()

    def _upstream(self, outputs: list[Key], known: Known) -> set[Connection]:
        """The connections on which outputs rest at an instant, near and far."""
        found: set[Connection] = set()
        while outputs:
            name, variable = outputs.pop()
            for c in self.into.get(name, ()):
                if c not in found and c.source[0] in known and c.target[1] in self._answers(name, variable):
                    found.add(c)
                    outputs.append(c.source)
        return found

    def _answers(self, name: str, output: str) -> frozenset[str]:
        return self.instants.answers[name].get(output, frozenset())

    def _values(self, tick: int, known: Known, wanted: Collection[Connection] | None) -> Iterator[Row]:
        if not any(c.target[0] in known for c in self.old):
            return
        waiting: dict[str, set[str]] = {}  # inputs that are formed and not set yet, by component
        for block in self.instants.blocks(known):
            if wanted is not None and block.connections[0] not in wanted:
                continue
            for c in block.connections:
                if self._answers(*c.source) & waiting.get(c.source[0], set()):
                    yield from self._again(tick, c.source[0], waiting.pop(c.source[0]))
            if not self.old & set(block.connections):
                continue
            self.formed(block.connections)
            yield from self._keep(tick, block.connections)
            if block.loop:
                yield from self._solve(tick, block)
                continue
            c = block.connections[0]
            yield self.schedule.sent(c, tick, self.layout.outputs[c.source])
            yield from self.schedule.broken(c, tick, tick)
            waiting.setdefault(c.target[0], set()).add(c.target[1])
        for name, inputs in waiting.items():
            yield from self._again(tick, name, inputs)

    def _keep(self, tick: int, connections: Iterable[Connection]) -> Iterator[Row]:
        for key in (c.target for c in connections if c.target not in self.changed):
            self.changed[key] = None
            if key not in self.kept:
                self.kept[key] = self.layout.slot(f"{'.'.join(key)} over the step")
            yield (PUSH, tick, self.schedule.index[key[0]], self.layout.inputs[key], self.kept[key], 0, 0, 0)

    def _again(self, tick: int, name: str, inputs: set[str]) -> Iterator[Row]:
        """Set inputs and read again; what answers to them is new."""
        self.old.update(c for c in self.out.get(name, ()) if self._answers(*c.source) & inputs)
        yield from self.schedule.read_again(tick, name)

    def _solve(self, tick: int, block: Block) -> Iterator[Row]:
        """Newton's method on the inputs of a loop: from the last solution on until each is what its source sends."""
        connections, schedule, layout = block.connections, self.schedule, self.layout
        unknowns, images, memory = self._memory(block)
        same = schedule.constants.at(1.0, 0.0)
        for k, c in enumerate(connections):
            component = schedule.index[c.target[0]]
            yield (COPY, tick, component, layout.inputs[c.target], unknowns + k, 0, 0, same)
        once: list[Row] = []
        for k, c in enumerate(connections):
            component = schedule.index[c.target[0]]
            once.append((COPY, tick, component, unknowns + k, layout.inputs[c.target], 0, 0, same))
            once += schedule.broken(c, tick, tick)
        for name in dict.fromkeys(c.target[0] for c in connections):
            once += self._again(tick, name, {c.target[1] for c in connections if c.target[0] == name})
        self.formed(connections)
        for k, c in enumerate(connections):
            gains = schedule.constants.at(c.gain, c.offset)
            once.append((COPY, tick, schedule.index[c.target[0]], layout.outputs[c.source], images + k, 0, 0, gains))
        yield from once
        nominal = [schedule.nominal(c.target) for c in connections]
        loops = schedule.system.loops
        settings = schedule.constants.at(loops.tolerance, float(loops.max_iterations), float(NEWTON), *nominal)
        yield (SOLVE, tick, memory, len(once), unknowns, images, len(connections), settings)

    def _memory(self, block: Block) -> tuple[int, int, int]:
        """Where the unknowns and the images of a loop lie, and the memory of its solver."""
        if block.connections not in self.loops:
            layout, names = self.layout, [".".join(c.target) for c in block.connections]
            layout.slot(f"iterations of {block.label}")
            layout.slot(f"residual of {block.label}")
            unknowns = [layout.slot(f"{name} at the instant") for name in names]
            images = [layout.slot(f"what {name} is sent") for name in names]
            layout.loops[layout.loop_cells] = block.label
            self.loops[block.connections] = unknowns[0], images[0], layout.loop_cells
            layout.loop_cells += len(workspace(len(names), newton=True))
        return self.loops[block.connections]
