"""The cup brush's bristles against an elastica of their own: shot from the root by scipy, no arc angles or tables."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from helpers import Measured
from kernel_unit import KernelUnit, RunningKernel
from rovbrush.components.cup_brush.parameters import NOMINAL
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

L, BRISTLES = NOMINAL.L, 50 * NOMINAL.bristles_per_tuft
EI = NOMINAL.E * np.pi * NOMINAL.d**4 / 64.0
FRICTION = (0.2, 0.35, 0.5, 0.65, 0.8)
PRESSED = (0.5e-3, 1e-3, 2e-3, 3.5e-3, 5e-3, 6.5e-3, 8e-3)  # m
LIGHTLY = (5e-9, 1e-8, 1.5e-8, 3e-8, 1e-7, 1e-6, 1e-5, 5e-5, 2e-4, 4e-4)  # m


def shot(unknown: np.ndarray, mu: float) -> np.ndarray:
    """Angle, its slope, depth and side of the tip for P L^2/EI and the slope at the root, in units of L."""
    P, slope = unknown

    def rates(_: float, y: np.ndarray) -> list[float]:
        theta, curvature = y[0], y[1]
        # Cosserat: moment balance of the piece beyond, which the hull presses by P and draws aside by mu P.
        return [curvature, -P * (np.sin(theta) + mu * np.cos(theta)), np.cos(theta), np.sin(theta)]

    start = [0.0, slope, 0.0, 0.0]
    tip: np.ndarray = solve_ivp(rates, (0.0, 1.0), start, method="DOP853", rtol=1e-11, atol=1e-13).y[:, -1]
    return tip


@cache
def elastica(delta: float, mu: float) -> tuple[float, float, float]:
    """Normal force [N], tip's side displacement [m] and root moment [N.m] of a bristle pressed in by delta [m]."""

    def miss(unknown: np.ndarray) -> np.ndarray:
        tip = shot(unknown, mu)
        return np.array([tip[1], (1.0 - tip[2]) * L / delta - 1.0])

    e = delta / L
    stiff = np.sqrt(15.0 * e) / mu  # small bends; the Euler load bounds it
    P = 1.0 / (1.0 / stiff + 4.0 / np.pi**2)
    tight = {"xtol": 1e-14, "ftol": 1e-14, "gtol": 1e-14}
    found = least_squares(miss, [P, 3.9 * np.sqrt(e)], x_scale=[P, np.sqrt(e)], **tight)
    assert np.max(np.abs(found.fun)) < 1e-7, found
    P, slope = found.x
    return P * EI / L**2, float(shot(found.x, mu)[3]) * L, slope * EI / L


def pressed(delta: float, mu: float) -> RunningKernel:
    """The brush at constant friction."""
    constant = {"mu_s": mu, "mu_c": mu, "k_v": 0.0, "v_eps": 1e-4}
    running = KernelUnit("cup_brush").new({"omega_b": 15.7, "delta": delta}, **constant)
    running.step(1e-6)
    return running


def force(delta: float, mu: float) -> float:
    """Normal force [N] of one bristle."""
    return float(-pressed(delta, mu)["F_z"]) / BRISTLES


@pytest.mark.evidence
@pytest.mark.parametrize("mu", FRICTION)
def test_force_is_that_of_the_exact_elastica(mu: float, measured: Measured) -> None:
    worst = max(abs(force(delta, mu) / elastica(delta, mu)[0] - 1.0) for delta in PRESSED)
    measured(f"cup_brush: force against a shooting elastica, mu = {mu}, 0.5 to 8 mm", worst, "5e-3")
    assert worst < 5e-3


@pytest.mark.parametrize("mu", FRICTION)
def test_light_touch_is_within_half_a_percent_of_the_force_at_half_a_millimetre(mu: float, measured: Measured) -> None:
    at_half = elastica(0.5e-3, mu)[0]
    worst = max(abs(force(delta, mu) - elastica(delta, mu)[0]) for delta in LIGHTLY) / at_half
    measured(f"cup_brush: force below 0.5 mm, mu = {mu}, over that at 0.5 mm", worst, "5e-3")
    assert worst < 5e-3


@pytest.mark.parametrize("mu", FRICTION)
def test_moment_and_deflection_are_those_of_the_exact_elastica(mu: float, measured: Measured) -> None:
    worst = 0.0
    for delta in PRESSED:
        running = pressed(delta, mu)
        _, side, moment = elastica(delta, mu)
        worst = max(worst, abs(running["deflection_ratio"] * L / side - 1.0))
        worst = max(worst, abs(running["M_b_eq12"] / BRISTLES / moment - 1.0))
    measured(f"cup_brush: moment and deflection against a shooting elastica, mu = {mu}", worst, "5e-3")
    assert worst < 5e-3


def test_strain_energy_is_the_work_of_the_tip_forces(measured: Measured) -> None:
    """The shooting elastica's forces along its own path, P d(delta) + mu P d(side)."""
    mu, worst = 0.5, 0.0
    depths = np.linspace(0.02, 1.0, 80) ** 2 * 8e-3  # forces grow with the root
    rows = np.array([elastica(float(delta), mu)[:2] for delta in depths])
    P, side = rows[:, 0], rows[:, 1]
    work = np.cumsum(0.5 * (P[1:] + P[:-1]) * (np.diff(depths) + mu * np.diff(side)))
    for k in (39, 78):
        stored = (pressed(float(depths[k + 1]), mu)["E_strain"] - pressed(float(depths[0]), mu)["E_strain"]) / BRISTLES
        worst = max(worst, abs(stored / work[k] - 1.0))
    measured("cup_brush: strain energy against the work of a shooting elastica", worst, "1e-3")
    assert worst < 1e-3


def test_force_and_its_slope_are_continuous(measured: Measured) -> None:
    """Across the nodes of the table (q = 0.25 at delta = 5 mm) the slopes of both sides agree."""
    worst = 0.0
    for mu in (0.3, 0.5, np.tan(0.4)):  # the last one on a node of beta
        left, at, right = (force(5e-3 + shift, mu) for shift in (-1e-7, 0.0, 1e-7))
        worst = max(worst, abs((right - at) / (at - left) - 1.0))
    measured("cup_brush: jump of dF/ddelta at a node of the table", worst, "1e-4")
    assert worst < 1e-4  # the second derivative over 1e-7 m gives 2e-5
