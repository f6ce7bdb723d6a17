"""What an algorithm of the coupling says of itself: one class for each, in a file of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from ...clock import Clock, make_clock
from ...errors import InputError
from ...loop.cells import CLOCK_CELLS
from ...system.connection import Connection
from ...system.model import System
from ..order import samplers_of
from ..schedule.formulas import Choice
from ..schedule.layout import Layout
from ..transfers import by_rates
from .settings import NoSettings

if TYPE_CHECKING:
    from ..design import Design
    from ..plan import Plan
    from ..schedule.schedule import Schedule


class LoopArrays(NamedTuple):
    """Arrays that the loop works in, see `loop.run`."""

    clock: np.ndarray
    work: np.ndarray
    saved: np.ndarray


class Algorithm:
    """How components are coupled. The default is what holds for one pass through fixed steps."""

    name: ClassVar[str]
    heading: ClassVar[str] = ""  # of the table of its settings in a system file
    Settings: ClassVar[type[Any]] = NoSettings
    steps_vary: ClassVar[bool] = False  # macro steps of all components together, whose length the loop chooses
    saves_states: ClassVar[bool] = False  # goes back to saved states of the FMUs
    repeats_rows: ClassVar[bool] = False  # what was recorded of the last cycle may be of a pass that was not the last
    acts_at_macro_steps: ClassVar[bool] = False  # events act at the beginning of a hyperperiod only
    takes_noise: ClassVar[bool] = True  # a step may have other inputs than another one over the same time
    even: ClassVar[int] = 1  # where steps vary: each is a multiple of so many ticks
    parallel: ClassVar[bool] = False  # one pass, all components at once, as a container of FMUs does it
    one_pass: ClassVar[bool] = False  # every step is made once, of fixed length
    takes_events: ClassVar[bool] = False  # goes along with steps that are stopped in the middle
    units: ClassVar[Mapping[str, str]] = {}  # of the signals `coupling.name` that it records

    def __init__(self, settings: Any) -> None:
        self.settings = settings

    def explanation(self) -> str:
        """What it does, in one line."""
        raise NotImplementedError

    def check(self, system: System) -> None:
        """Raise InputError where its settings, or what FMUs cannot do, do not fit."""

    def clock(self, system: System) -> Clock:
        """Tick, periods and stop. Raises InputError where they do not fit."""
        return make_clock({name: c.period for name, c in system.components.items()}, system.stop, system.start)

    def samplers(self, system: System) -> tuple[str, ...]:
        """Components that step at the beginning of their period because all their inputs are sampled."""
        return samplers_of(system)

    def transfer(
        self, system: System, clock: Clock, c: Connection, samplers: tuple[str, ...], leaders: tuple[str, ...]
    ) -> Choice:
        """How a connection between floating-point signals gets its values. Raises InputError for a stated transfer
        that has no meaning."""
        return by_rates(system, clock, c, samplers, leaders)

    def extend(self, system: System, clock: Clock, order: tuple[str, ...], choices: Mapping[Connection, Choice],
               layout: Layout) -> None:  # fmt: skip
        """Add slots and recorded signals of its own, at the end of the layout."""

    def schedule(self, design: Design) -> Schedule:
        """Its operations."""
        raise NotImplementedError

    def arrays(self, plan: Plan) -> LoopArrays:
        """What the loop begins with."""
        return LoopArrays(np.zeros(CLOCK_CELLS, dtype=np.int64), np.zeros(3), np.zeros(1))

    def figures(self, values: Callable[[str], np.ndarray]) -> dict[str, Any]:
        """How it did, for the summary of a run; `values` gives a signal `coupling.name`."""
        return {}

    def failure(self, plan: Plan, arrays: LoopArrays, at: float) -> str:
        """Why the loop returned NOT_CONVERGED in the step to `at` [s]."""
        raise NotImplementedError


def only_hold(c: Connection, why: str, reason: str) -> Choice:
    """`hold` for a connection that states no other transfer. Raises InputError with `why` otherwise."""
    if c.transfer not in ("", "hold"):
        raise InputError(f"connection {c.label}: {why}, so '{c.transfer}' has no meaning; leave it out {c.where}")
    return Choice("hold", reason)
