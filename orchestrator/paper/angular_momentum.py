"""The angular momentum of vehicle and brush about the world's origin: what it is, and what has changed it.

The vehicle counts its own and the impulses on it; the motor counts the spin and the impulse of the brush torque. Left
is the contact of the brush, of which the vehicle is told as a wrench in its own axes: its impulse is that over each
step of the vehicle, in axes half-way between those at both ends, which is of second order in the step.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import log2

import numpy as np

from ..plan.plan import make_plan
from ..results.signals import Signals
from ..results.tables import Run, require_complete
from ..run.simulation import simulate
from .lab import Lab

AXES = "xyz"
FREE: Mapping[str, object] = {  # no water and no weight: nothing but the tool acts on the vehicle
    **{f"vehicle.{name}": [0.0] * 3 for name in ("D_force", "D_moment", "D_force_quadratic", "D_moment_quadratic")},
    "vehicle.W": 0.0,
    "vehicle.net_buoyancy": 0.0,
}
TUMBLING: Mapping[str, object] = {
    "vehicle.attitude_start": [0.4, -0.7, 2.0],
    "vehicle.velocity_start": [0.5, -0.3, 0.2],
    "vehicle.rates_start": [0.6, -0.4, 0.9],
}


@dataclass(frozen=True)
class Balance:
    """Angular momenta [N.m.s] at the instants of the vehicle, world axes, (rows, 3)."""

    time: np.ndarray
    vehicle: np.ndarray  # about the world's origin, without the spin
    spin: np.ndarray
    other: np.ndarray  # impulse so far of thrusters, water, weight and further wrenches
    contact: np.ndarray  # and of the hull on the brush

    @property
    def residual(self) -> np.ndarray:
        """What is not accounted for so far, (rows, 3)."""
        left = self.vehicle + self.spin - self.other - self.contact
        return np.asarray(left - left[0])

    @property
    def largest(self) -> float:
        """The largest of all that is balanced."""
        return max(float(np.max(np.abs(part))) for part in (self.vehicle, self.spin, self.other, self.contact))

    def relative(self, axes: str = AXES) -> float:
        """The largest residual about some axes, over the largest of all."""
        return float(np.max(np.abs(self.residual[:, [AXES.index(axis) for axis in axes]]))) / self.largest


def balance(run: Run) -> Balance:
    """The balance of a run of motor, brush and vehicle; the tool's mounting and place are the vehicle's parameters."""
    signals = Signals(run)
    start = run.plan.system.components["vehicle"]
    time = signals["vehicle.L[1]"].time

    def vector(name: str, count: int = 3) -> np.ndarray:
        return np.array([signals[f"{name}[{k}]"].values for k in range(1, count + 1)]).T

    def parameter(name: str, count: int) -> np.ndarray:
        names = start.fmu.expand(name)
        found = [start.parameters.get(k, start.fmu.variables[k].start) for k in names]
        return np.array([float(str(value)) for value in found[:count]])

    def sampled(name: str) -> np.ndarray:
        return np.asarray(np.interp(time, signals[name].time, signals[name].values))

    mounting, arm = parameter("R_tool_body", 9).reshape(3, 3), parameter("r_tool", 3)
    R = rotations(vector("vehicle.quat", 4))
    tool = R @ mounting
    place = np.array([signals[f"vehicle.{name}"].values for name in ("x_n", "y_n", "z_n")]).T + R @ arm
    H, J = sampled("motor.H_spin"), sampled("motor.J_housing")
    h = np.diff(time)
    # What was held over each step stands in the row of its end; the brush torque is what the motor counted of it.
    force = np.array([_held(signals, f"vehicle.F_{axis}", len(time)) for axis in AXES]).T[1:]
    torque = np.diff(J + H) / h
    both_ends = [
        np.cross(place[rows], np.einsum("nij,nj->ni", tool[rows], force)) + tool[rows, :, 1] * torque[:, None]
        for rows in (slice(None, -1), slice(1, None))
    ]
    contact = np.cumsum(0.5 * h[:, None] * (both_ends[0] + both_ends[1]), axis=0)
    return Balance(
        time, vector("vehicle.L"), tool[:, :, 1] * H[:, None], vector("vehicle.J_other"),
        np.concatenate([np.zeros((1, 3)), contact]),
    )  # fmt: skip


def _held(signals: Signals, name: str, rows: int) -> np.ndarray:
    """An input of the vehicle; zero where nothing drives it."""
    return np.asarray(signals[name].values) if name in signals.places else np.zeros(rows)


def rotations(quat: np.ndarray) -> np.ndarray:
    """Body to world, (rows, 3, 3), of quaternions (rows, 4), scalar first."""
    a, b, c, d = quat.T
    rows = [
        [1 - 2 * (c * c + d * d), 2 * (b * c - d * a), 2 * (b * d + c * a)],
        [2 * (b * c + d * a), 1 - 2 * (b * b + d * d), 2 * (c * d - b * a)],
        [2 * (b * d - c * a), 2 * (c * d + b * a), 1 - 2 * (b * b + c * c)],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def with_periods(lab: Lab, values: Mapping[str, object], factor: Fraction) -> Balance:
    """The start in open water with all periods multiplied."""
    system = lab.case("open_water", values).run.plan.system
    return balance(require_complete(simulate(make_plan(system.with_periods(factor)))))


def order(lab: Lab) -> float:
    """By which power of the periods the residual of a tumbling vehicle falls, from twice as long to half as long."""
    coarse, fine = (with_periods(lab, {**FREE, **TUMBLING}, factor) for factor in (Fraction(2), Fraction(1, 2)))
    return log2(coarse.relative() / fine.relative()) / 2.0


def closing(lab: Lab) -> list[tuple[str, str, str]]:
    """What the report shows: which balance, its residual over the largest momentum or impulse, and the bound."""
    started = "brush started in open water"
    free, tumbling = (balance(lab.case("open_water", values).run) for values in (FREE, {**FREE, **TUMBLING}))
    rows = [
        (f"{started} on a free body, about the brush axis", free.relative("y"), "1e-9"),
        ("the same on a body that tumbles, three axes", tumbling.relative(), "1e-5"),
        (f"{started}, with water and weight, three axes", balance(lab.case("open_water").run).relative(), "1e-5"),
        ("let go on the hull, three axes", balance(lab.case("no_thrust").run).relative(), "1e-5"),
        ("a pass on the hull, three axes", balance(lab.case("hull_pass_paper").run).relative(), "1e-5"),
    ]
    found = [(name, f"{value:.2g}", bound) for name, value, bound in rows]
    return [*found, ("order in the periods, on the body that tumbles", f"{order(lab):.2f}", "2 +- 0.25")]
