"""Events of a run: when the loop is to pause, and what is done then.

An event comes from a step that ends early, from a participant that has announced it, or from the system (`[[events]]`).
At its instant everybody who can be there is; values and discrete states go round until nothing changes any more.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial

import numpy as np

from ...errors import RunError
from ...fmu.types import Value
from ...loop import cells
from ...loop.operations import STEP_ON
from ...participant.base import Participant
from ...plan.happening.events import Known
from ...plan.plan import Plan
from ...results.tables import AT_START
from ..memory.memory import Memory
from ..memory.moments import Moments
from ..recording.happened import Happened
from .clocked import Clocked
from .followed import FollowedTables
from .happenings import ByHand, EventMode, Happenings
from .instant import Instant, Place, RunRows, exactly

MOST_ROUNDS = 1000  # of one instant


class EventHandler:
    """`modes`: the participants that have event mode, by name; `others`: what else happens."""

    def __init__(
        self, plan: Plan, instances: Mapping[str, Participant], memory: Memory, moments: Moments,
        control: np.ndarray, components: np.ndarray, run: RunRows, happened: Happened,
        others: Sequence[Happenings] = (),
    ) -> None:  # fmt: skip
        self.plan, self.instances, self.memory, self.moments, self.control = plan, instances, memory, moments, control
        self.instant = Instant(plan, instances, memory, moments, control, components, run)
        self.modes: dict[str, EventMode] = {n: mode for n, i in instances.items() if (mode := i.events) is not None}
        self.by_hand = ByHand()
        self.followed = FollowedTables(plan, memory)
        self.others = [*others, self.followed, self.by_hand]
        self.clocked = Clocked(plan, instances, memory)
        self.happened, self.slots = happened, plan.recorded_slots
        self.ends_at = cells.NEVER  # ticks from time 0; behind it a component does not want to go on
        self.same = 0  # events at one instant, one behind the other

    def begin(self) -> None:
        """Behind initialization, where participants with event mode are in it. Raises RunError, AskedToEndError."""
        self._go_round(Place(self.plan, 0, 0), Fraction(self.plan.clock.start) * self.plan.clock.seconds(1), AT_START)
        self.plan_next()

    def at_once(self, place: Place, now: Fraction) -> None:
        """Do what is due now [s]. Raises RunError, AskedToEndError."""
        self._go_round(place, now, "")
        self.plan_next()

    def end_at(self, tick: int) -> None:
        """The run is to end behind an instant [ticks from time 0]."""
        self.ends_at = tick
        self.plan_next()

    def plan_next(self) -> None:
        """Tell the loop where to pause next."""
        self.control[cells.EVENT_AT], self.control[cells.ENDS_AT] = cells.NEVER, self.ends_at
        due = self._next()
        if due is None:
            return
        clock, ticks = self.plan.clock, exactly(self.plan, due)
        if ticks.denominator == 1 and (any(ticks % p == 0 for p in clock.periods.values()) or ticks == clock.stop):
            self.control[cells.EVENT_AT] = clock.start + int(ticks)
        else:
            self.control[cells.ENDS_AT] = min(self.ends_at, clock.start + math.ceil(ticks) - 1)

    def _next(self) -> Fraction | None:
        """When the next thing is due [s]."""
        known = [*(mode.next_instant() for mode in self.modes.values()), *(o.next_instant() for o in self.others)]
        return min((instant for instant in known if instant is not None), default=None)

    def set_by_hand(self, component: str, values: Mapping[str, Value], cycle: int) -> None:
        """Set inputs that are set at events only: at an event now, before a cycle, or when their clocks tick.

        Raises RunError, AskedToEndError."""
        member, done = self.clocked.members[component], list[str]()
        for variable, value in values.items():
            if variable not in member.given:  # otherwise its cell has the value
                member.by_hand[variable] = value
            if not member.clocks[variable]:
                done.append(f"{component}.{variable} is set")
        if done:
            self.by_hand.words += done
            place = Place(self.plan, cycle, 0)
            self._go_round(place, self.plan.clock.seconds(self.plan.clock.start + place.base), "")
            self.plan_next()

    def paused(self, code: int) -> int | None:
        """Handle why the loop came back; the operation with which it goes on in its cycle, None if that was no event.

        Raises RunError for what goes wrong, AskedToEndError.
        """
        cycle, operation = int(self.control[cells.AT_CYCLE]), int(self.control[cells.AT_OPERATION])
        place = Place(self.plan, cycle, operation)
        row = place.rows[operation]
        if code == cells.PAUSED:
            tick = self.plan.clock.start + place.base + int(row[1])
            if tick < self.control[cells.EVENT_AT] and not self.clocked.happened(
                place.known(place.time_of(int(row[1])))
            ):
                return operation + 1
            self._go_round(place, self.plan.clock.seconds(tick), "")
            operation += 1
        elif code == cells.ENDED and self.plan.clock.start + place.base + int(row[1]) <= self.ends_at:
            due = self._next()
            assert due is not None
            self._go_round(place, due, "")
        elif code == cells.BAD_STATUS and row[0] == STEP_ON:
            k = int(row[2])
            stopped = self.instant.stopped_early(k, place.time_of(int(row[3] + row[4])))
            if stopped is None:
                return None
            time, happened = stopped
            self._require_progress(time, self.instant.names[k])
            if happened:
                self._go_round(place, Fraction(time), happened)
        else:
            return None
        self.plan_next()
        return operation

    def reached(self, cycle: int, operation: int) -> float:
        """How far all components have come [s] where the loop stands."""
        place = Place(self.plan, cycle, operation)
        return min(self.instant.at(name, place) for name in self.plan.order)

    def _go_round(self, place: Place, now: Fraction, cause: str) -> None:
        time, known = float(now), place.known(float(now))
        assert self.plan.events is not None
        for name in self.plan.order:
            while name in self.plan.events.stopped and (found := self.instant.bring(name, place, time)) is not None:
                at, happened = found
                self._require_progress(at, name)
                if happened:
                    self._before(place, name, at, happened)
        self._rounds(place, known, now, cause)

    def _before(self, place: Place, name: str, at: float, cause: str) -> None:
        """An event of a component on its way to another instant: of all that can be stopped, if none is behind it."""
        assert self.plan.events is not None
        if all(self.instant.at(other, place) <= at for other in self.plan.events.stopped):
            self._go_round(place, Fraction(at), cause)
        else:
            together = self.plan.exchange if name in self.plan.exchange else (name,)
            self._rounds(place, frozenset(together), Fraction(at), cause, alone=True)

    def _rounds(self, place: Place, known: Known, now: Fraction, cause: str, alone: bool = False) -> None:
        """Values and discrete states until nothing changes; `alone`: a component that others cannot meet there."""
        time = float(now)
        self.clocked.begin(now)
        modes = [self.modes[name] for name in self.plan.order if name in known and name in self.modes]
        pass_on = _nothing if alone else partial(self.instant.values, place, known, time)
        if cause:  # a step ended here: what is true behind it
            pass_on()
        self._row(time, cause)
        for mode in modes:
            mode.enter_event_mode()
        passed = [name for name in self.instant.names if self.instant.at(name, place) > time]
        done = [] if alone else [words for other in self.others if (words := other.happen(now, passed))]
        for _ in range(MOST_ROUNDS):
            done += [words for mode in modes if (words := mode.happen(now))]
            changed = pass_on()
            exchanged, ticks = self.clocked.exchange(known, pass_on)
            again = any([mode.update() for mode in modes])
            new = pass_on()  # what the update has made so
            done += ticks
            if changed or exchanged or again or new or done:
                self._row(time, "; ".join(done))
            if not again and not new and not self.clocked.happened(known):
                break
            done = []
        else:
            names = ", ".join(mode.name for mode in modes) or "the connections"
            over = [mode.name for mode in modes if (when := mode.next_instant()) is not None and float(when) <= time]
            why = "a model has to come to a state that asks for none"
            if over:
                why = f"{', '.join(over)} announced a next event that is not behind this instant"
            raise RunError(
                f"the events at t = {time:.9g} s do not settle: after {MOST_ROUNDS} rounds {names} still "
                f"ask{'s' * (len(modes) == 1)} for another one, or values still change; {why}"
            )
        for mode in modes:
            mode.leave_event_mode()

    def _require_progress(self, time: float, cause: str) -> None:
        """Raise RunError where one step after the other ends at the same instant."""
        self.same = self.same + 1 if self.happened.last is not None and self.happened.last.time == time else 0
        if self.same > MOST_ROUNDS:
            raise RunError(
                f"time stands still at t = {time:.9g} s: {MOST_ROUNDS} steps have ended there, one behind the other "
                f"({cause}); an event may switch itself on and off (chattering), which a hysteresis would end"
            )

    def _row(self, time: float, what: str) -> None:
        self.happened.add(time, what, self.memory.z[self.slots])


def _nothing() -> bool:
    """What is passed on by a component alone."""
    return False
