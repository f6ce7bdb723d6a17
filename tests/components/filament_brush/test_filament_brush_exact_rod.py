"""The brush's filament against exact rods of their own: at rest by collocation, moving by Lagrange's equations.

Set of the paper: 18000 bristles a bundle, raked forward by 0.3 rad. The table that pytest prints at its end shows where
three foreshortened bending modes stop being a rod.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import dynamic_rod
import exact_rod
import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine

DECLARED = component("filament_brush")
KERNEL = machine(DECLARED.kernel)
P = DECLARED.parameters()
FORCES = ("F_x", "F_z", "T_brush")
IMPULSES = ("J_x", "J_z", "J_T")

# Friction of one value, so that the speed does not matter; mu is that of Eq. 9 at 15.7 rad/s.
RESTING = exact_rod.Brush(
    P.L, P.d, P.E, P.bristles_per_filament, P.R_brush, P.alpha, k_c=P.k_c, mu=0.5, delta=5e-3
)  # fmt: skip
SLOWLY = 0.05  # rad/s; half of it changes the mean force by 1e-5 of itself
RANGE = (3e-3, 4e-3, 5e-3, 6e-3, 6.5e-3, 7e-3, 7.3e-3, 8e-3, 9e-3, 10e-3, 12e-3)  # m; |y|/L from 0.03 to 0.36
MOVING = dynamic_rod.Rod(
    P.L, P.d, P.E, P.rho, P.bristles_per_filament, P.R_brush, P.alpha, P.zeta[0], P.k_c, P.mu_s, P.mu_c, P.v_0, P.k_v,
    P.v_eps, delta=5e-3, omega_b=15.7, v_rov=0.05,
)  # fmt: skip


@cache
def arc(delta: float) -> list[exact_rod.Pressed]:
    """The rod at rest in every position between touching the hull and leaving it."""
    return exact_rod.sweep(replace(RESTING, delta=delta))


def arc_means(delta: float) -> np.ndarray:
    """F_x, F_z and the moment on the brush, averaged over the arc."""
    found = arc(delta)
    phi, F_n = np.array([r.phi for r in found]), np.array([r.F_n for r in found])
    x, z = np.array([r.tip for r in found]).T
    over = [np.trapezoid(values, phi) for values in (-RESTING.mu * F_n, -F_n, F_n * (x - RESTING.mu * z))]
    return np.array(over) / (phi[-1] - phi[0])


def bending(delta: float) -> float:
    """The largest |y(L)|/L of the rod."""
    return max(abs(r.side) for r in arc(delta))


@cache
def kernel_arc_means(delta: float) -> np.ndarray:
    """The same of the brush's kernel with one filament, turned slowly over the arc."""
    phi = [r.phi for r in arc(delta)]
    constant = {"mu_s": RESTING.mu, "mu_c": RESTING.mu, "k_v": 0.0, "v_eps": 1e-4, "centrifugal": False}
    brush = Instance(DECLARED, KERNEL, n=1, theta_b_0=phi[0] - 0.01, **constant)
    brush.set(omega_b=SLOWLY, delta=delta)
    brush.start()
    turn = phi[-1] - phi[0]
    for _ in range(2000):
        brush.step((turn + 0.02) / SLOWLY / 2000)
    assert brush["F_z"] == 0.0, "has left the hull"
    return np.array([brush[name] for name in IMPULSES]) * SLOWLY / turn


def errors(delta: float) -> np.ndarray:
    """Of the kernel's means, relative."""
    return np.asarray(kernel_arc_means(delta) / arc_means(delta) - 1.0)


def test_the_resting_rod_spends_the_work_of_its_hub_on_friction() -> None:
    # Unbent where the arc begins and where it ends: by virtual work only an equilibrium has this balance.
    found = arc(8e-3)
    phi, F_n = np.array([r.phi for r in found]), np.array([r.F_n for r in found])
    x, z = np.array([r.tip for r in found]).T
    work = -np.trapezoid(F_n * (x - RESTING.mu * z), phi)
    assert work == pytest.approx(RESTING.mu * np.trapezoid(F_n, x), rel=1e-5)
    assert np.all(np.diff(x) > 0.05 * np.diff(phi) * RESTING.L)  # tips never stand still: friction has one direction


