"""A run of a plan that is advanced piece by piece."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError, RovbrushError, RunError
from ...files import plain
from ...loop import cells
from ...loop.machine.compiled import compiled_run
from ...loop.run import run
from ...participant.base import AskedToEndError, Participant
from ...plan.plan import Plan
from ...results.tables import Run
from ..blocks.blocks import Blocks
from ..ends.interrupt import StopRequests
from ..events.events import Events
from ..exchange.apart import alone
from ..memory.access import Access
from ..memory.algorithm_state import free_states, make_state
from ..memory.memory import Memory
from ..pacing.pace import Pace
from ..pacing.pacer import Pacer, room_for
from ..participants import Participants
from ..position import Position
from ..recording.observers import NEVER, Observer, Progress
from ..recording.recorder import Recorder
from ..start.initialize import initialize
from .behind import behind_block
from .by_hand import act
from .notes import Notes
from .standing import Standing

if TYPE_CHECKING:
    from ...participant.model_exchange.group import Group


class Session(Standing):
    """FMUs loaded and initialized at the start, to be advanced by whole cycles: hyperperiods, with ECCO macro steps.

        with Session(plan) as session:
            while session.tick < plan.clock.stop:
                session.set("motor.V_in", controller(session.get("motor.omega")))
                session.advance(cycles=1)
            run = session.run()

    `interpreted` executes the plan in plain Python, bitwise equal and slow. A failing FMU, a value that is not finite
    and Ctrl-C end it: `failure` says who, what and when, and what was recorded until then is kept. How a run is cut
    into pieces does not change its results. `file`: where rows are written while the run goes, if they become many.
    `stop_requests`: what may ask the run to stop, if it is more than Ctrl-C. `observers` look on while it goes. `pace`:
    how it keeps pace with the clock on the wall, of a plan that has deadlines. `fuses`: whether the loop does in one
    go what can be (`plan/speed/fused.py`), `straight`: when by machine code of its own (`blocks/straight_on.py`),
    bitwise equal. Raises FmuError or InputError if the start cannot be reached.
    """

    def __init__(
        self,
        plan: Plan,
        interpreted: bool = False,
        file: Path | None = None,
        stop_requests: StopRequests | None = None,
        pace: Pace | None = None,
        fuses: bool = True,
        straight: str = "pays",
    ) -> None:
        super().__init__()
        self.plan = plan
        self.stop_requests = stop_requests or StopRequests()
        if pace:
            self.stop_requests.make_room(room_for(plan))
        elif plan.deadlines:
            raise InputError("this plan has deadlines: give the run a pace, or make the plan without them")
        self.control = self.stop_requests.control
        self.pacer = Pacer(plan, pace, self.control) if pace else None
        self.control[cells.PROMISED], self.control[cells.START] = plan.clock.stop, plan.clock.start
        self.observers: list[Observer] = []
        self.set_by_hand: dict[str, Any] = {}  # values, by name; see `Checkpoint`
        self.at = Position(time=plan.clock.time(0))
        self._adaptive, self._cycle_ticks, self._whole = plan.adaptive, plan.cycle_ticks, plan.clock.cycles
        function = run if interpreted else compiled_run(waits=pace is not None)
        with self.stop_requests.heard():
            self.participants = Participants(plan.system)
            self.instances = self.participants.by_name
            try:
                self.memory = Memory(plan)
                self.group = self._brought_together() if plan.exchange else None
                solved: list[Group | Participant] = [*([self.group] if self.group else [])]
                solved += alone(plan, self.instances, self.group is not None)
                self._notes = Notes(self.participants, solved)
                self._started = initialize(plan, self.instances, self.memory)
                self.participants.notes += self._started.notes
                self.participants.look_around("in the initialization")
                self._calculated = self.participants.calculated()
                self.space = make_state(plan, self.instances)
                self.events = Events(plan, self.memory, self.control, self.space, file)
                self._access = Access(plan, self.memory, self.instances)
                self._blocks = Blocks(
                    function, plan, self.instances, self.memory, self.space, self.control, fuses, straight
                )
                self._blocks.pacer = self.pacer
                if plan.together.groups:
                    self._blocks.begin_workers()
                self.events.begin(self.instances, self._blocks)
                self.recorder = Recorder(plan, self.memory, file, pace is not None)
            except BaseException:
                self._end_workers()
                self.participants.abandon()
                raise

    def _end_workers(self) -> None:
        """No other thread is in an FMU from now on."""
        if (blocks := getattr(self, "_blocks", None)) and blocks.workers:
            blocks.workers.close()

    def _brought_together(self) -> Group | None:
        """The group of the FMUs for Model Exchange; what integrates them is loaded where there are any."""
        from ..exchange.together import bring_together

        return bring_together(self.plan, self.instances, self.memory)

    @property
    def time(self) -> float:
        """The time reached [s]: all components are complete until then."""
        return self.at.time

    @property
    def tick(self) -> int:
        """The time reached in ticks of the plan's clock; after a failure that of the last whole cycle."""
        if self._adaptive:
            return int(self.space.clock[cells.NOW])
        return min(self.at.cycle * self._cycle_ticks, self.plan.clock.stop)

    def advance(
        self,
        until_tick: int | None = None,
        cycles: int | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> None:
        """Run whole cycles: until `until_tick` is reached or passed, `cycles` of them, or to the stop of the plan.

        What comes first counts. `progress` is called now and then with the time reached [s]. Returns early with
        `failure` set. Raises InputError for an end before now or behind the stop, RunError if the session has ended.
        """
        self._require_alive()
        stop = self.plan.clock.stop
        until = stop if until_tick is None else until_tick
        if not self.tick <= until <= stop or (cycles is not None and cycles < 0):
            raise InputError(f"cannot advance from tick {self.tick} to {until}, stop is at {stop}; cycles: {cycles}")
        last = stop if self.plan.adaptive else -(-until // self.plan.cycle_ticks)  # no step is shorter than a tick
        last = last if cycles is None else min(last, self.at.cycle + cycles)
        if self.events.hands.waiting:
            act(self)
        watching = [*self.observers, *([Progress(progress)] if progress else [])]
        with self.stop_requests.heard():
            while self.at.cycle < last and self.tick < until and not self.over:
                due = min((observer.due(self.tick) for observer in watching), default=NEVER)
                self.space.clock[cells.UNTIL] = min(until, due)
                whole = last if self.plan.adaptive else min(last, -(-due // self.plan.cycle_ticks))
                self._run_block(max(whole - self.at.cycle, 1))
                if not self.failure:
                    self._show(watching)

    def straight_on(self) -> None:
        """To the stop of the plan with nobody looking on, and signals as the program has them."""
        last = self.plan.clock.stop if self._adaptive else -(-self.plan.clock.stop // self._cycle_ticks)
        while self.at.cycle < last and self.tick < self.plan.clock.stop and not self.over:
            self._run_block(last - self.at.cycle)

    def _show(self, watching: Sequence[Observer]) -> None:
        """Let observers see the rows that are new."""
        if watching:
            piece = self.recorder.fresh(self.at.time, self.tick)
            for observer in watching:
                observer.see(piece)

    def _run_block(self, cycles: int) -> None:
        """Some of the next `cycles` cycles, for about a tenth of a second."""
        if not self._adaptive and self.at.cycle < self._whole:  # what is left behind them is done by itself
            cycles = min(cycles, self._whole - self.at.cycle)
        try:
            size = self._blocks.size(self.at, cycles, self.recorder)
        except RunError as error:  # the disk refuses: what was computed is not to be lost for it
            self.failure = f"t = {self.at.time:.9g} s: {error}"
            return
        code, due = self._blocks.run(self.at, size, self.recorder)
        behind_block(self, code, due, size)

    def one_block(self) -> None:
        """Go on within a cycle to its end."""
        self._run_block(1)

    @property
    def tables_of_components(self) -> np.ndarray:
        """`components` as the loop has it; one that has asked to end is given nothing more."""
        return self._blocks.components

    @property
    def loop(self) -> Blocks:
        """The loop with its arrays."""
        return self._blocks

    def put_back_components(self, found: np.ndarray) -> None:
        """That table as it was once."""
        self._blocks.put_back(found)

    def revive(self) -> None:
        """It is where it was once, and goes on whatever has ended it since."""
        if self._blocks.workers:
            self._blocks.workers.forget()
        self.is_over = self.interrupted = False

    def fail(self, why: str) -> None:
        """End the run, for a reason that lies outside the loop; the rows that are complete are kept."""
        if not self.failure:
            stop = self.plan.clock.stop
            ends = [min((n - 1) * g.period, stop) for n, g in zip(self.counts, self.plan.groups, strict=True)]
            if ends and not self.plan.adaptive and not self.plan.algorithm.repeats_rows:
                self.at.time = max(self.at.time, self.plan.clock.time(min(ends)))
            self.failure = why

    @property
    def forgotten(self) -> list[str]:
        """What a checkpoint that was written here does not hold, in words."""
        return self._notes.forgotten()

    def get(self, name: str) -> Any:
        """The value of `component.variable` now; of an array all values. A signal of the coupling is `coupling.name`.

        Raises InputError for an unknown name.
        """
        self._require_open()
        return self._access.get(name)

    def set(self, name: str, value: object) -> None:
        """Set an input that nothing drives, from now on; of an array a sequence of all values.

        Raises InputError for an unknown name, a driven input, any other causality, a wrong type or a value out of
        range; RunError if the session has ended.
        """
        self._require_alive()
        component, later = self._access.set(name, value)
        if later and self.tick < self.plan.clock.stop:
            try:
                self.events.set_by_hand(component, later, self.at)
            except AskedToEndError as error:
                self.end_early(str(error))
            except RovbrushError as error:
                self.failure = str(error)
                raise
        self.set_by_hand.pop(name, None)  # the order in which they are set again is that of the last times
        self.set_by_hand[name] = plain(value.tolist() if hasattr(value, "tolist") else value)

    @property
    def counts(self) -> list[int]:
        """Rows of every table, counted from the start."""
        return [int(a) + b for a, b in zip(self.recorder.rows, self.recorder.before, strict=False)]

    def run(self) -> Run:
        """What was recorded so far."""
        self.participants.look_around(f"before t = {self.at.time:.9g} s")
        rows = self.counts
        if self.failure and self.plan.algorithm.repeats_rows:  # a pass may be recorded that was not the last
            rows = [-(-self.tick // group.period) + 1 for group in self.plan.groups]
        return Run(
            self.plan, self.recorder.recorded(rows), self.failure, self.at.time, self.at.wall, self._blocks.began,
            self._started, self.memory.texts, self._calculated,
            self._notes.so_far(self._blocks.workers), self.participants.messages(), self.ended, self.events.rows,
            self.pacer.lateness() if self.pacer else None,
        )  # fmt: skip

    def close(self) -> None:
        """Give the FMUs back. Runs that were taken before stay valid."""
        if not self.closed:
            self.closed = True
            self._end_workers()
            free_states(self.space, self.instances)
            self.ended_badly = self.participants.close()
            if self.recorder.stream:
                self.recorder.stream.close()

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
