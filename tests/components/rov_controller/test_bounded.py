"""The bounded least squares of the allocation against scipy's, over thousands of wrenches."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine
from scipy.optimize import lsq_linear

DECLARED = component("rov_controller")
WRENCHES = 3000
REGULAR = 1e-6  # weight of the thrusts themselves, which makes the minimum unique


def asked_and_given(tau: np.ndarray, **parameters: Any) -> tuple[np.ndarray, Instance]:
    """The thrusts for a wrench that is fed forward."""
    seen = Instance(DECLARED, machine(DECLARED.kernel), mode=1, T_filter=0.0, **parameters)
    seen.set(F_tool=-tau[:3], M_tool=-tau[3:])
    seen.start()
    seen.step(0.02)
    return seen.arrays["F"].copy(), seen


def wrenches(seed: int, largest_force: float, largest_moment: float) -> np.ndarray:
    """Forces and moments of any direction, up to these magnitudes."""
    rng = np.random.default_rng(seed)
    drawn = rng.normal(size=(WRENCHES, 2, 3))
    drawn *= rng.uniform(size=(WRENCHES, 2, 1)) / np.linalg.norm(drawn, axis=2, keepdims=True)
    return np.concatenate([largest_force * drawn[:, 0], largest_moment * drawn[:, 1]], axis=1)


@pytest.mark.parametrize(("weight_moment", "weight_direction"), [(100.0, 30.0), (1.0, 1.0)])
def test_thrusts_are_those_of_scipy(weight_moment: float, weight_direction: float, measured: Measured) -> None:
    weights = {"weight_moment": weight_moment, "weight_direction": weight_direction}
    worst, saturated = 0.0, 0
    for tau in wrenches(1, 320.0, 25.0):
        F, seen = asked_and_given(tau, bounded_least_squares=True, **weights)
        high, low = seen.values["k_T_forward"], -seen.values["k_T_reverse"]
        assert np.all(low <= F) and np.all(high >= F)
        B = seen.arrays["B"]
        if np.any(np.abs(seen.arrays["B_pinv"] @ tau - np.clip(seen.arrays["B_pinv"] @ tau, low, high)) > 0.0):
            saturated += 1
            along = tau[:3] / np.linalg.norm(tau[:3])
            W = np.zeros((6, 6))
            W[:3, :3] = weight_direction * np.eye(3) + (1.0 - weight_direction) * np.outer(along, along)
            W[3:, 3:] = weight_moment * np.eye(3)
            A = np.vstack([W @ B, np.sqrt(REGULAR) * np.eye(8)])
            best = lsq_linear(A, np.r_[W @ tau, np.zeros(8)], (low, high), method="bvls", tol=1e-14, max_iter=200)
            worst = max(worst, float(np.max(np.abs(B @ (F - best.x)))))
            assert np.max(np.abs(F - best.x)) < 1e-3
        else:
            np.testing.assert_allclose(B @ F, tau, rtol=0.0, atol=1e-11)
    measured(f"bounded least squares: wrench against scipy's, weights {weight_moment:g} and {weight_direction:g} [N]",
             worst, "1e-6")  # fmt: skip
    assert saturated > WRENCHES // 3 and worst < 1e-6


def test_force_keeps_its_direction_and_the_moment_comes_first(measured: Measured) -> None:
    """Where moments are those of a pass, up to 6 N m."""
    angles: dict[bool, list[float]] = {False: [], True: []}
    missed = 0.0
    for tau in wrenches(2, 250.0, 6.0)[:1000]:
        for bounded, found in angles.items():
            F, seen = asked_and_given(tau, bounded_least_squares=bounded)
            if seen["saturated"]:
                had = seen.arrays["B"] @ F
                cosine = had[:3] @ tau[:3] / np.linalg.norm(had[:3]) / np.linalg.norm(tau[:3])
                found.append(float(np.degrees(np.arccos(min(1.0, cosine)))))
                missed = max(missed, float(np.max(np.abs(had[3:] - tau[3:])))) if bounded else missed
    measured("allocation: mean angle by which saturation bends the force, one part after the other [deg]",
             float(np.mean(angles[False])), "> 10")  # fmt: skip
    measured("allocation: largest angle with bounded least squares [deg]", max(angles[True]), "0.2")
    measured("allocation: largest moment missed with bounded least squares [N m]", missed, "0.2")
    assert np.mean(angles[False]) > 10.0
    assert max(angles[True]) < 0.2 and missed < 0.2
