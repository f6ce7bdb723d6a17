"""The brush's integrator: order, error estimate, free flight, independence of communication points."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine
from rovbrush.components.filament_brush.micro_steps import advance_touching, evaluate
from rovbrush.components.filament_brush.parameters import STEEP_RAKE
from rovbrush.components.filament_brush.records import Inputs, Placement, Scratch, State

DECLARED = component("filament_brush")
P = DECLARED.parameters()
KERNEL = machine(DECLARED.kernel)
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}


def start(inputs: dict[str, float], **parameters: Any) -> Instance:
    instance = Instance(DECLARED, KERNEL, **parameters)
    instance.set(**inputs)
    instance.start()
    return instance


def state(instance: Instance) -> np.ndarray:
    return np.concatenate([instance.arrays["eta"].ravel(), instance.arrays["eta_dot"].ravel() / 1e3])


def fixed(h: float) -> Instance:
    """A filament that stays in contact and keeps sliding for 8 ms, with micro-steps of h."""
    settings = asdict(STEEP_RAKE) | {"n": 1, "theta_b_0": -0.45, "c_c": 5.0, "h_min": h, "h_max": h, "tolerance": 1.0}
    instance = start(NOMINAL, **settings)
    for _ in range(8):
        instance.step(1e-3)
        assert instance["contact_count"] == 1.0
    return instance


def test_micro_steps_are_of_fourth_order(measured: Measured) -> None:
    steps = (5e-5, 2.5e-5, 1.25e-5)
    runs = [fixed(h) for h in steps]
    reference = fixed(1e-6)
    errors = [np.max(np.abs(state(r) - state(reference))) for r in runs]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    for k, order in enumerate(orders):
        measured(f"brush: order of the integration, micro-steps of {1e6 * steps[k]:g} us halved", order, "4 within 0.2")
    assert orders == pytest.approx(4.0, abs=0.2)
    # impulses and losses are carried by the same stages
    errors = [abs(r["W_friction"] - reference["W_friction"]) for r in runs]
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx(4.0, abs=0.2)


def error_estimate(h: float) -> float:
    """h/6 (k5 - k4), velocity part, from the stages that one micro-step of h leaves behind."""
    brush = start(NOMINAL, n=1, theta_b_0=-0.45, h_min=h, h_max=h, tolerance=1.0)
    p, x, s = brush.parameters, brush.record(State), brush.record(Scratch)
    u = Inputs(15.7, 5e-3, 0.0, 0.05, 1.0, 0.0)
    psi = -0.45 - p.alpha
    at = Placement(np.sin(psi), np.cos(psi), p.R_brush - u.delta)
    reach = evaluate(True, s.now, at, u, p, s)
    advance_touching(at, h, h, reach.rate, u, p, x, s)
    return float(np.max(np.abs(h / 6.0 * (s.end.a[:3] - s.fourth.a[:3]))))


def test_error_estimate_belongs_to_a_third_order_companion() -> None:
    # The local error of a method of third order goes with h^4.
    assert np.log2(error_estimate(5e-6) / error_estimate(2.5e-6)) == pytest.approx(4.0, abs=0.2)


def test_free_flight_is_the_damped_oscillation() -> None:
    # Three uncoupled modes without rotation; the map's relative error is 2e-5 per radian at most (omega h = 0.2).
    instance = start({"delta": -0.1}, n=1)
    eta, omega_r, zeta = np.array([2e-3, 2e-4, 5e-5]), instance["omega_r"][:3], np.array(P.zeta[:3])
    instance.arrays["eta"][0] = eta
    for _ in range(10):
        instance.step(1e-3)
    t = 0.01
    damped = omega_r * np.sqrt(1.0 - zeta**2)
    expected = eta * np.exp(-zeta * omega_r * t) * (np.cos(damped * t) + zeta * omega_r / damped * np.sin(damped * t))
    assert np.max(np.abs(instance.arrays["eta"][0] - expected) / eta) < 1e-3


def history(h: float, inputs: dict[str, float], duration: float, every: float, **parameters: Any) -> np.ndarray:
    instance = start(inputs, **parameters)
    rows = []
    for k in range(1, round(duration / h) + 1):
        instance.set(delta=inputs["delta"] + inputs.get("delta_dot", 0.0) * (k - 1) * h)
        instance.step(h)
        if round(k * h / every) * every == pytest.approx(k * h, abs=1e-9):
            rows.append([instance["F_x"], instance["F_z"], instance["T_brush"]])
    return np.array(rows)


@pytest.mark.parametrize(("delta_dot", "bound"), [(0.0, 5e-5), (0.02, 1e-3)])  # 0.02 m/s goes 9 mm deep, tips stick
def test_forces_do_not_depend_on_where_communication_points_fall(delta_dot: float, bound: float) -> None:
    inputs = NOMINAL | {"delta_dot": delta_dot}
    reference = history(1e-4, inputs, 0.2, 5e-3, tolerance=1e-9, h_min=1e-6)
    for h in (1e-4, 5e-4, 1e-3, 2.5e-3):
        difference = np.abs(history(h, inputs, 0.2, 5e-3) - reference)
        # at the default tolerance, in units of the mean force
        assert np.max(difference / np.abs(np.mean(reference, axis=0))) < bound
