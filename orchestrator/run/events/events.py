"""All that happens in a run between two calls of the loop: events of FMUs, and those that the system states."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import RovbrushError
from ...fmu.types import Value
from ...loop import cells
from ...participant.base import Participant
from ...plan.plan import Plan
from ...system.event import Event
from ..blocks.blocks import Blocks
from ..memory.algorithm_state import AlgorithmState
from ..memory.memory import Memory
from ..position import Position
from ..recording.happened import Happened, Rows
from . import kept
from .handler import EventHandler
from .hands import Hands
from .macro import MacroSteps

if TYPE_CHECKING:
    from .scenario import Scenario

CODES = (cells.PAUSED, cells.ENDED, cells.BAD_STATUS)  # with which the loop may come back for an event


class Events:
    """`scenario`: the events of the system, `hands`: what is done by hand of them; who handles events: `handler`, or
    `macro` where steps are repeated or vary; None where there are none. `file`: where rows are written while the run
    goes, if they become many."""

    def __init__(
        self, plan: Plan, memory: Memory, control: np.ndarray, space: AlgorithmState, file: Path | None = None
    ) -> None:
        self.plan, self.memory, self.control, self.space = plan, memory, control, space
        self.happened = Happened(len(plan.recorded_slots), None if file is None else file.parent)
        self.scenario = self._scenario()
        self.hands = Hands(plan, self.scenario)
        self.handler: EventHandler | None = None
        self.macro: MacroSteps | None = None

    def _scenario(self) -> Scenario | None:
        if not self.plan.system.events:
            return None
        from .scenario import Scenario

        return Scenario(self.plan, self.memory)

    def begin(self, instances: Mapping[str, Participant], blocks: Blocks) -> None:
        """Behind initialization: what happens at the start. Raises RunError, AskedToEndError."""
        moments, control = self.space.moments, self.control
        if moments is not None:
            control[cells.MOMENTS] = len(self.space.solver) - len(moments.cells)
            others = [self.scenario] if self.scenario else []
            self.handler = EventHandler(
                self.plan, instances, self.memory, moments, control, blocks.components, blocks.run_rows, self.happened,
                others,
            )  # fmt: skip
            self.handler.begin()
        elif self.scenario:
            self.macro = MacroSteps(self.plan, self.memory, control, self.space.clock, self.scenario, self.happened)
            self.macro.begin()

    def give(self, number: int, event: Event | None, withdrawn: Fraction | None = None) -> None:
        """An event of the system happens as another one states it: see `Scenario.give`."""
        assert self.scenario is not None
        self.scenario.give(number, event, withdrawn)
        self._look_ahead()

    def end(self, number: int, time: Fraction) -> None:
        """The fault of an event that was given ends [s]."""
        assert self.scenario is not None
        self.scenario.end(number, time)
        self._look_ahead()

    def _look_ahead(self) -> None:
        """Have the loop come back for what is due next."""
        if self.handler:
            self.handler.plan_next()
        elif self.macro:
            self.macro.aim()

    @property
    def ends_at(self) -> int:
        """The instant [ticks from time 0] behind which a component does not want to go on."""
        return self.handler.ends_at if self.handler else int(self.control[cells.ENDS_AT])

    def end_at(self, tick: int) -> None:
        """The run is to end behind an instant [ticks from time 0]."""
        self.control[cells.ENDS_AT] = tick
        if self.handler:
            self.handler.end_at(tick)

    def set_by_hand(self, component: str, values: Mapping[str, Value], at: Position) -> None:
        """Set inputs of a component that are set at events only: now, or when their clocks tick. Raises RunError."""
        if self.handler is not None:
            self.handler.set_by_hand(component, values, at.cycle)

    def handled(self, code: int, at: Position) -> bool:
        """Whether the loop came back for an event, which is handled then; `at` is where it goes on.

        Raises RunError for what goes wrong, AskedToEndError; `at` is where the event is then.
        """
        cycle, operation = int(self.control[cells.AT_CYCLE]), int(self.control[cells.AT_OPERATION])
        if code not in CODES or not (self.handler or self.macro):
            return False
        try:
            following = self.handler.paused(code) if self.handler else self._at_macro_step(code, cycle, operation)
        except RovbrushError:
            at.cycle, at.operation = cycle, operation
            if self.handler:
                at.time = self.handler.reached(cycle, operation)
            elif self.happened.last:
                at.time = max(at.time, self.happened.last.time)
            raise
        if following is not None:
            whole = following == len(self.plan.operations(cycle))
            at.cycle, at.operation = (cycle + 1, 0) if whole else (cycle, following)
        return following is not None

    def _at_macro_step(self, code: int, cycle: int, operation: int) -> int | None:
        if code != cells.PAUSED or self.macro is None:
            return None
        begin = int(self.space.clock[cells.NOW]) + cycle * self.plan.cycle_ticks
        self.macro.act(begin + int(self.plan.operations(cycle)[operation, 1]))
        return operation + 1

    @property
    def rows(self) -> Rows:
        """The rows of all events until now."""
        return self.happened.rows()

    def write(self, path: Path) -> None:
        """Their rows into a file of a checkpoint. Raises OSError."""
        self.happened.write(path)

    def read(self, path: Path, count: int) -> None:
        """So many rows from a file of a checkpoint. Raises ValueError, OSError."""
        self.happened.read(path, count)

    def content(self) -> dict[str, Any]:
        """What is kept of them beside their rows, ready for JSON."""
        of_system = {"scenario": self.scenario.content(), "hands": self.hands.content()} if self.scenario else {}
        of_fmus = {"of_fmus": kept.content_of(self.handler)} if self.handler else {}
        return {"rows": self.happened.count, **of_system, **of_fmus}

    def go_back(self, rows: Rows, content: Mapping[str, Any]) -> None:
        """To where this run was, when its FMUs are restored."""
        self.happened.go_back(rows)
        self.restore(content)

    def restore(self, content: Mapping[str, Any]) -> None:
        """Go on where this or another run was, when rows and FMUs are restored. Raises ValueError, TypeError,
        LookupError where that cannot be."""
        if self.scenario:
            self.scenario.restore(content["scenario"])
            self.hands.restore(content["hands"])
        if self.handler:
            kept.restore(self.handler, content["of_fmus"])
            self.handler.plan_next()
        elif self.macro:
            self.macro.aim()