@pytest.mark.evidence
def test_mean_force_over_the_arc_is_that_of_the_resting_rod(measured: Measured) -> None:
    for delta in RANGE:
        F_x, F_z, T = 100.0 * errors(delta)
        seen = f"F_z {F_z:+.3f} %, F_x {F_x:+.3f} %, T {T:+.3f} %"
        measured(f"resting rod: kernel at {1e3 * delta:g} mm, |y|/L = {bending(delta):.3f}", seen, "table")
    assert abs(errors(5e-3)[1]) < 4e-4
    # Between, the error passes a maximum: bending too soft and foreshortening too small act against each other.
    assert all(abs(errors(delta)[1]) < 8e-4 for delta in RANGE if bending(delta) <= 0.17)
    assert all(abs(errors(delta)[2]) < 3.5e-3 for delta in RANGE if bending(delta) <= 0.17)


def test_mean_force_leaves_the_resting_rod_beyond_a_quarter_of_the_length() -> None:
    beyond = [delta for delta in RANGE if bending(delta) > 0.17]
    found = [abs(errors(delta)[1]) for delta in beyond]
    assert found == sorted(found) and [bending(delta) > 0.25 for delta in beyond] == [e > 4e-3 for e in found]


@cache
def moving_means(delta: float, terms: int = 5) -> np.ndarray:
    """F_x, F_z and the moment on a brush of rods over a turn, after 13 of settling."""
    return P.n * dynamic_rod.means(replace(MOVING, delta=delta), terms, 8000, 14)


def kernel_means(delta: float) -> np.ndarray:
    """The same of the brush's kernel; filaments are alike, so that one is enough."""
    brush = Instance(DECLARED, KERNEL, n=1, theta_b_0=0.5 * np.pi)
    brush.set(omega_b=MOVING.omega_b, delta=delta, v_rov=MOVING.v_rov)
    brush.start()
    h = 2.0 * np.pi / MOVING.omega_b / 400
    for _ in range(13 * 400):
        brush.step(h)
    before = np.array([brush[name] for name in IMPULSES])
    for _ in range(400):
        brush.step(h)
    return np.asarray(P.n * (np.array([brush[name] for name in IMPULSES]) - before) / (400 * h))


def test_moving_rod_has_the_frequencies_of_a_cantilever() -> None:
    omega = dynamic_rod.Matrices(MOVING, 5).omega[:3]
    assert omega == pytest.approx((162.71, 1019.7, 2855.2), rel=0.03) and omega[0] == pytest.approx(162.71, rel=1e-4)


@pytest.mark.evidence
def test_moving_rod_has_enough_terms(measured: Measured) -> None:
    change = float(np.max(np.abs(moving_means(5e-3, 6) / moving_means(5e-3) - 1.0)))
    measured("moving rod: a sixth polynomial changes the means by", change, "1e-5")
    assert change < 1e-5


def difference(delta: float, measured: Measured) -> float:
    """The largest of the kernel's means to those of the moving rod, relative, told."""
    error = kernel_means(delta) / moving_means(delta) - 1.0
    seen = ", ".join(f"{name} {100 * e:+.2f} %" for name, e in zip(FORCES, error, strict=True))
    measured(f"moving rod: kernel at {1e3 * delta:g} mm, 15.7 rad/s", seen, "4e-3 at 5 mm")
    return float(np.max(np.abs(error)))


def test_mean_forces_and_torque_of_the_paper_s_case_are_those_of_the_moving_rod(measured: Measured) -> None:
    assert difference(5e-3, measured) < 4e-3


@pytest.mark.evidence
def test_mean_forces_and_torque_are_told_at_other_penetrations(measured: Measured) -> None:
    for delta in (3e-3, 4e-3, 6e-3):
        assert np.isfinite(difference(delta, measured))
