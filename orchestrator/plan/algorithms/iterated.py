"""Every macro step is repeated until the coupling is consistent; its operations are in `iterated_schedule`.

The macro step is the hyperperiod. Its unknowns are the inputs of every single step in it. A pass takes them as given,
lets every component do its steps, and collects the image of each unknown: the mean, over its step, of what its source
gave, a straight line over each step of the source.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

import numpy as np
from msgspec import Meta

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...loop.solvers.iteration import COUNT, RESIDUAL, WORST, workspace
from ...system.connection import Connection
from ...system.model import System
from ...system.schema.keys.values import Count, Positive
from ..capabilities import require_state
from ..design import Design
from ..schedule.formulas import ITERATED, Choice
from ..schedule.layout import Key, Layout
from ..schedule.schedule import Schedule
from .base import Algorithm, LoopArrays
from .iterated_schedule import IteratedSchedule

if TYPE_CHECKING:
    from ..plan import Plan

Step = tuple[Key, int]  # an input, and the number of its step in the cycle
LARGEST_NEWTON = 100  # unknowns: each costs a pass


@dataclass(frozen=True)
class IteratedSettings:
    """`[iteration]`: the residual of an input is relative to its size, or to its nominal value where that is larger."""

    method: Annotated[
        Literal["aitken", "newton"], Meta(description="fixed point with Aitken's relaxation, or Newton")
    ] = "aitken"
    inputs: Annotated[
        Literal["mean", "end"],
        Meta(description="over a step: the mean of the source over it (second order), or its value at the end (first)"),
    ] = "mean"
    sweep: Annotated[
        Literal["jacobi", "gauss-seidel"],
        Meta(description="a pass takes what the one before it gave, or where it is known what this one gave"),
    ] = "jacobi"
    tolerance: Annotated[Positive, Meta(description="residual at which the inputs of a step are consistent [1]")] = 1e-8
    max_iterations: Annotated[
        Count, Meta(description="passes of one step, those for a Jacobian aside, before the run fails [1]")
    ] = 50


class Iterated(Algorithm):
    """Every macro step is repeated from saved states until its inputs agree with what their sources gave."""

    name = "iterated"
    heading = "iteration"
    Settings = IteratedSettings
    saves_states = True
    repeats_rows = True
    acts_at_macro_steps = True
    units: ClassVar[Mapping[str, str]] = {"iterations": "1", "residual": "1"}
    settings: IteratedSettings

    def explanation(self) -> str:
        s = self.settings
        wanted = "the mean of both ends of its step" if s.inputs == "mean" else "the value at the end of its step"
        order = "; a pass takes the latest values" if s.sweep == "gauss-seidel" else ""
        return (
            f"each macro step repeated from saved states ({s.method}, at most {s.max_iterations} times) until every "
            f"input is {wanted} within {s.tolerance:g}{order}"
        )

    def check(self, system: System) -> None:
        """Every FMU can go back."""
        for component in system.components.values():
            require_state(component, f"algorithm '{self.name}'")

    def transfer(
        self, system: System, clock: Clock, c: Connection, samplers: tuple[str, ...], leaders: tuple[str, ...]
    ) -> Choice:
        sampler = next((end[0] for end in (c.source, c.target) if end[0] in samplers), None)
        if sampler and c.transfer in ("", "hold"):
            return Choice("hold", f"{sampler} samples its inputs and holds its outputs")
        held = "the mean over their step" if self.settings.inputs == "mean" else "the value at the end of their step"
        if sampler or c.transfer not in ("", "mean" if self.settings.inputs == "mean" else ""):
            raise InputError(
                f"connection {c.label}: algorithm 'iterated' holds inputs at {held}, so "
                f"'{c.transfer}' has no meaning; leave it out {c.where}"
            )
        if self.settings.inputs == "mean":
            return Choice(
                "iterated", "the mean of the source over the step, both ends known by iteration: second order"
            )
        if clock.periods[c.target[0]] % clock.periods[c.source[0]] == 0:
            return Choice("end", "the source at the end of the step, known by iteration: first order")
        return Choice("end on line", "the source at the end of the step, on the line over its own: first order")

    def extend(self, system: System, clock: Clock, order: tuple[str, ...], choices: Mapping[Connection, Choice],
               layout: Layout) -> None:  # fmt: skip
        """Iterations, residual, unknowns, images. Raises InputError if Newton has many unknowns."""
        layout.extra("iterations", "1", "passes, but those for a Jacobian, that the step took", clock.hyperperiod)
        layout.extra("residual", "1", "largest relative residual of an input at the end", clock.hyperperiod)
        steps, known = self._steps(clock, clock.hyperperiod, order, choices)
        if self.settings.method == "newton" and len(steps) > LARGEST_NEWTON:
            raise InputError(
                f"iteration: Newton with {len(steps)} unknowns (inputs times steps in "
                f"{seconds_text(clock.seconds(clock.hyperperiod))}), more than {LARGEST_NEWTON}; "
                f'take method = "aitken" ({system.path.name})'
            )
        _place(layout, layout.unknowns, layout.images, steps, known)
        if clock.rest:
            layout.last_counted = layout.slot("iterations of the last step")
            layout.slot("residual of the last step")
            last = self._steps(clock, clock.rest, order, choices)
            _place(layout, layout.last_unknowns, layout.last_images, *last)

    def _steps(
        self, clock: Clock, span: int, order: tuple[str, ...], choices: Mapping[Connection, Choice]
    ) -> tuple[list[Step], list[Step]]:
        """The steps of iterated inputs in a span: those whose inputs are unknown, and those that a pass knows."""
        unknown: list[Step] = []
        known: list[Step] = []
        for c, choice in choices.items():
            if choice.transfer in ITERATED:
                for j in range(-(-span // clock.periods[c.target[0]])):
                    (known if self._known(clock, span, order, c, j) else unknown).append((c.target, j))
        return unknown, known

    def _known(self, clock: Clock, span: int, order: tuple[str, ...], c: Connection, j: int) -> bool:
        """Whether a pass knows all that step j of an input needs when that step is done."""
        end = (j + 1) * clock.periods[c.target[0]]
        before = order.index(c.source[0]) < order.index(c.target[0])
        together = end >= span or end % clock.periods[c.source[0]] == 0
        return self.settings.sweep == "gauss-seidel" and before and together

    def schedule(self, design: Design) -> Schedule:
        return IteratedSchedule(design, self.settings)

    def arrays(self, plan: Plan) -> LoopArrays:
        unknowns = max(len(plan.layout.unknowns), len(plan.layout.last_unknowns))
        work = workspace(unknowns, self.settings.method == "newton")
        return super().arrays(plan)._replace(work=work, saved=np.zeros(plan.layout.size))

    def figures(self, values: Callable[[str], np.ndarray]) -> dict[str, Any]:
        count, residual, s = values("iterations"), values("residual"), self.settings
        found = {
            "method": s.method, "tolerance": s.tolerance, "iterations": int(np.sum(count)),
            "iterations_max": int(np.max(count)), "residual_max": float(np.max(residual)),
        }  # fmt: skip
        return {"iteration": found, "iterations_max": found["iterations_max"]}

    def failure(self, plan: Plan, arrays: LoopArrays, at: float) -> str:
        s, work = self.settings, arrays.work
        last = plan.clock.rest and at > plan.clock.time(plan.clock.cycles * plan.clock.hyperperiod)
        names = [".".join(key) for key, _ in (plan.layout.last_unknowns if last else plan.layout.unknowns)]
        return (
            f"the coupling did not converge in the step to t = {at:.9g} s: residual {work[RESIDUAL]:.3g} of "
            f"{names[int(work[WORST])]} after {int(work[COUNT])} iterations "
            f"({s.method}, tolerance {s.tolerance:g}); take smaller periods"
            + (', or method = "newton" under [iteration]' if s.method == "aitken" else "")
        )


def _place(
    layout: Layout, unknowns: dict[Step, int], images: dict[Step, int], steps: Iterable[Step], known: Iterable[Step]
) -> None:
    """Cells of unknowns, one behind the other, of their images, and of what a pass knows."""
    steps = list(steps)
    for table, words in ((unknowns, "unknown"), (images, "image of")):
        for key, j in steps:
            table[key, j] = layout.slot(f"{words} {'.'.join(key)}, step {j + 1}")
    for key, j in known:
        images[key, j] = layout.slot(f"what {'.'.join(key)} is sent, step {j + 1}")
