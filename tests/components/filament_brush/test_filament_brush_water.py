"""Drag along the bristles: its size, the damping it gives, its forces and its books."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine
from scipy.integrate import solve_ivp

DECLARED = component("filament_brush")
KERNEL = machine(DECLARED.kernel)
LAMBDA = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613])
L, D_BRISTLE, RHO, RHO_W, E = 0.08, 0.8e-3, 1140.0, 1025.0, 2.5e9
AREA = 0.25 * np.pi * D_BRISTLE**2
KAPPA = 0.5 * RHO_W * D_BRISTLE / (RHO * AREA)  # of C_d = 1, per mass of the bristle [1/m]
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
WET = {"C_d": 1.1, "shielding": 0.2, "co_rotation": 0.91, "C_a": 1.0, "bristles_per_filament": 1900.0, "k_c": 19337.0}
FORCES = ("F_x", "F_z", "T_brush")


def start(inputs: dict[str, float], **parameters: Any) -> Instance:
    instance = Instance(DECLARED, KERNEL, **parameters)
    instance.set(**inputs)
    instance.start()
    return instance


def alone(inputs: dict[str, float], **parameters: Any) -> Instance:
    """One bristle off the hull, straight across the hull's motion, in water that does not turn with it."""
    one = {"n": 1, "bristles_per_filament": 1.0, "alpha": 0.0, "C_d": 1.0, "co_rotation": 0.0, "centrifugal": False}
    return start({"delta": -0.1} | inputs, **one | parameters)


def shape(xi: np.ndarray) -> np.ndarray:
    """Y_r of three modes at x/L, (k, 3)."""
    sigma = (np.sinh(LAMBDA) - np.sin(LAMBDA)) / (np.cosh(LAMBDA) + np.cos(LAMBDA))
    z = LAMBDA * xi[:, None]
    return np.cosh(z) - np.cos(z) - sigma * (np.sinh(z) - np.sin(z))


def test_a_bristle_at_rest_in_a_stream_feels_the_drag_of_a_cylinder(measured: Measured) -> None:
    seen = alone({"v_rov": 2.0})
    assert seen["F_x"] == pytest.approx(0.5 * RHO_W * D_BRISTLE * L * 4.0, rel=1e-12)
    assert seen["F_z"] == pytest.approx(0.0, abs=1e-12) and seen["T_water"] > 0.0  # as the hull that passes
    measured(
        "water: drag of a bristle of Table 2 at 2 m/s over C_d", seen["F_x"], "0.111 N of model.md 9.4 is C_d = 0.85"
    )


def test_a_turning_bristle_feels_the_drag_of_its_own_speed(measured: Measured) -> None:
    seen = alone({"omega_b": 15.7})
    x = np.linspace(0.07, 0.15, 20001)
    assert seen["T_water"] == pytest.approx(-0.5 * RHO_W * D_BRISTLE * 15.7**2 * np.trapezoid(x**3, x), rel=1e-8)
    assert seen["T_brush"] == seen["T_water"] and seen["P_hub"] == pytest.approx(seen["P_water"], rel=1e-12)
    followed = alone({"omega_b": 15.7}, co_rotation=1.0)
    assert followed["T_water"] == 0.0


