"""All that happens in a run between two calls of the loop: events of FMUs, and those that the system states."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...errors import RovbrushError
from ...fmu.types import Value
from ...loop import cells
from ...participant.base import Participant
from ...plan.plan import Plan
from ...results.tables import EventRow
from ..blocks import Blocks
from ..memory.algorithm_state import AlgorithmState
from ..memory.memory import Memory
from ..position import Position
from .handler import EventHandler

if TYPE_CHECKING:
    from .scenario import Scenario

CODES = (cells.DUE, cells.PAUSED, cells.ENDED, cells.BAD_STATUS)  # with which the loop may come back for an event


class Events:
    """`scenario`: the events of the system, `handler`: those of FMUs; None where there are none."""

    def __init__(self, plan: Plan, memory: Memory, control: np.ndarray, space: AlgorithmState) -> None:
        self.plan, self.memory, self.control, self.space = plan, memory, control, space
        self.scenario = self._scenario()
        self.handler: EventHandler | None = None

    def _scenario(self) -> Scenario | None:
        if not self.plan.system.events:
            return None
        from .scenario import Scenario

        return Scenario(self.plan, self.memory, self.control, self.space.clock)

    def begin(self, instances: Mapping[str, Participant], blocks: Blocks) -> None:
        """Behind initialization: the first events of FMUs. Raises RunError, AskedToEndError."""
        moments, control = self.space.moments, self.control
        if moments is not None:
            control[cells.MOMENTS] = len(self.space.solver) - len(moments.cells)
            self.handler = EventHandler(
                self.plan, instances, self.memory, moments, control, blocks.components, blocks.run_rows
            )
            self.handler.begin()

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
        if code == cells.DUE and self.scenario:
            begin = int(self.space.clock[cells.NOW]) + cycle * self.plan.cycle_ticks
            self.scenario.act(begin + int(self.plan.operations(cycle)[operation, 1]))
            at.cycle, at.operation = cycle, operation + 1
            return True
        if code not in CODES or self.handler is None:
            return False
        try:
            following = self.handler.paused(code)
        except RovbrushError:
            at.cycle, at.operation = cycle, operation
            at.time = float(self.handler.rows[-1].time) if self.handler.rows else at.time
            raise
        if following is not None:
            whole = following == len(self.plan.operations(cycle))
            at.cycle, at.operation = (cycle + 1, 0) if whole else (cycle, following)
        return following is not None

    @property
    def notes(self) -> list[str]:
        """What a person must know of them."""
        return self.scenario.notes if self.scenario else []

    @property
    def rows(self) -> list[EventRow]:
        """The rows of all events, those of the system behind those of FMUs at one instant."""
        rows = [*(self.handler.rows if self.handler else []), *(self.scenario.rows if self.scenario else [])]
        if not (self.handler and self.scenario):
            return rows
        found: list[EventRow] = []
        for row in sorted(rows, key=lambda row: row.time):
            again = found and found[-1].time == row.time
            found.append(row._replace(number=found[-1].number + 1) if again else row)
        return found
