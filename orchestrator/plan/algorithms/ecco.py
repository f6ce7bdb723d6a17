"""Jacobi with macro steps that a controller lengthens and shortens by the energy that the coupling makes at bonds.

S. Sadjina, L. T. Kyllingstad, S. Skjong, E. Pedersen, Energy conservation and power bonds in co-simulations:
non-iterative adaptive step size control and error estimation, Engineering with Computers 33 (2017) 607-620
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar

from msgspec import Meta

from ...errors import InputError
from ...loop.operations import CONTROL, GAUGE
from ...system.model import System
from ...system.schema.keys.values import Positive
from ..design import Design
from ..schedule.bond_energy import key_of
from ..schedule.schedule import Schedule
from ..schedule.values import Row
from .varying_steps import Largest, Smallest, VaryingSchedule, VaryingSteps


@dataclass(frozen=True)
class EccoSettings:
    """`[ecco]`: energy tolerances, limits of the step and the gains of the step controller."""

    tolerance: Annotated[Positive, Meta(description="energy that the coupling may make at a bond in a step [J]")] = 1e-3
    relative: Annotated[Positive, Meta(description="and of the energy that the bond carries over it [1]")] = 1e-2
    minimum: Smallest = None
    maximum: Largest = None
    safety: Annotated[Positive, Meta(description="factor of every new step [1]")] = 0.8
    integral: Annotated[Positive, Meta(description="gain of the indicator of this step [1]")] = 0.15
    proportional: Annotated[Positive, Meta(description="gain of its change [1]")] = 0.2
    shrink: Annotated[Positive, Meta(description="smallest ratio of two steps [1]")] = 0.2
    grow: Annotated[Positive, Meta(description="largest ratio of two steps [1]")] = 1.5

    def __post_init__(self) -> None:
        if not self.shrink < 1.0 < self.grow:
            raise InputError(f"ecco: shrink = {self.shrink:g} must be below 1 and grow = {self.grow:g} above")


class Ecco(VaryingSteps):
    """Steps by the energy of power bonds; no step is repeated."""

    name = "ecco"
    heading = "ecco"
    Settings = EccoSettings
    units: ClassVar[Mapping[str, str]] = {"tick": "1", "step": "s", "indicator": "1"}
    why_hold = "judges held inputs"
    settings: EccoSettings

    def explanation(self) -> str:
        return "all at once; the macro step follows from the energy that the coupling makes at the power bonds"

    def require_measure(self, system: System) -> None:
        if not any(bond.flow[1] for bond in system.bonds):
            raise InputError(
                f"algorithm 'ecco' judges the energy made at power bonds; declare one in [[bonds]], with effort and "
                f"flow connected ({system.path.name})"
            )

    def schedule(self, design: Design) -> Schedule:
        return EccoSchedule(design, self.settings)


class EccoSchedule(VaryingSchedule):
    """One step, judged before it is recorded."""

    def __init__(self, design: Design, settings: EccoSettings) -> None:
        super().__init__(design)
        self.settings = settings

    def rows(self) -> Iterator[Row]:
        yield from self.events(0)
        yield from self.begin(0)
        yield from self.finish(self.clock.hyperperiod)

    def record(self, tick: int) -> Iterator[Row]:
        """Judge the step before it is recorded; only bonds whose both sides know each other count."""
        s = self.settings
        yield from self.energies(tick)
        k = self.constants.at(s.tolerance, s.relative)
        for bond in self.system.bonds:
            if bond.flow[1]:
                outputs, inputs = self.layout.outputs, self.layout.inputs
                yield (GAUGE, tick, -1, outputs[key_of(bond.effort[0])], inputs[key_of(bond.effort[1])],
                       outputs[key_of(bond.flow[0])], inputs[key_of(bond.flow[1])], k)  # fmt: skip
        gains = (s.safety, s.integral, s.proportional, s.shrink, s.grow)
        first = self.layout.extras["coupling", "tick"].slot
        yield (CONTROL, tick, -1, first, 0, 0, 0, self.constants.at(*gains))
        yield from self.settle(tick)
        yield from self.tables(tick)
