"""Jacobi with macro steps by step doubling: each is done whole and in two halves, and kept if both agree.

For systems without power bonds whose FMUs can save their states; see `loop/solvers/step_doubling` for the method. The
signals that are judged are the floating-point outputs that drive an input.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from msgspec import Meta

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...loop.operations import ADVANCE, ESTIMATE, HALVE, PUSH, REPEAT, RESTORE, SAVE
from ...loop.solvers.step_doubling import EVEN, INDICATOR, WORK_CELLS, WORST
from ...system.connection import Connection
from ...system.model import System
from ...system.schema.keys.values import Positive
from ..capabilities import require_state
from ..design import Design
from ..schedule.formulas import Choice
from ..schedule.layout import Key, Layout
from ..schedule.schedule import Schedule
from ..schedule.values import Row
from .base import LoopArrays
from .varying_steps import Largest, Smallest, VaryingSchedule, VaryingSteps

if TYPE_CHECKING:
    from ..plan import Plan


@dataclass(frozen=True)
class AdaptiveSettings:
    """`[adaptive]`: the tolerance of the error of a step, limits of the step and of its change."""

    tolerance: Annotated[
        Positive, Meta(description="error of a step, relative to an output or to its nominal value if larger [1]")
    ] = 1e-4
    minimum: Smallest = None
    maximum: Largest = None
    safety: Annotated[Positive, Meta(description="factor of every new step [1]")] = 0.9
    shrink: Annotated[Positive, Meta(description="smallest ratio of two steps [1]")] = 0.2
    grow: Annotated[Positive, Meta(description="largest ratio of two steps [1]")] = 2.0

    def __post_init__(self) -> None:
        if not (self.shrink < 1.0 < self.grow and self.safety < 1.0):
            raise InputError(
                f"adaptive: shrink = {self.shrink:g} and safety = {self.safety:g} must be below 1 and grow = "
                f"{self.grow:g} above"
            )


class Adaptive(VaryingSteps):
    """Steps by the error of what is exchanged; a step that errs too much is repeated from saved states."""

    name = "adaptive"
    heading = "adaptive"
    Settings = AdaptiveSettings
    saves_states = True
    takes_noise = False
    even = EVEN
    units: ClassVar[Mapping[str, str]] = {"tick": "1", "step": "s", "indicator": "1", "rejected": "1"}
    why_hold = "compares steps with held inputs"
    settings: AdaptiveSettings

    def explanation(self) -> str:
        return (
            f"all at once; the macro step is such that one whole and two halves of it agree within "
            f"{self.settings.tolerance:g}, and is repeated from saved states where they do not"
        )

    def check(self, system: System) -> None:
        """Every FMU takes steps of any length, and can go back."""
        super().check(system)
        for component in system.components.values():
            require_state(component, f"algorithm '{self.name}'")

    def require_measure(self, system: System) -> None:
        if not judged(system):
            raise InputError(
                f"algorithm 'adaptive' judges the floating-point outputs that drive inputs, and no connection has one; "
                f"take another algorithm ({system.path.name})"
            )

    def extend(self, system: System, clock: Clock, order: tuple[str, ...], choices: Mapping[Connection, Choice],
               layout: Layout) -> None:  # fmt: skip
        super().extend(system, clock, order, choices, layout)
        layout.extra("rejected", "1", "how often that step was done again, shorter", clock.hyperperiod)
        for after in ("a whole step", "two halves"):
            for component, variable in judged(system):
                layout.slot(f"{component}.{variable} after {after}")

    def schedule(self, design: Design) -> Schedule:
        return AdaptiveSchedule(design, self.settings)

    def arrays(self, plan: Plan) -> LoopArrays:
        return super().arrays(plan)._replace(work=np.zeros(WORK_CELLS), saved=np.zeros(plan.layout.size))

    def figures(self, values: Callable[[str], np.ndarray]) -> dict[str, Any]:
        return {**super().figures(values), "steps_rejected": int(np.sum(values("rejected")))}

    def failure(self, plan: Plan, arrays: LoopArrays, at: float) -> str:
        key = judged(plan.system)[int(arrays.work[WORST])]
        minimum = seconds_text(self.limits(plan.system)[0])
        return (
            f"the error of {'.'.join(key)} in the step to t = {at:.9g} s is {arrays.work[INDICATOR]:.3g} times the "
            f"tolerance {self.settings.tolerance:g}, and the step is no longer than the smallest allowed, {minimum}; "
            f"lower minimum under [adaptive], or raise tolerance"
        )


def judged(system: System) -> list[Key]:
    """The outputs whose error counts, each once."""
    found = {c.source: system.components[c.source[0]].fmu.is_real(c.source[1]) for c in system.connections}
    return [key for key, real in found.items() if real]


class AdaptiveSchedule(VaryingSchedule):
    """Save; a whole step; back; two halves; judge; back again or on."""

    def __init__(self, design: Design, settings: AdaptiveSettings) -> None:
        super().__init__(design)
        self.settings = settings

    def rows(self) -> Iterator[Row]:
        end, keys = self.clock.hyperperiod, judged(self.system)
        own = self.layout.extras["coupling", "tick"].slot  # this signal and all behind it are the algorithm's own
        whole = self.layout.extras["coupling", "rejected"].slot + 1
        back: list[Row] = [(RESTORE, end, c, 0, 0, 0, 0, 0) for c in self.index.values()]
        back.append((RESTORE, end, -1, own, 0, 0, 0, 0))
        rows: list[Row] = [*self.events(0), *((SAVE, 0, c, 0, 0, 0, 0, 0) for c in self.index.values())]
        rows.append((SAVE, 0, -1, own, 0, 0, 0, 0))
        again = len(rows)
        rows += [*self._step_of_all(), *self._kept(keys, whole), (HALVE, end, -1, 0, 0, 0, 0, 0), *back]
        rows += [*self._step_of_all(), *self.settle(end), (ADVANCE, end, -1, 0, 0, 0, 0, 0)]
        rows += [*self._step_of_all(), *self._kept(keys, whole + len(keys))]
        on = len(rows) + 1 + len(back) + 1
        rows.append((ESTIMATE, end, -1, on, own, whole, len(keys), self._settings(keys)))
        yield from rows
        yield from back
        yield (REPEAT, end, -1, again, 0, 0, 0, 0)
        yield from self.energies(end)
        yield from self.settle(end)
        yield from self.tables(end)

    def _step_of_all(self) -> Iterator[Row]:
        yield from self.begin(0)
        yield from self.steps(self.clock.hyperperiod)

    def _kept(self, keys: list[Key], slot: int) -> Iterator[Row]:
        """What is judged, from `slot` on."""
        for k, key in enumerate(keys):
            source = self.layout.outputs[key]
            yield (PUSH, self.clock.hyperperiod, self.index[key[0]], source, slot + k, 0, 0, 0)

    def _settings(self, keys: list[Key]) -> int:
        s = self.settings
        order = 1.0 if any(self._at_once(key) for key in keys) else 2.0
        return self.constants.at(s.tolerance, s.safety, s.shrink, s.grow, order, *map(self.nominal, keys))

    def _at_once(self, key: Key) -> bool:
        """Whether an output depends at once on an input that is held over the step."""
        answers = self.system.components[key[0]].fmu.feedthrough()[key[1]]
        return any(c.target[1] in answers for c in self.design.into(key[0]))
