"""What a brush motor does to the vehicle that holds it: reaction of its housing and spin momentum, by Newton."""

from __future__ import annotations

import numpy as np

from ..testing.behaviour import Unit, close, holds, read, run, values, where_known
from .behaviour_energy import H, plain, ratio, settled


def test_spin_momentum_is_that_of_brush_and_rotor(unit: Unit) -> None:
    """H_spin = J_b omega_b + s J_m omega_m, with the sense s of the rotor against the brush."""
    J_b, J_m = values(unit, "J_b", "J_m")
    for sense in (1, 0, -1) if unit.supports("rotor_sense") else (1,):
        seen = run(unit, 0.05, H, {"V_in": 12.0, "T_brush": -5.0}, **where_known(unit, rotor_sense=sense))
        expected = (J_b + sense * J_m * ratio(unit)) * seen["omega_b"]
        close(unit, "spin momentum", seen["H_spin"], expected, 1e-13)


def test_housing_gets_what_the_spin_does_not_take(unit: Unit) -> None:
    """J_housing rises by the impulse of the brush torque less what H_spin rises by, whatever the losses."""
    for parameters in ({}, {"gear_efficiency": 0.7, "current_limit": 60.0}):
        seen, given = unit.new({"V_in": 12.0, "T_brush": 0.0}, **plain(unit, **parameters)), 0.0
        start = read(seen, "J_housing", "H_spin")
        for k in range(200):
            T_brush = -8.0 + 6.0 * np.sin(0.9 * k)
            seen.set(T_brush=T_brush)
            seen.step(H)
            given += T_brush * H
            J, spin = read(seen, "J_housing", "H_spin") - start
            close(unit, "impulse of housing and spin", J + spin, given, 1e-12, 1.0)  # rounding of 200 sums
        holds(spin > 1.0, f"a spin momentum of {spin:.3g} N.m.s only was to be built up")


def test_free_start_pushes_the_housing_back(unit: Unit) -> None:
    """Without a load, what the brush gains in spin momentum the housing gets the other way round."""
    seen = unit.new({"V_in": 12.0, "T_brush": 0.0}, **plain(unit))
    before = read(seen, "J_housing", "H_spin")
    seen.step(0.5)
    J, spin = read(seen, "J_housing", "H_spin") - before
    holds(J < 0.0 < spin, f"J_housing {J:.3g} and H_spin {spin:.3g} N.m.s, expected opposite signs")
    close(unit, "impulse of the housing", J, -spin, 1e-12)


def test_housing_holds_the_brush_torque_at_constant_speed(unit: Unit) -> None:
    """In the steady state T_housing = T_brush: the case that the paper assumes always."""
    close(unit, "torque of the housing", settled(unit, 12.0, -16.63)["T_housing"], -16.63, 1e-9)


def test_impulse_of_the_housing_is_the_integral_of_its_torque(unit: Unit) -> None:
    """J_housing grows at the rate T_housing."""
    h = 1e-4
    seen = run(unit, 0.02, h, {"V_in": 12.0, "T_brush": -10.0})
    torque, before = [seen["T_housing"]], seen["J_housing"]
    for _ in range(400):
        seen.step(h)
        torque.append(seen["T_housing"])
    # The trapezoidal rule over the rise of the current, time constant 0.6 ms: h^2/12 of its curvature.
    grown = h * (np.sum(torque) - 0.5 * (torque[0] + torque[-1]))
    close(unit, "impulse of the housing", seen["J_housing"] - before, grown, 1e-4)


def test_impulse_does_not_depend_on_the_communication_step(unit: Unit) -> None:
    """1 ms and 5 ms count the same impulse."""
    fine, coarse = (run(unit, 0.1, h, {"V_in": 12.0, "T_brush": -5.0})["J_housing"] for h in (1e-3, 5e-3))
    close(unit, "impulse of the housing", coarse, fine, 1e-9)