def test_drag_damps_as_its_slope_says(measured: Measured) -> None:
    """Small vibration in a stream V: 2 V y' of the square, zeta = rho_w C_d d V/(2 m omega_1); a mean is half of it."""
    V, R = 0.1, 2.0  # so far out that the speed is nearly the same along the bristle
    seen = alone({"omega_b": V / (R - 0.5 * L)}, R_brush=R, N_m=1, zeta=(0.0,) * 6)
    omega = float(seen["omega_r"][0])
    for _ in range(400):  # comes to rest in the stream
        seen.step(1e-3)
    rest = float(seen.arrays["eta"][0, 0])
    seen.arrays["eta"][0, 0] = rest + 1e-6
    seen.arrays["eta_dot"][0, 0] = 0.0
    seen.step(2e-3)
    way = (float(seen.arrays["eta"][0, 0]) - rest) / 1e-6
    zeta = KAPPA * V / omega
    damped = omega * np.sqrt(1.0 - zeta**2)
    expected = np.exp(-zeta * omega * 2e-3) * (np.cos(damped * 2e-3) + zeta * omega / damped * np.sin(damped * 2e-3))
    assert way == pytest.approx(expected, abs=2e-3)  # the speed varies by 1 % along the bristle
    measured("water: equivalent zeta at 0.1 m/s over C_d, by the slope of the drag", zeta, "0.44")
    measured("water: the same by the drag itself over the speed", 0.5 * zeta, "0.22, model.md 9.4")
    assert 0.5 * zeta == pytest.approx(0.22, abs=0.002)


class Bristle:
    """The equations of one bristle of three modes in water, written anew: 40 points along it, DOP853."""

    def __init__(self, omega_b: float, C_d: float, slip: float, linear: bool) -> None:
        nodes, weights = np.polynomial.legendre.leggauss(40)
        self.xi, self.w = 0.5 + 0.5 * nodes, 0.5 * weights
        self.Y = shape(self.xi)
        self.sweep = slip * omega_b * (0.07 + L * self.xi)
        self.kappa, self.linear = KAPPA * C_d, linear
        self.omega = (LAMBDA / L) ** 2 * np.sqrt(E * D_BRISTLE**2 / 16.0 / RHO)

    def rates(self, _t: float, z: np.ndarray) -> np.ndarray:
        own = self.Y @ z[3:]
        v = own - self.sweep
        square = np.abs(self.sweep) * (2.0 * own - self.sweep) if self.linear else np.abs(v) * v
        drag = -self.kappa * (self.w * square) @ self.Y
        return np.concatenate([z[3:], drag - 0.04 * self.omega * z[3:] - self.omega**2 * z[:3]])

    @property
    def rest(self) -> np.ndarray:
        """The deflections at rest in the flow."""
        result: np.ndarray = self.kappa * (self.w * np.abs(self.sweep) * self.sweep) @ self.Y / self.omega**2
        return result

    def after(self, t: float, eta: np.ndarray) -> np.ndarray:
        begin = np.concatenate([eta, np.zeros(3)])
        made = solve_ivp(self.rates, (0.0, t), begin, method="DOP853", rtol=1e-11, atol=1e-15)
        result: np.ndarray = made.y[:3, -1]
        return result


