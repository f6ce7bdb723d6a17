"""When the time-based clocks of an instance tick next, as exact instants."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import Protocol

from ..errors import FmuError
from ..fmu.reading.clocks import ClockVariable

CHANGED = 2  # fmi3IntervalQualifier


class Asked(Protocol):
    """An instance that can be asked for intervals; see `here.clock_calls`."""

    name: str

    def interval(self, name: str) -> tuple[int, Fraction | None]: ...

    def shift(self, name: str) -> Fraction: ...

    def set_interval(self, name: str, seconds: Fraction) -> None: ...


def time_based(clocks: Iterable[ClockVariable]) -> dict[str, ClockVariable]:
    """The clocks, by name, that tick by themselves at times that are told."""
    return {clock.name: clock for clock in clocks if clock.time_based and clock.causality == "input"}


class Timetable:
    """Of time-based clocks: a period where there is one, and the next tick; times in seconds.

    `clocks`: those that it keeps; `chosen`: intervals that are set instead of those that the description states.
    """

    def __init__(self, instance: Asked, clocks: Iterable[ClockVariable], chosen: Mapping[str, Fraction] | None = None):
        self.instance = instance
        self.clocks = time_based(clocks)
        self.chosen = dict(chosen or {})
        self.periods: dict[str, Fraction] = {}
        self.next: dict[str, Fraction] = {}  # ticks that are known

    def begin(self, start: Fraction) -> None:
        """In initialization mode: tell the intervals that are chosen, and ask for those that the FMU knows alone."""
        for name, clock in self.clocks.items():
            if not clock.periodic:
                seconds = self.instance.interval(name)[1]
                if seconds is not None:
                    self.next[name] = start + seconds
                continue
            period, shift = self.chosen.get(name, clock.interval), clock.shift
            if name in self.chosen and clock.settable:
                self.instance.set_interval(name, self.chosen[name])
            elif period is None:
                period, shift = self.instance.interval(name)[1], self.instance.shift(name)
            self.periods[name] = self._positive(name, period)
            self.next[name] = start + shift

    def due(self) -> Fraction | None:
        """The next tick of any of them."""
        return min(self.next.values(), default=None)

    def ticking(self, now: Fraction) -> list[str]:
        """The clocks that tick now, or should have before; by priority."""
        names = [name for name, instant in self.next.items() if instant <= now or float(instant) == float(now)]
        return sorted(names, key=lambda name: self.clocks[name].priority or 0)

    def ticked(self, names: Collection[str]) -> None:
        """These have ticked: the next tick of a periodic clock is a period later, that of another one is not known."""
        for name in names:
            instant = self.next.pop(name, None)
            if instant is not None and name in self.periods:
                self.next[name] = instant + self.periods[name]

    def ask(self, now: Fraction, ticked: Collection[str] = (), countdowns: bool = True) -> None:
        """Behind an update or an activation: what has become of intervals that the FMU chooses as it goes; those of
        `countdowns` are told otherwise in scheduled execution."""
        for name, clock in self.clocks.items():
            tells = clock.variability == "tunable" and clock.interval is None
            counts = countdowns and clock.variability == "countdown"
            if not (counts or tells or (clock.variability == "changing" and name in ticked)):
                continue
            qualifier, seconds = self.instance.interval(name)
            if seconds is None or (qualifier != CHANGED and clock.variability != "changing"):
                continue
            if tells:
                self.periods[name] = self._positive(name, seconds)
            self.next[name] = now + seconds

    def content(self) -> dict[str, dict[str, str]]:
        """Periods and next ticks as texts, for `restore`."""
        return {
            key: {name: str(seconds) for name, seconds in table.items()}
            for key, table in (("periods", self.periods), ("next", self.next))
        }

    def restore(self, content: Mapping[str, Mapping[str, str]]) -> None:
        """As it was."""
        self.periods, self.next = (
            {name: Fraction(text) for name, text in content[key].items()} for key in ("periods", "next")
        )

    def _positive(self, name: str, period: Fraction | None) -> Fraction:
        if period is None or period <= 0:
            told = "none" if period is None else f"{period} s"
            raise FmuError(f"component {self.instance.name}: the period of clock {name} is {told}; it must be positive")
        return period
