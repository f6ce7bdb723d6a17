"""Who brings a live run to its end: a piece after the other, at the pace that is wanted, with commands in between.

What is touched acts one step of the schedule later, as an event of the system: see `touch`. Nothing that is asked or
posted here can fail the run, and nothing waits for whoever looks on.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from contextlib import nullcontext
from fractions import Fraction
from typing import Literal

import msgspec

from ..errors import InputError, RovbrushError, shown
from ..run.session.session import Session
from .messages import Do, Done, Said, State, asked, packed
from .offered import first_signals, hello_of
from .posts import Posts
from .record import Record
from .touch import Given, Touch
from .wire import WAITING, Wire

RATE = 30.0  # updates per second of wall time
GIVEN_UP = 0.2  # s of wall time that a run is behind, beyond which it does not try to catch up
NOTICED = 0.25  # s of wall time between two messages of how the run stands
IDLE = 0.05  # s that a paused run waits for a command
What = Literal["paused", "running", "writing", "ended", "failed"]
WORDS = {"reset": "reset", "end": "ended"}
SLOWEST, FASTEST = 1e-3, 1e3  # times real time


class Driver:
    """`wire()`: the page's server, if it is there. `paused`: whether the run waits at its start."""

    def __init__(
        self, wire: Callable[[], Wire | None], record: Record, diagram: str = "", speed: float = 1.0,
        paused: bool = True, attempt: int = 1, folder: str = "",
    ) -> None:  # fmt: skip
        self._wire, self.record, self._diagram = wire, record, diagram
        self.speed, self.paused, self.attempt, self.folder = speed, paused, attempt, folder
        self.wants = ""  # "reset" or "end", where the run was not to go on
        self.interrupted = False  # by a signal
        self._resting = False
        self._cycles = 1  # at once, of a run that goes as fast as it can
        self._posted = self._noticed = -math.inf
        self._posted_time = math.nan
        self._told: Wire | None = None  # who knows what does not change
        self._what: What = "paused"
        self._why = ""

    def go(self, session: Session) -> None:
        """Bring the run to its stop, or to where it is to end."""
        self.session, self.touch = session, Touch(session.plan)
        self.posts = Posts(session.plan, first_signals(session.plan.system))
        session.observers.append(self.posts)
        self.posts.see(session.recorder.fresh(session.time, session.tick))
        self._cycle = float(session.plan.clock.seconds(session.plan.clock.hyperperiod))
        self._anchor()
        while not self.wants and not session.over and session.tick < session.plan.clock.stop:
            self.obey(IDLE if self.paused else 0.0)
            if session.stop_requests.asked:
                self.interrupted = True
                session.fail(f"{session.stop_requests.reason} at t = {session.time:.9g} s")
            elif not self.wants and not self.paused:
                self._advance()
            self.post()
        self.interrupted |= session.stop_requests.asked
        if self.wants and not session.over:
            session.end_early(f"{WORDS[self.wants]} by hand at t = {session.time:.9g} s")
        self.post(last=True)

    def rest(self, what: Literal["ended", "failed"], why: str, folder: str) -> None:
        """The run has ended and its results are written: a reset and an end can still be asked for."""
        self.wants, self._resting, self._what, self._why, self.folder = "", True, what, why, folder
        self._tell_all()

    def obey(self, patience: float = 0.0) -> None:
        """Do what has been asked for meanwhile."""
        wire = self._wire()
        if wire is None or wire.closed:
            time.sleep(patience)
            return
        if wire is not self._told:
            self._told = wire
            wire.post(packed(hello_of(self.session, self.touch, self.posts, self._diagram)))
            wire.post(self.posts.message())
            self._tell_all()
        for message in wire.take(patience):
            try:
                do = asked(message)
            except msgspec.MsgspecError as error:
                self._say(f"what came is no command: {error}")
                continue
            try:
                self._do(do)
            except RovbrushError as error:
                self._say(str(error), do.viewer)
            except Exception as error:  # a fault of ours: the run is not to be lost for it
                self._say(f"{do.what}: unexpected {type(error).__name__}: {error}", do.viewer)
            self._noticed = -math.inf  # whoever asked sees what became of it

    def _do(self, do: Do) -> None:
        if self._resting and do.what not in ("reset", "end"):
            raise InputError(f"{do.what}: this run has ended; reset begins another one")
        if do.what in ("start", "pause"):
            self.paused = do.what == "pause"
            self._anchor()
        elif do.what == "step":
            self.paused = True
            self.session.advance(cycles=1)
        elif do.what == "speed":
            self._set_speed(do.value)
        elif do.what in ("reset", "end"):
            self.wants = do.what
        elif do.what == "set":
            self._give(*self.touch.set(do.name, do.value, self._next()))
        elif do.what == "break":
            self._give(self.touch.fault(do.name, do.kind, do.value, self._next()))
        elif do.what == "happen":
            self._give(self.touch.happen(do.name, self._next()))
        else:
            self._mend(do.name)

    def _set_speed(self, value: object) -> None:
        self.speed = checked_speed(value)
        self._anchor()

    def _next(self) -> Fraction:
        """The instant at which what is touched now acts [s]. Raises InputError where there is none before the stop."""
        clock = self.session.plan.clock
        tick = self.session.tick + clock.hyperperiod
        if tick >= clock.stop:
            raise InputError(f"the run ends at {clock.time(clock.stop):.9g} s, and no step is left to act on")
        return clock.seconds(clock.start + tick)

    def _give(self, *given: Given) -> None:
        for each in given:
            assert each.event.at is not None
            self.session.events.give(each.number, each.event, withdrawn=each.event.at)
            self.record.add(each.number, each.event.stated)
        self._tell_done()

    def _mend(self, name: str) -> None:
        number = self.touch.mended(name)
        if name not in self.record.faults(self._now()):
            raise InputError(f"{name} is not broken")
        at = self._next()
        if self.record.end(number, at):
            self.session.events.give(number, None, withdrawn=at)
        else:
            self.session.events.end(number, at)
        self._tell_done()

    def _now(self) -> Fraction:
        clock = self.session.plan.clock
        return clock.seconds(clock.start + self.session.tick)

    def _anchor(self) -> None:
        """From here on the pace counts, and what is said of it."""
        if (pacer := self.session.pacer) is not None:
            pacer.factor = self.speed or pacer.factor
        self._last = time.monotonic(), self.session.time
        self._factor = 0.0

    def _advance(self) -> None:
        """The next piece, no longer than an update; it takes as long as the pace wants."""
        pacer = self.session.pacer
        if self.speed and pacer is not None:
            if pacer.behind(self.session.tick) > GIVEN_UP:
                pacer.rebase()
            self.session.advance(cycles=max(int(self.speed / RATE / self._cycle), 1))
            return
        begun = time.monotonic()
        with pacer.at_ease() if pacer is not None else nullcontext():
            self.session.advance(cycles=self._cycles)
        spent = max(time.monotonic() - begun, 1e-6)
        self._cycles = max(round(self._cycles * min(max(1.0 / RATE / spent, 0.5), 2.0)), 1)

    def post(self, last: bool = False) -> None:
        """What is new, not more often than a page can show it."""
        wire, now = self._wire(), time.monotonic()
        if wire is None:
            return
        if last or now >= self._posted + 1.0 / RATE:
            self._posted = max(self._posted + 1.0 / RATE, now - 1.0 / RATE)  # on a grid: as many as RATE says
            if self._posted_time != self.session.time or last:
                self._posted_time = self.session.time
                wire.post(self.posts.message(), WAITING)
        if last or now - self._noticed >= NOTICED:
            self._noticed = now
            self._tell_state()

    def _tell_state(self) -> None:
        session, (wall, reached) = self.session, self._last
        now = time.monotonic()
        if now - wall >= 1.0:
            self._factor, self._last = (session.time - reached) / (now - wall), (now, session.time)
        if not self._resting:
            ending = self.wants or session.over or session.tick >= session.plan.clock.stop
            self._what = "writing" if ending else "paused" if self.paused else "running"
        if (wire := self._wire()) is not None:
            late = session.pacer.lateness() if session.pacer else None
            kept = (late.deadlines, late.missed, late.worst) if late else (0, 0, 0.0)
            state = State(
                self._what, session.time, self.attempt, self.speed, self._factor, *kept, wire.dropped,
                self.record.values(), self.record.faults(self._now()), self._why, self.folder,
            )  # fmt: skip
            wire.post(packed(state))

    def _tell_done(self) -> None:
        wire = self._wire()
        if wire is not None:
            wire.post(packed(Done(self.record.lines(), self.record.toml())))

    def _tell_all(self) -> None:
        self._tell_done()
        self._tell_state()

    def _say(self, text: str, viewer: str = "") -> None:
        wire = self._wire()
        if wire is not None:
            wire.post(packed(Said(text, viewer)))


def checked_speed(value: object) -> float:
    """Times real time; 0: as fast as it goes. Raises InputError for what is no speed."""
    if isinstance(value, int | float) and not isinstance(value, bool) and (value == 0 or SLOWEST <= value <= FASTEST):
        return float(value)
    raise InputError(
        f"speed = {shown(value)} is none; take {SLOWEST:g} to {FASTEST:g} times real time, or 0 for as fast as it goes"
    )