def released(own: float, linear_below: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A bristle let go so that its tip swings at `own` m/s, after 10 ms: the kernel's eta, the full and the linear."""
    eta = Bristle(15.7, 1.1, 0.09, False).rest + np.array([own / 2.0 / 163.0, 0.0, 0.0])
    seen = alone({"omega_b": 15.7}, C_d=1.1, co_rotation=0.91, linear_below=linear_below, tolerance=1e-9, h_min=1e-6)
    seen.arrays["eta"][0] = eta
    for _ in range(10):
        seen.step(1e-3)
    found = seen.arrays["eta"][0].copy()
    full, linear = (Bristle(15.7, 1.1, 0.09, linear).after(0.01, eta) for linear in (False, True))
    return found, full, linear


def test_drag_in_micro_steps_is_the_full_equation_and_off_the_hull_the_linear_one(measured: Measured) -> None:
    for own in (0.02, 1.0):
        full_seen, full, linear = released(own, 0.0)
        linear_seen, _, _ = released(own, 1e9)
        scale = own / 2.0 / 163.0
        # six points instead of forty where the drag changes its sign along the bristle
        assert np.max(np.abs(full_seen - full)) / scale < 2e-3
        assert np.max(np.abs(linear_seen - linear)) / scale < 2e-5
        apart = float(np.max(np.abs(linear_seen - full_seen)) / scale)
        measured(
            f"water: linear against full drag after 10 ms, tip at {own:g} m/s in a flow of 0.21 m/s", apart, "told"
        )
        assert (apart < 2e-2) if own < 0.1 else (apart > 5e-2)


@pytest.mark.parametrize("own", [0.02, 1.0])
def test_by_default_drag_off_the_hull_is_linear_only_where_that_is_right(own: float) -> None:
    found, full, linear = released(own, DECLARED.parameters().linear_below)
    assert np.max(np.abs(found - full)) < 1e-2 * own / 2.0 / 163.0
    if own > 0.1:
        assert np.max(np.abs(found - full)) < 0.1 * np.max(np.abs(linear - full))


@pytest.mark.parametrize("linear_below", [0.0, 0.5, 1e9])
def test_energy_closes_and_impulses_are_sums_of_forces_in_water(linear_below: float) -> None:
    h = 1e-4
    seen = start(NOMINAL | {"delta_dot": 0.002}, **WET, linear_below=linear_below, pack_drag=1.0)
    samples = []
    for k in range(2001):
        if k == 1000:
            before = np.array([seen[name] for name in ("J_x", "J_z", "J_T", "W_water")])
        if k >= 1000:
            samples.append([seen[name] for name in (*FORCES, "P_water")])
        seen.set(delta=5e-3 + 0.002 * k * h)
        seen.step(h)
    rows = np.array(samples)
    seen_sum = np.array([seen[name] for name in ("J_x", "J_z", "J_T", "W_water")]) - before
    sums = h * (np.sum(rows, axis=0) - 0.5 * (rows[0] + rows[-1]))
    # forces have kinks where bristles touch, and a jump where drag becomes linear; one more step ran than was sampled
    assert seen_sum - h * rows[-1] == pytest.approx(sums, rel=2e-3)
    assert seen["energy_residual"] == pytest.approx(0.0, abs=1e-4 * seen["W_friction"])
    lost = [seen[name] for name in ("W_damping", "W_friction", "W_water")]
    assert min(lost) > 0.0


def test_a_mirror_image_in_water_has_mirrored_forces() -> None:
    right, left = (
        start({"omega_b": s * 12.0, "delta": 5e-3, "v_rov": s * 0.3, "delta_dot": 0.01}, **WET, C_paddle=1.0,
              pack_drag=1.0, n=6, alpha=s * -0.3, theta_b_0=s * 0.1)
        for s in (1.0, -1.0)
    )  # fmt: skip
    for _ in range(50):
        right.step(1e-3)
        left.step(1e-3)
        expected = np.array([right[name] for name in FORCES]) * (-1.0, 1.0, -1.0)
        assert np.array([left[name] for name in FORCES]) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_base_shear_carries_the_drag() -> None:
    """At rest in a stream, the base of a stiff bristle carries what pushes it (Eqs. 11, 12)."""
    seen = alone({"v_rov": 0.2}, zeta=(0.9,) * 6, linear_below=0.0)
    for _ in range(200):
        seen.step(1e-3)
    assert abs(seen["F_y_eq11"]) == pytest.approx(seen["F_x"], rel=1e-4)  # the tolerance of the micro-steps
    assert abs(seen["M_b_eq12"]) == pytest.approx(seen["F_x"] * 0.5 * L, rel=1e-4)


def test_forces_in_water_depend_little_on_where_communication_points_fall(measured: Measured) -> None:
    """Where drag becomes linear is seen at communication points only."""
    means = []
    for h in (2.5e-4, 5e-4, 1e-3):
        seen = start(NOMINAL, **WET)
        for _ in range(round(0.8 / h)):
            seen.step(h)
        before = np.array([seen[name] for name in ("J_x", "J_z", "J_T")])
        for _ in range(round(0.4 / h)):
            seen.step(h)
        means.append(np.array([seen[name] for name in ("J_x", "J_z", "J_T")]) - before)
    worst = max(float(np.max(np.abs(m / means[0] - 1.0))) for m in means[1:])
    measured("water: mean forces with 0.5 and 1 ms beside 0.25 ms", worst, "2e-3")
    assert worst < 2e-3
