"""The margins of a shipped system, for the strategies that control a force and for brushes of other stiffness."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from ...studies.linear.margins.open_loop import Loop
from ...system.assemble import assemble
from ...system.model import System
from .limits import delay_limit, gain_limit, start_of
from .open_loop import BEGIN, LENGTH, open_loop

STRATEGIES = {"force control": 2, "force, observed": 3}  # modes of the controller; position alone holds no force
BRUSHES = {"shipped": 1.0, "twice as stiff": 4.0}


@dataclass(frozen=True)
class Margins:
    """What the table shows of one system: the loop along the normal, and what all loops together bear."""

    stiffness: float
    loop: Loop
    delay: float
    gain: float


def margins(system: System) -> Margins:
    """Measure them all; a system without `sensors` has no delay to raise, which is nan."""
    loop, stiffness = open_loop(system)
    delay = delay_limit(system) if "sensors" in system.components else np.nan
    return Margins(stiffness, loop, delay, gain_limit(system))


NOISY = ("dvl", "position", "depth", "attitude", "gyro", "accelerometer", "force", "moment")
# Sensors that only delay: noise would hide a decay.
QUIET = {f"sensors.{kind}_{sensor}": 0.0 for kind in ("noise", "quantum") for sensor in NOISY}


def varied(system: System, mode: int, factor: float) -> System:
    """With a mode of the controller, and a brush of `factor` times the bristles and contact stiffness.

    It stands for a stiffer brush: what the system requires of one that is built (fit on the hub, mass) is left out.
    """
    bristles = ("bristles_per_filament", "k_c")
    values = {f"brush.{name}": factor * start_of(system, "brush", name) for name in bristles}
    quiet = QUIET if "sensors" in system.components else {}
    without = replace(system, requirements=())
    return without.with_values({"controller.mode": mode, **values, **quiet}, "margins")


def table(system: str, fmus: Path | None, strategies: Mapping[str, int], brushes: Mapping[str, float]) -> Iterator[str]:
    """Lines of text: a row for each strategy and brush, which is `brushes` times the shipped one.

    A force that rises with the square of the penetration makes a brush of four times the bristles, pressed with the
    same force, twice as stiff.
    """
    head = ("along the normal: phase", "delay", "gain", "all sensors: delay", "gains")
    yield f"{'strategy':16} {'brush':14} {'N/mm':>5} {head[0]:>25} {head[1]:>8} {head[2]:>5} {head[3]:>20} {head[4]:>6}"
    for brush, factor in brushes.items():
        for label, mode in strategies.items():
            m = margins(varied(assemble(system, {}, f"{BEGIN + LENGTH:g} s", fmus), mode, factor))
            normal = f"{np.degrees(m.loop.phase_margin):21.0f} deg {1e3 * m.loop.delay_margin:5.0f} ms"
            tried = f"{1e3 * m.delay:17.0f} ms {m.gain:6.1f}"
            yield f"{label:16} {brush:14} {1e-3 * m.stiffness:5.1f} {normal} {m.loop.gain_margin:5.1f} {tried}"
