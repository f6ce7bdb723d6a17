"""Cases in which `rovbrush bench sizes` measures what a component costs as its size grows."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from .timing import started


@dataclass(frozen=True)
class Case:
    """A component with the values that it is given; `counts`: the output that its cost should go with.

    `before`: steps until it has settled, `steps`: those of a round.
    """

    component: str
    words: str
    parameters: Mapping[str, float]
    inputs: Mapping[str, float]
    counts: str
    period: float = 5e-4
    before: int = 9000
    steps: int = 800

    def kernel(self) -> Callable[[int], float]:
        """The kernel under Numba: seconds of the thread's processor time per step, over that many steps."""
        return started(self.component, {**self.parameters, **self.inputs}, self.period)


def brush(words: str, n: int, omega_b: float, delta: float) -> Case:
    """A brush of n filaments; about 4.3 of them are on the hull, if any."""
    return Case("filament_brush", words, {"n": n}, {"omega_b": omega_b, "delta": delta, "v_rov": 0.0}, "contact_count")


def cases() -> list[Case]:
    """All, in the order in which they are printed. Off the hull nobody touches; on it as many, of ever more."""
    return [
        brush("50, off the hull", 50, 15.7, -5e-3),
        brush("5000, off the hull", 5000, 15.7, -5e-3),
        brush("50 at 15.7 rad/s", 50, 15.7, 5e-3),
        brush("500 at 15.7 rad/s", 500, 15.7, 1.4e-5),
        brush("5000 at 15.7 rad/s", 5000, 15.7, -4.16e-5),
        brush("500 at 1.57 rad/s: as many pass", 500, 1.57, 5.6e-5),
        brush("5000 at 0.157 rad/s: as many pass", 5000, 0.157, 5.6e-7),
    ]

