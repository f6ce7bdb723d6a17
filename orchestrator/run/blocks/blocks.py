"""The loop, called for blocks of cycles: each as long as a person waits for a bar to move or for Ctrl-C to be heard."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ...loop import cells
from ...loop.machine.frame import Loop, one_cycle, with_arrays
from ...loop.operations import COLUMNS
from ...participant.base import Participant
from ...plan.plan import Plan
from ...processes import seconds_since_start
from ..memory.algorithm_state import AlgorithmState
from ..memory.memory import Memory
from ..pacing.pacer import Pacer
from ..position import Position
from ..recording.recorder import Recorder
from .program import Program, as_it_is, fused
from .straight_on import StraightOn

if TYPE_CHECKING:
    from .workers import Workers

NO_ROWS = (np.zeros(0, dtype=np.int64), np.zeros((0, 3), dtype=np.int64), np.zeros(1), np.zeros(1, dtype=np.int64))
NO_TURNS = as_it_is(np.zeros((0, len(COLUMNS)), dtype=np.int64))[1:3]
BLOCK = 0.1  # s of wall time between two looks at progress and signals
PACED = 1 / 35  # s, in a run that keeps pace: somebody watches


class Blocks:
    """What the loop is called with, and how many cycles at a time."""

    def __init__(
        self, function: Callable[..., int], plan: Plan, instances: dict[str, Participant], memory: Memory,
        space: AlgorithmState, control: np.ndarray, fuses: bool = True, straight: str = "pays",
    ) -> None:  # fmt: skip
        self.function, self.plan, self.memory = function, plan, memory
        self.space, self.control = space, control
        self.components, self.blocks, self.typed = memory.tables(instances)
        self._clock = plan.cycle_ticks, plan.clock.numerator, plan.clock.denominator
        self._fuses = fuses
        self._straight = StraightOn(plan, straight if fuses else "never")
        self._programs: dict[tuple[int, bool], Program] = {}  # by operations, and whether they are fused
        self._prepared: tuple[object, object, Callable[..., int]] = (None, None, function)
        # The arrays of the recorder, and what does one whole cycle of the schedule with them; None where it is unknown.
        self.one: tuple[object, Callable[[int], int]] | None = None
        self.began = 0.0  # s from the start of the process to the end of the first block
        self._size, self.looked = 1, 0.0  # cycles; when, on the clock of `time.perf_counter`
        self.pacer: Pacer | None = None  # of a run that keeps pace
        self.workers: Workers | None = None  # of one whose steps are shared among threads

    def begin_workers(self) -> None:
        """What shares steps among threads, where somebody asks for it; what it needs is loaded then."""
        from .workers import workers_of

        self.workers = workers_of(self.plan, self)

    def exchange_function(self, function: Callable[..., int]) -> None:
        """Another life of the loop from the next block on, with what stands in `components` now; plain Python stays
        what it is."""
        if isinstance(self.function, Loop):
            self.function = function
        self._forget()

    def size(self, at: Position, cycles: int, recorder: Recorder) -> int:
        """How many of the next `cycles` cycles are a block. Raises RunError if the disk has no room for their rows."""
        return 1 if at.operation else recorder.make_room(min(self._size, cycles))

    def no_more_inputs(self, component: int) -> None:
        """Set nothing more of a component, which has asked to end: FMI allows to read it only."""
        self.components[component, cells.LAST_IN] = self.components[component, cells.FIRST_IN]
        self._forget()

    def put_back(self, components: np.ndarray) -> None:
        """What is set of whom, as it was once."""
        if not np.array_equal(self.components, components):
            self.components[:] = components
            self._forget()

    def _forget(self) -> None:
        """Make all anew that holds what was in `components`."""
        self._programs.clear()
        self._prepared, self.one = (None, None, self.function), None

    def _program(self, operations: np.ndarray, whole: bool) -> Program:
        """What is done in a cycle, or from an operation within it to its end."""
        key = id(operations), whole and self._fuses
        if key not in self._programs:
            made, table = None, (self.components, self.blocks)
            if key[1]:
                if isinstance(self.function, Loop) and operations is self.plan.cycle:
                    made = self._straight.program(*table, self.function.waits)
                made = made or fused(self.plan, operations, *table)
            self._programs[key] = made or as_it_is(operations)
        return self._programs[key]

    def run(self, at: Position, size: int, recorder: Recorder) -> tuple[int, bool]:
        """Do a block from where the run is: the code that the loop ends with, and whether it is time to look around."""
        if self._straight.is_time(at.cycle):
            self._forget()
        program, arrays = self._program(self.plan.operations(at.cycle), at.operation == 0), recorder.arrays
        if self._prepared[0] is not program or self._prepared[1] is not arrays:
            self._prepared = program, arrays, self._prepare(program, arrays)
            whole = at.operation == 0 and self.plan.operations(at.cycle) is self.plan.cycle
            self.one = (arrays, one_cycle(self._prepared[2], *self._clock)) if whole else None
        self.control[cells.RESUME_AT] = at.operation
        block = BLOCK
        if self.pacer:
            block = PACED
            self.pacer.enter(self.tick_at(at))
        begin = time.perf_counter()
        code = self._prepared[2](at.cycle, size, *self._clock)
        spent = time.perf_counter() - begin
        self.ended(code)
        at.wall += spent
        if self.workers:
            self.workers.after(code, size, spent)
        due = begin - self.looked > BLOCK / 2  # steps by hand take less than a look at the working directory
        self.looked = begin if due else self.looked
        self.began = self.began or seconds_since_start()
        self._size = min(2 * self._size, int(size * block / max(spent, 1e-6))) or 1
        return code, due

    def ended(self, code: int) -> None:
        """The loop has ended with a code: in an operation of the plan, whatever rows it has."""
        control, program = self.control, self._prepared[0]
        if code != cells.DONE and isinstance(program, Program):
            control[cells.AT_OPERATION] = program.operation(code, control[cells.AT_OPERATION], control[cells.PART])

    def tick_at(self, at: Position) -> int:
        """The instant [ticks from the start] of the operation with which the run goes on."""
        if self.plan.adaptive:
            return int(self.space.clock[cells.NOW])
        begin = at.cycle * self.plan.cycle_ticks
        return begin + int(self.plan.operations(at.cycle)[at.operation, 1]) if at.operation else begin

    def _prepare(self, program: Program, recorded: tuple[np.ndarray, ...]) -> Callable[..., int]:
        """The loop with its arrays, which stay the same from step to step."""
        arrays = (
            program.rows, self.plan.coefficients, self.components, self.blocks, self.memory.z,
            *self.typed, *recorded, self.control, *self.space.arrays, program.moves, program.turns,
        )  # fmt: skip
        if program.segments:
            program.segments.use(arrays)
        return with_arrays(program.code or self.function, arrays)

    def run_rows(self, rows: np.ndarray, cycle: int) -> int:
        """Do some operations at once, as of a cycle, whatever the loop is waiting for; the code that it ends with."""
        control, clock = self.control, self.plan.clock
        kept = control[[cells.STOP_REQUEST, cells.ENDS_AT]]
        control[[cells.STOP_REQUEST, cells.ENDS_AT, cells.RESUME_AT]] = 0, cells.NEVER, 0
        code = self.function(
            rows, self.plan.coefficients, self.components, self.blocks, self.memory.z, *self.typed, *NO_ROWS,
            self.control, *self.space.arrays, *NO_TURNS,
            cycle, 1, self.plan.cycle_ticks, clock.numerator, clock.denominator,
        )  # fmt: skip
        control[cells.STOP_REQUEST] = max(control[cells.STOP_REQUEST], kept[0])
        control[cells.ENDS_AT] = kept[1]
        return code
