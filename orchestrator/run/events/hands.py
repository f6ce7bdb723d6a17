"""What is done by hand between two steps: events that wait for it, and inputs that events set.

It is kept until the run goes on or is looked at. All that was done between two steps happens then, at the instant
between them and as if a scenario had stated it: see `run/session/by_hand.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from ...clock import seconds_text
from ...errors import InputError, nearest
from ...fmu.types import Value
from ...plan.happening.scenario import end_of
from ...plan.plan import Plan
from ...system.event import Key, set_inputs

if TYPE_CHECKING:
    from .scenario import Scenario


class Done(NamedTuple):
    """What was done at an instant [s]: event `number` happened or ended, or what `name` was set to."""

    time: Fraction
    number: int = -1
    ends: bool = False
    name: str = ""
    value: Any = None


class Hands:
    """`waiting`: whether anything is still to happen; `log`: what was done until now, in its order."""

    def __init__(self, plan: Plan, scenario: Scenario | None) -> None:
        self.plan, self.scenario = plan, scenario
        self.log: list[Done] = []
        self.waiting = False
        self._events: dict[int, bool] = {}  # by number, whether it ends; what was said last counts
        self._values: dict[Key, Value] = {}
        self._said: dict[str, Any] = {}  # what was set, as it was given
        self._numbers = {event.name: k for k, event in enumerate(plan.system.events)}
        self._settable = frozenset(set_inputs(plan.system.events))

    def happen(self, name: str, now: Fraction) -> None:
        """An event is to happen. Raises InputError for one that does not wait for that."""
        number = self._number("happen", name)
        event = self.plan.system.events[number]
        if event.until is not None and event.until <= now:
            raise InputError(f"happen {name}: it lasts until {seconds_text(event.until)}, which is over")
        self._events[number] = False
        self.waiting = True

    def end(self, name: str) -> None:
        """The fault of an event is to end; nothing if it is not there. Raises InputError."""
        number = self._number("end", name)
        if self.plan.system.events[number].fault is None:
            raise InputError(f"end {name}: it sets values, which stay; a second event can set them back")
        self._events[number] = True
        self.waiting = True

    def sets(self, component: str, scalars: Sequence[str]) -> bool:
        """Whether events set all these inputs, so that setting them is one too."""
        return bool(scalars) and all((component, scalar) in self._settable for scalar in scalars)

    def set(self, name: str, given: Any, component: str, values: Mapping[str, Value]) -> None:
        """Values of such inputs, checked; `name` was `given` them."""
        self._values |= {(component, scalar): value for scalar, value in values.items()}
        self._said.pop(name, None)
        self._said[name] = given
        self.waiting = True

    def begin(self, now: Fraction) -> None:
        """What waits is due now [s]: the scenario does it at the instant that comes next."""
        assert self.scenario is not None
        events, self._events = self._events, {}
        values, self._values, said, self._said = self._values, {}, self._said, {}
        self.waiting = False
        for number, ends in sorted(events.items()):
            if self.scenario.by_hand(number, now, ends):
                self.log.append(Done(now, number, ends))
        self.scenario.to_set |= {key: (value, now) for key, value in values.items()}
        self.log += [Done(now, name=name, value=value) for name, value in said.items()]

    def forget(self) -> None:
        """What waits does not happen."""
        self._events, self._values, self._said, self.waiting = {}, {}, {}, False

    def _number(self, what: str, name: str) -> int:
        known = [event.name for event in self.plan.system.events if event.by_hand]
        number = self._numbers.get(name, -1)
        if number < 0:
            none = "; the system has no event with by_hand = true" if not known else nearest(name, known)
            raise InputError(f"{what} {name}: no event is called '{name}'{none}")
        event = self.plan.system.events[number]
        if not event.by_hand:
            when = f"when {event.when.text}" if event.when else "as it is given"
            when = f"at {seconds_text(event.at)}" if event.at is not None else when
            raise InputError(f"{what} {name}: it happens {when} and not by hand; give it by_hand = true instead")
        return number

    def content(self) -> list[list[Any]]:
        """The log, ready for JSON."""
        return [[str(done.time), *done[1:]] for done in self.log]

    def restore(self, content: Sequence[Sequence[Any]]) -> None:
        """Another log. Raises ValueError, TypeError for what is none."""
        self.forget()
        self.log = [Done(Fraction(time), *rest) for time, *rest in content]

    def spans(self) -> list[tuple[Done, Fraction | None]]:
        """What was done, each with the end of its fault [s]; an event that happened while it lasted goes on."""
        found: list[tuple[Done, Fraction | None]] = []
        last: dict[int, int] = {}
        for done in self.log:
            before = last.get(done.number)
            open_ = before is not None and ((end := found[before][1]) is None or end > done.time)
            if done.ends:
                if before is not None and open_:
                    found[before] = found[before][0], done.time
                continue
            event = self.plan.system.events[done.number] if done.number >= 0 else None
            ends = end_of(event, done.time) if event and event.fault else None
            if event and event.fault and before is not None and open_:
                found[before] = found[before][0], ends
                continue
            if event and event.fault:
                last[done.number] = len(found)
            found.append((done, ends))
        return found
