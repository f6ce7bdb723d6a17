"""The operations of one macro step whose length is chosen as the run goes, and its clock."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd, lcm

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...loop.operations import CONTROL, GAUGE
from ...system.model import System
from ..bond_energy import key_of
from ..layout import Layout
from ..schedule import Row, Schedule

RESOLUTION = 1000  # ticks in the smallest step, at least


def step_limits(system: System) -> tuple[Fraction, Fraction]:
    """Smallest and largest macro step [s]: as stated, or a hundredth and the hundredfold of the period."""
    period = next(iter(system.components.values())).period
    return system.ecco.minimum or period / 100, system.ecco.maximum or 100 * period


def adaptive_clock(system: System) -> Clock:
    """A fine tick; the common period is the first step. Raises InputError where the system is no case for ECCO."""
    periods = {name: component.period for name, component in system.components.items()}
    first = next(iter(periods.values()))
    minimum, maximum = step_limits(system)
    where = f"({system.path.name})"
    if len(set(periods.values())) > 1:
        shown = ", ".join(f"{name} {seconds_text(period)}" for name, period in periods.items())
        raise InputError(
            f"algorithm 'ecco' steps all components together, so they need one period, the first step; there are "
            f"{shown} {where}"
        )
    if not any(bond.flow[1] for bond in system.bonds):
        raise InputError(
            f"algorithm 'ecco' judges the energy made at power bonds; declare one in [[bonds]], with effort and flow "
            f"connected {where}"
        )
    if not minimum <= first <= maximum:
        raise InputError(
            f"ecco: the period {seconds_text(first)} is the first step and must be between minimum "
            f"{seconds_text(minimum)} and maximum {seconds_text(maximum)} {where}"
        )
    fine = Fraction(1)
    while fine * RESOLUTION > minimum:
        fine /= 10
    times = (fine, first, minimum, maximum, system.stop)
    denominator = lcm(*(t.denominator for t in times))
    numerator = gcd(*(int(t * denominator) for t in times))
    stop = int(system.stop * denominator) // numerator
    if max(stop * numerator, denominator) >= 2**53:  # the loop divides them as doubles
        raise InputError(
            f"no tick as fine as {seconds_text(fine)} counts exactly to {seconds_text(system.stop)}; "
            f"take a larger minimum step {where}"
        )
    ticks = int(first * denominator) // numerator
    return Clock(numerator, denominator, dict.fromkeys(periods, ticks), stop, ticks)


class AdaptiveSchedule(Schedule):
    """A Jacobi step of all components; the operations leave its length open (0), the loop knows it."""

    def rows(self) -> Iterator[Row]:
        yield from self.begin(0)
        yield from self.finish(self.clock.hyperperiod)

    def length(self, name: str) -> int:
        return 0  # the loop's own

    def duration(self, name: str) -> float:
        return 0.0  # the loop's own

    def record(self, tick: int) -> Iterator[Row]:
        """Judge the step before it is recorded; only bonds whose both sides know each other count."""
        settings = self.system.ecco
        *energies, table = super().record(tick)
        yield from energies
        k = self.constants.at(settings.tolerance, settings.relative)
        for bond in self.system.bonds:
            if bond.flow[1]:
                outputs, inputs = self.layout.outputs, self.layout.inputs
                yield (GAUGE, tick, -1, outputs[key_of(bond.effort[0])], inputs[key_of(bond.effort[1])],
                       outputs[key_of(bond.flow[0])], inputs[key_of(bond.flow[1])], k)  # fmt: skip
        gains = (settings.safety, settings.integral, settings.proportional, settings.shrink, settings.grow)
        first = self.layout.extras["coupling", "tick"].slot
        yield (CONTROL, tick, -1, first, 0, 0, 0, self.constants.at(*gains))
        yield table


def add_times(clock: Clock, layout: Layout) -> None:
    """Signals of the step controller, one behind the other: the instant, the step, the indicator."""
    tick = seconds_text(clock.seconds(1))
    layout.extra("tick", "1", f"the instant in ticks of {tick}", clock.hyperperiod)
    layout.extra("step", "s", "length of the step that ends now", clock.hyperperiod)
    layout.extra("indicator", "1", "error indicator of that step, 1 at the tolerance", clock.hyperperiod)
