"""The loop, called for blocks of cycles: each as long as a person waits for a bar to move or for Ctrl-C to be heard."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from ..loop import cells
from ..loop.machine.frame import with_arrays
from ..participant.base import Participant
from ..plan.plan import Plan
from ..processes import seconds_since_start
from .memory.algorithm_state import AlgorithmState
from .memory.memory import Memory
from .pacing.pacer import Pacer
from .position import Position
from .recording.recorder import Recorder

NO_ROWS = (np.zeros(0, dtype=np.int64), np.zeros((0, 3), dtype=np.int64), np.zeros(1), np.zeros(1, dtype=np.int64))
BLOCK = 0.1  # s of wall time between two looks at progress and signals
PACED = 1 / 35  # s, in a run that keeps pace: somebody watches


class Blocks:
    """What the loop is called with, and how many cycles at a time."""

    def __init__(
        self, function: Callable[..., int], plan: Plan, instances: dict[str, Participant], memory: Memory,
        space: AlgorithmState, control: np.ndarray,
    ) -> None:  # fmt: skip
        self.function, self.plan, self.memory = function, plan, memory
        self.space, self.control = space, control
        self.components, self.blocks, self.typed = memory.tables(instances)
        self._clock = plan.cycle_ticks, plan.clock.numerator, plan.clock.denominator
        self._prepared: tuple[object, object, Callable[..., int]] = (None, None, function)
        self.began = 0.0  # s from the start of the process to the end of the first block
        self._size, self._looked = 1, 0.0
        self.pacer: Pacer | None = None  # of a run that keeps pace

    def size(self, at: Position, cycles: int, recorder: Recorder) -> int:
        """How many of the next `cycles` cycles are a block. Raises RunError if the disk has no room for their rows."""
        return 1 if at.operation else recorder.make_room(min(self._size, cycles))

    def no_more_inputs(self, component: int) -> None:
        """Set nothing more of a component, which has asked to end: FMI allows to read it only."""
        self.components[component, cells.LAST_IN] = self.components[component, cells.FIRST_IN]

    def run(self, at: Position, size: int, recorder: Recorder) -> tuple[int, bool]:
        """Do a block from where the run is: the code that the loop ends with, and whether it is time to look around."""
        operations, arrays = self.plan.operations(at.cycle), recorder.arrays
        if self._prepared[0] is not operations or self._prepared[1] is not arrays:
            self._prepared = operations, arrays, self._prepare(operations, arrays)
        self.control[cells.RESUME_AT] = at.operation
        block = BLOCK
        if self.pacer:
            block = PACED
            self.pacer.enter(self.tick_at(at))
        begin = time.perf_counter()
        code = self._prepared[2](at.cycle, size, *self._clock)
        spent = time.perf_counter() - begin
        at.wall += spent
        due = begin - self._looked > BLOCK / 2  # steps by hand take less than a look at the working directory
        self._looked = begin if due else self._looked
        self.began = self.began or seconds_since_start()
        self._size = min(2 * self._size, int(size * block / max(spent, 1e-6))) or 1
        return code, due

    def tick_at(self, at: Position) -> int:
        """The instant [ticks from the start] of the operation with which the run goes on."""
        if self.plan.adaptive:
            return int(self.space.clock[cells.NOW])
        begin = at.cycle * self.plan.cycle_ticks
        return begin + int(self.plan.operations(at.cycle)[at.operation, 1]) if at.operation else begin

    def _prepare(self, operations: np.ndarray, recorded: tuple[np.ndarray, ...]) -> Callable[..., int]:
        """The loop with its arrays, which stay the same from step to step."""
        arrays = (
            operations, self.plan.coefficients, self.components, self.blocks, self.memory.z,
            *self.typed, *recorded, self.control, *self.space.arrays,
        )  # fmt: skip
        return with_arrays(self.function, arrays)

    def run_rows(self, rows: np.ndarray, cycle: int) -> int:
        """Do some operations at once, as of a cycle, whatever the loop is waiting for; the code that it ends with."""
        control, clock = self.control, self.plan.clock
        kept = control[[cells.STOP_REQUEST, cells.ENDS_AT]]
        control[[cells.STOP_REQUEST, cells.ENDS_AT, cells.RESUME_AT]] = 0, cells.NEVER, 0
        code = self.function(
            rows, self.plan.coefficients, self.components, self.blocks, self.memory.z, *self.typed, *NO_ROWS,
            self.control, *self.space.arrays, cycle, 1, self.plan.cycle_ticks, clock.numerator, clock.denominator,
        )  # fmt: skip
        control[cells.STOP_REQUEST] = max(control[cells.STOP_REQUEST], kept[0])
        control[cells.ENDS_AT] = kept[1]
        return code
