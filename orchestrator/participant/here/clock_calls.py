"""The functions of FMI 3.0 about clocks: which of them tick, and after how long the next tick comes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import Any, NamedTuple
from weakref import proxy

from fmpy import fmi3

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...fmu.reading.clocks import ClockVariable, seconds_of
from ..messages import Logging
from ..timetable import Timetable
from .fmi3 import Fmi3Instance

NOT_YET_KNOWN, UNCHANGED, CHANGED = range(3)  # fmi3IntervalQualifier
LARGEST = 2**64 - 1


class Interval(NamedTuple):
    """What an FMU tells of the next tick of a clock: `qualifier`, and the time until then [s] where it is known."""

    qualifier: int
    seconds: Fraction | None


class ClockCalls(Fmi3Instance):
    """Clocks are named as in the description. Raises CallError where they may not be called, or the FMU refuses.

    `timetable`: of its time-based clocks, known from the end of initialization on; `intervals`: those that are chosen
    for it [s]; `active`: the clocks that tick in the present round of an event.
    """

    intervals: Mapping[str, Fraction] = MappingProxyType({})
    timetable: Timetable
    _now = Fraction(0)  # s, the instant of the event that goes on
    active: frozenset[str] = frozenset()

    def __init__(self, fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> None:
        self._kept: dict[int, dict[str, Any]] = {}  # what was known of events, by the handle of a state
        super().__init__(fmu, name, logging, tolerance)
        self._begin_table()

    @property
    def events(self) -> Any:
        return self

    def _begin_clocks(self) -> None:
        """In initialization mode, when all is set: when the clocks tick first."""
        self._begin_table()
        self.timetable.begin(seconds_of(self.span[0] if self.span else 0.0))

    def _begin_table(self) -> None:
        # no cycle: an instance that is dropped is known as a sender of messages no longer
        self.timetable = Timetable(proxy(self), self.fmu.own.clocks.values(), self.intervals)

    def save(self) -> int:
        state = super().save()
        self._kept[state] = self._ahead()
        return state

    def restore(self, state: int) -> None:
        super().restore(state)
        self._go_back(self._kept[state])

    def forget(self, state: int) -> None:
        super().forget(state)
        self._kept.pop(state, None)

    def serialize(self, state: int) -> bytes:
        """A kept state as bytes, behind what is known of its clocks."""
        known = json.dumps(self._kept[state]).encode()
        return len(known).to_bytes(8, "little") + known + super().serialize(state)

    def deserialize(self, content: bytes) -> int:
        end = 8 + int.from_bytes(content[:8], "little")
        state = super().deserialize(content[end:])
        self._kept[state] = json.loads(content[8:end])
        return state

    def _ahead(self) -> dict[str, Any]:
        """What is known of its next events, ready for JSON."""
        table = getattr(self, "timetable", None)
        return {} if table is None else table.content()

    def _go_back(self, known: dict[str, Any]) -> None:
        """The same, of a state that is restored."""
        if known:
            self._begin_table()
            self.timetable.restore(known)

    def clock(self, name: str) -> ClockVariable:
        return self.fmu.own.clocks[name]

    def ticking(self, names: Sequence[str]) -> list[bool]:
        """Which clocks tick at this instant."""
        values = (fmi3.fmi3Clock * len(names))()
        get = self.slave.fmi3GetClock
        self.call("get clocks", f"ask clock {', '.join(names)}", get, *self._references(names), values)
        return [bool(value) for value in values]

    def tick(self, names: Sequence[str], active: bool = True) -> None:
        """Activate input clocks at this instant, or deactivate them again."""
        if names:
            values = (fmi3.fmi3Clock * len(names))(*(active for _ in names))
            what = f"{'tick' if active else 'deactivate'} clock {', '.join(names)}"
            self.call("set clocks", what, self.slave.fmi3SetClock, *self._references(names), values)

    def interval(self, name: str) -> Interval:
        """The time from this instant to the next tick of a time-based clock. Raises FmuError for one that is none."""
        qualifier = (fmi3.fmi3IntervalQualifier * 1)()
        what = f"ask for the interval of clock {name}"
        if self.clock(name).fractions:
            counters, resolutions = (fmi3.fmi3UInt64 * 1)(), (fmi3.fmi3UInt64 * 1)()
            get = self.slave.fmi3GetIntervalFraction
            values: tuple[object, ...] = (counters, resolutions, qualifier)
        else:
            decimals = (fmi3.fmi3Float64 * 1)()
            get, values = self.slave.fmi3GetIntervalDecimal, (decimals, qualifier)
        self.call("get intervals", what, get, *self._references([name]), *values)
        told = int(qualifier[0])
        if told == NOT_YET_KNOWN:
            return Interval(told, None)
        try:
            if told not in (UNCHANGED, CHANGED):
                raise ValueError(f"its qualifier is {told}")
            seconds = (
                Fraction(counters[0], resolutions[0]) if self.clock(name).fractions else seconds_of(float(decimals[0]))
            )
            if seconds < 0:
                raise ValueError(f"it is {float(seconds):g} s")
        except (ValueError, ZeroDivisionError) as error:
            raise FmuError(f"component {self.name}: the interval of clock {name} cannot be: {error}") from None
        return Interval(told, seconds)

    def shift(self, name: str) -> Fraction:
        """The time from the start to the first tick of a periodic clock [s]."""
        what = f"ask for the shift of clock {name}"
        if self.clock(name).fractions:
            counters, resolutions = (fmi3.fmi3UInt64 * 1)(), (fmi3.fmi3UInt64 * 1)()
            get = self.slave.fmi3GetShiftFraction
            self.call("get intervals", what, get, *self._references([name]), counters, resolutions)
            if resolutions[0]:
                return Fraction(counters[0], resolutions[0])
            raise FmuError(f"component {self.name}: the shift of clock {name} cannot be: {counters[0]}/0 s")
        decimals = (fmi3.fmi3Float64 * 1)()
        self.call("get intervals", what, self.slave.fmi3GetShiftDecimal, *self._references([name]), decimals)
        try:
            return seconds_of(float(decimals[0]))
        except ValueError as error:
            raise FmuError(f"component {self.name}: the shift of clock {name} cannot be: {error}") from None

    def set_interval(self, name: str, seconds: Fraction) -> None:
        """Tell the interval of a clock that is the importer's to choose [s]; as a fraction where the FMU takes one."""
        clock, what = self.clock(name), f"set the interval of clock {name} to {seconds} s"
        if clock.fractions:
            counter, resolution = seconds.numerator, seconds.denominator
            if clock.resolution and clock.resolution % resolution == 0:
                counter, resolution = counter * (clock.resolution // resolution), clock.resolution
            if max(counter, resolution) > LARGEST:
                raise FmuError(f"component {self.name}: cannot {what}: its parts are beyond 64 bits")
            set_, values = self.slave.fmi3SetIntervalFraction, (
                (fmi3.fmi3UInt64 * 1)(counter), (fmi3.fmi3UInt64 * 1)(resolution),
            )  # fmt: skip
            self.call("set intervals", what, set_, *self._references([name]), *values)
        else:
            decimals = (fmi3.fmi3Float64 * 1)(float(seconds))
            self.call("set intervals", what, self.slave.fmi3SetIntervalDecimal, *self._references([name]), decimals)

    def _references(self, names: Sequence[str]) -> tuple[object, object, int]:
        """What every function of clocks takes first: the instance, value references and their number."""
        references = (fmi3.fmi3ValueReference * len(names))(*(self.clock(name).reference for name in names))
        return self.slave.component, references, len(names)
