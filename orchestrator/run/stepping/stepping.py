"""A session that is stepped by hand: for controllers in Python, reinforcement learning, hardware in the loop."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from types import TracebackType
from typing import Any

from ...clock import seconds_text
from ...errors import RunError
from ...files import plain
from ...loop.cells import STOP_REQUEST
from ...plan.plan import Plan
from ...results.result import Result
from ..pacing.pace import Pace
from ..session.by_hand import act
from ..session.session import Session
from .as_scenario import as_scenario
from .by_name import outputs_named, reader_by_name, writer_by_name
from .length import Time, steps_in
from .one_step import one_step
from .snapshot import Snapshot, go_back, take_snapshot

PUBLIC = (
    "end", "ended", "failure", "finish", "get", "happen", "names", "pacer", "period", "plan", "restore", "result",
    "scenario", "set", "snapshot", "step", "stop", "time",
)  # fmt: skip


class Stepping(Session):
    """A run that goes on when it is told to.

        with system.start() as session:
            while session.time < 2.0:
                session.set("motor.V_in", 12.0 - 0.1 * session.get("motor.i"))
                session.step()

    A step is `period` [s] long, that in which the schedule repeats, the last one maybe shorter; with ECCO it is a macro
    step. What is set counts from the step that comes next; outputs are those of the end of the last one. A name costs
    more the first time than later. With `pace` each step ends no earlier than the clock on the wall, which began with
    the first of them; `pacer` tells how late it was. Ctrl-C between steps raises KeyboardInterrupt as ever. Errors are
    those of a run: RunError, FmuError.
    """

    def __init__(
        self,
        plan: Plan,
        interpreted: bool = False,
        pace: Pace | None = None,
        fuses: bool = True,
        straight: str = "pays",
    ) -> None:
        super().__init__(plan, interpreted, pace=pace, fuses=fuses, straight=straight)
        if self.stop_requests.asked:  # while the FMUs were initialized
            Session.close(self)
            raise KeyboardInterrupt
        self._readers: dict[str, Callable[[], Any]] = {}
        self._writers: dict[str, Callable[[float], None]] = {}
        self._counts: dict[Time, int] = {}
        self._last = plan.clock.stop // (1 if plan.adaptive else plan.clock.hyperperiod)  # no step is below a tick
        self._shorter = int(not plan.adaptive and plan.clock.rest > 0)  # one more, which ends at the stop
        self._guard = ExitStack()
        self._guarded = False
        self._snapshots: list[Snapshot] = []
        self._hands = self.events.hands
        self._quick, self._cells = one_step(self), self.control.data

    def __repr__(self) -> str:
        return f"<Session of {self.plan.system.name} at {self.time:.9g} s of {self.stop:g} s>"

    def _repr_html_(self) -> str:
        """In a notebook: the time that is reached, how the session stands, and values of now."""
        from .shown import session_html

        return session_html(self)

    def __dir__(self) -> list[str]:
        """What is meant to be used; the rest is the run's own."""
        return sorted(PUBLIC)

    @property
    def period(self) -> float:
        """Length of a step [s]; with ECCO that of the first."""
        return float(self.plan.clock.seconds(self.plan.clock.hyperperiod))

    @property
    def stop(self) -> float:
        """The time [s] behind which there are no steps."""
        return self.plan.clock.time(self.plan.clock.stop)

    def step(self, by: Time | None = None) -> None:
        """Go on by one step, or by a time such as "10 ms" or 0.01, which must be a multiple of `period`.

        Raises RunError if the run fails or has ended, InputError for a time that does not fit.
        """
        if by is None and self._guarded and self._quick():
            if self.failure or self._cells[STOP_REQUEST]:
                self._settle()
            self._cells[STOP_REQUEST] = 1
            return
        if by is not None and by not in self._counts:
            self._counts[by] = self.cycles(by, "step")
        count = 1 if by is None else self._counts[by]
        self._require_alive()
        last = self._last + self._shorter if by is None else self._last
        if self.at.cycle + count > last or (self._adaptive and self.tick >= self.plan.clock.stop):
            raise self._at_stop()
        self.control[STOP_REQUEST] = 0
        if self._hands.waiting:
            act(self)
        if self._adaptive and by is not None:
            until = min(self.tick + count * self.plan.clock.hyperperiod, self.plan.clock.stop)
            self.advance(until_tick=until)
        elif self._guarded:  # without what `advance` does around its blocks
            at = self.at
            end = at.cycle + count
            while at.cycle < end and not self.over:
                self._run_block(end - at.cycle)
            if self.observers and not self.failure:
                self._show(self.observers)
        else:
            self.advance(cycles=count)
        self._settle()

    def _settle(self) -> None:
        """Raise what came up; a Ctrl-C between this step and the next one need not wait for it."""
        if self.failure:
            self.result().require_good()
        if self._guarded:
            if self.control[STOP_REQUEST]:
                raise KeyboardInterrupt
            self.control[STOP_REQUEST] = 1

    def finish(self, progress: Callable[[float], None] | None = None, until_tick: int | None = None) -> None:
        """Go on to a tick or to the stop, or until `failure` is set."""
        self.control[STOP_REQUEST] = 0
        self.advance(until_tick=until_tick, progress=progress)
        if self._guarded and not self.failure:
            self._settle()

    def _at_stop(self) -> RunError:
        return RunError(
            f"t = {self.time:.9g} s: there is no whole step before the stop at "
            f"{seconds_text(self.plan.system.stop)}; start with another stop time"
        )

    def result(self) -> Result:
        """What was recorded so far."""
        self._act()
        return Result(self.run())

    def happen(self, name: str) -> None:
        """Have an event with `by_hand = true` happen now, as a scenario would have it at this time.

        All that is done between two steps happens at one instant, when the run goes on or is looked at with `get` or
        `result`; what was said last of an event counts. An event that lasts goes on with its time anew. Raises
        InputError for an unknown name or an event that is not by hand, RunError at the stop or if the session has
        ended.
        """
        self._require_step()
        self._hands.happen(name, self.plan.clock.seconds(self.plan.clock.start + self.tick))

    def end(self, name: str) -> None:
        """Have the fault of an event with `by_hand = true` end now; nothing if it is not there. Errors as of `happen`,
        also for an event that is no fault."""
        self._require_step()
        self._hands.end(name)

    def scenario(self) -> str:
        """What was done by hand until now, as the text of a scenario with which a run does the same by itself: events,
        and inputs that events set. Its rows are the same bits but with `ecco` and `adaptive`, whose steps end where an
        event is known to come."""
        self._act()
        return as_scenario(self.plan, self._hands, self.plan.clock.seconds(self.plan.clock.start + self.tick))

    def _require_step(self) -> None:
        self._require_alive()
        if self.tick >= self.plan.clock.stop:
            raise self._at_stop()

    def _act(self) -> None:
        """What was done by hand happens, if anything was. Raises RunError if it goes wrong."""
        if self._hands.waiting and not self.over and not self.closed:
            self.control[STOP_REQUEST] = 0
            act(self)
            self._settle()

    def cycles(self, by: Time, what: str) -> int:
        """How many steps a time has. Raises InputError if it is no whole number of them."""
        return steps_in(self.plan, by, what)

    def get(self, name: str) -> Any:
        """The value of `component.variable` now; of an array all values. Raises InputError for an unknown name."""
        if self._hands.waiting:
            self._act()
        return (self._readers.get(name) or self.reader(name))()

    def reader(self, name: str) -> Callable[[], Any]:
        """What gives the value of `get(name)` at any time, as long as the session is open. Raises InputError."""
        reader = self._readers.get(name)
        if reader is None:
            reader = self._readers[name] = reader_by_name(self, name)
        return reader

    def set(self, name: str, value: object) -> None:
        """Set an input that nothing drives, from the next step on; of an array a sequence of all values.

        An input that events of the system set is set as one, as `happen` says: it counts at this instant. Raises
        InputError for an unknown name, a driven input, a parameter, a wrong type or a value out of range.
        """
        if not isinstance(value, float):
            self._set(name, value)
        else:
            (self._writers.get(name) or self.writer(name))(value)

    def writer(self, name: str) -> Callable[[float], None]:
        """What does `set(name, value)` with a number, with the same errors, quicker from the second time on."""
        if name not in self._writers:
            self._writers[name] = writer_by_name(self, name, self._set)
        return self._writers[name]

    def _set(self, name: str, value: object) -> None:
        self._require_alive()
        component, _, variable = self.plan.system.full_name(name).partition(".")
        owner = self.plan.system.components.get(component)
        scalars = owner.fmu.expand(variable) if owner else ()
        if self.tick < self.plan.clock.stop and self._hands.sets(component, scalars):
            given = plain(value.tolist() if hasattr(value, "tolist") else value)
            self._hands.set(name, given, *self._access.checked(name, value))
        else:
            super().set(name, value)

    def snapshot(self) -> Snapshot:
        """Where the run is now, to come back to with `restore`: any number of them, kept until they are released.

        Rows that were recorded until then are copied. The run goes on bit for bit as if none had been taken, and as if
        it had never left when it is restored; but with CVODE, which begins anew here unless `[solver]` says
        `restart = true`. Raises InputError that names the FMUs that cannot save their states, RunError if the session
        has ended, FmuError if an FMU does not save its state.
        """
        self._require_alive()
        self._act()
        self._snapshots = [kept for kept in self._snapshots if not kept.released]
        self._snapshots.append(take_snapshot(self))
        return self._snapshots[-1]

    def restore(self, snapshot: Snapshot) -> None:
        """Go back (or forth) to a snapshot of this session, which stays; results that were taken stay as they are.

        A session that has failed or ended goes on from there, if its FMUs are alive. Raises InputError for a snapshot
        of another session or one that was released, RunError if the session is closed, FmuError if an FMU does not go
        back.
        """
        self._require_open()
        self._hands.forget()
        go_back(self, snapshot)

    def names(self, patterns: Iterable[str]) -> list[str]:
        """The outputs and signals of the coupling that patterns such as `motor.*` name.

        Raises InputError for one that names nothing.
        """
        return outputs_named(self.plan, patterns)

    def close(self) -> None:
        """Give the FMUs back."""
        self._readers.clear()
        self._writers.clear()
        for snapshot in self._snapshots:
            snapshot.release()
        super().close()

    def __enter__(self) -> Stepping:
        self._guard.enter_context(self.stop_requests.heard())
        self._guarded = True
        self.control[STOP_REQUEST] = 1
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._guarded = False
        self._guard.close()
        super().__exit__(kind, error, trace)
