"""Filaments in free flight sleep until they come near: what the brush does is as if each took every step."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from kernel_unit import RunningKernel
from lives import component
from machine_life import machine

DECLARED = component("filament_brush")
SEEN = (
    "F_x", "F_z", "T_brush", "M_x", "M_z", "F_y_eq11", "M_b_eq12", "T_brush_eq15", "P_damping", "E_kinetic", "E_strain",
    "E_centrifugal", "E_contact", "W_hub", "W_hull", "W_damping", "W_friction", "J_x", "J_z", "J_T", "kinetic_fraction",
)  # fmt: skip
# With a drag below rounding nobody sleeps: each filament is moved in each step, by the map of that step.
AWAKE = {"C_d": 1e-30, "linear_below": 1e9}
FINE = {"tolerance": 1e-11, "h_min": 1e-7}  # far below what is compared


def brush(**parameters: Any) -> RunningKernel:
    running = RunningKernel(DECLARED, machine(DECLARED.kernel), **parameters)
    running.start()
    return running


def story(seed: int, steps: int) -> list[dict[str, float]]:
    """Speeds that change and turn round, a hull that comes, goes and jumps, steps of all lengths."""
    random = np.random.default_rng(seed)
    found = []
    omega_b, delta, delta_dot, h = 12.0, 2e-3, 0.0, 5e-4
    for k in range(steps):
        omega_b += random.normal() * 0.05
        if k % 60 == 59:
            omega_b = -omega_b
        if k % 25 == 24:
            delta, delta_dot = random.uniform(-4e-3, 4e-3), random.uniform(-0.05, 0.05)
        if k % 40 == 39:
            h = random.choice([2e-4, 5e-4, 1e-3, 2e-3])
        found.append({"omega_b": omega_b, "delta": delta, "delta_dot": delta_dot, "v_rov": 0.05, "h": h,
                      "tilt_x": random.uniform(-0.01, 0.01) if k % 50 == 0 else 0.004})  # fmt: skip
        delta += delta_dot * h
    return found


def taken(running: RunningKernel, moment: dict[str, float]) -> None:
    running.set(**{name: value for name, value in moment.items() if name != "h"})
    running.step(moment["h"])


def seen(running: RunningKernel) -> np.ndarray:
    return np.concatenate([np.atleast_1d(running[name]) for name in SEEN])


@pytest.mark.parametrize("more", [{"n": 30}, {"n": 12, "n_strips": 2, "n_groups": 2, "length_spread": 0.02}], ids=str)
def test_forces_and_energies_are_those_of_filaments_that_never_sleep(more: dict[str, Any]) -> None:
    lazy, eager = brush(**more, **FINE), brush(**more, **FINE, **AWAKE)
    moments = story(seed=more["n"], steps=260)
    rows: list[tuple[np.ndarray, np.ndarray]] = []
    slept = 0.0
    for moment in moments:
        taken(lazy, moment)
        taken(eager, moment)
        rows.append((seen(lazy), seen(eager)))
        slept = max(slept, float(np.mean(lazy.arrays["clock"] >= 0.0)))
    mine, others = (np.array(side) for side in zip(*rows, strict=True))
    scale = np.max(np.abs(others), axis=0)
    # The one that never sleeps takes micro-steps where the other knows that it flies. What remains is the error of the
    # map of free flight, 2e-5 per radian of the fastest mode at most, which base reactions and shares of modes show.
    difference = np.max(np.abs(mine - others) / np.maximum(scale, 1e-12), axis=0)
    in_modes = np.array([name.endswith(("eq11", "eq12", "eq15", "fraction")) for name in SEEN] + [True] * 5)
    assert np.max(difference[in_modes]) < 1e-4
    assert np.max(difference[~in_modes]) < 2e-6
    assert slept > 0.5
    assert abs(lazy["energy_residual"]) < 1e-4 * (lazy["W_friction"] + lazy["E_strain"])


def test_nobody_sleeps_through_the_hull() -> None:
    """The table looks at every filament; whoever would touch unnoticed would be missing in the sum of the forces."""
    lazy = brush(n=40)
    for k, moment in enumerate(story(seed=3, steps=300)):
        taken(lazy, moment)
        if k % 7 == 3:  # the hull jumps between two steps
            lazy.set(delta=moment["delta"] + 3e-3 * (-1) ** k)
            assert np.isfinite(lazy["F_z"])
        force = lazy["F_z"]
        lazy.call("table")
        assert -force == pytest.approx(float(np.sum(lazy.arrays["filament_F_n"])), rel=1e-12, abs=1e-12)


def test_who_asks_for_outputs_changes_nothing() -> None:
    asked, silent = brush(n=20), brush(n=20)
    for moment in story(seed=5, steps=120):
        taken(asked, moment)
        taken(silent, moment)
        asked.set(delta=moment["delta"] + 5e-3, omega_b=-moment["omega_b"])
        assert asked["F_z"] <= 0.0
        asked.call("table")
        for name in ("eta", "eta_dot", "clock", "awake", "sums", "maps", "swing", "h_next"):
            np.testing.assert_array_equal(asked.arrays[name], silent.arrays[name])


def test_a_saved_state_holds_the_clocks_of_the_sleepers() -> None:
    running, other = brush(n=20), brush(n=20)
    moments = story(seed=7, steps=400)
    for moment in moments[:150]:
        taken(running, moment)
    other.restore(running.save())
    for moment in moments[150:]:
        taken(running, moment)
        taken(other, moment)
        np.testing.assert_array_equal(running.values["y"], other.values["y"])


def test_sums_moved_by_one_map_are_the_sums_of_all_to_rounding() -> None:
    """Far from the hull, through more than an era of steps of two lengths, with a speed that varies and turns round."""
    lazy, eager = brush(n=24), brush(n=24, **AWAKE)
    for k in range(600):
        moment = {"omega_b": 14.0 * np.cos(0.02 * k), "delta": -0.05, "h": 5e-4 if k % 3 else 1e-3}
        taken(lazy, moment)
        taken(eager, moment)
    assert np.all(lazy.arrays["clock"] >= 0.0)
    for name in ("E_kinetic", "E_strain", "E_centrifugal", "W_damping", "F_y_eq11", "M_b_eq12", "P_damping"):
        assert lazy[name] == pytest.approx(eager[name], rel=1e-9)
    lazy.call("table")
    eager.call("table")
    np.testing.assert_allclose(lazy.arrays["filament_y"], eager.arrays["filament_y"], rtol=1e-9)


def test_a_step_looks_at_no_filament_that_is_far_from_the_hull() -> None:
    for n in (50, 5000):
        running = brush(n=n)
        running.set(omega_b=15.7, delta=-5e-3)
        for _ in range(5):
            running.step(5e-4)
        assert running.arrays["awake_count"][0] == 0.0
        assert running["contact_count"] == 0.0
        assert running["E_kinetic"] > 0.0


def test_largest_deflection_is_that_of_a_sleeper_that_was_bent_by_hand() -> None:
    lazy, eager = brush(n=24), brush(n=24, **AWAKE)
    for one in (lazy, eager):
        one.arrays["eta"][5, 0] = 4e-3  # the tip 8 mm aside
    before = 0.1
    for k in range(300):
        for one in (lazy, eager):
            taken(one, {"omega_b": 14.0, "delta": -0.05, "h": 5e-4})
        # of those that sleep where the step begins, which is where the last one ended
        assert lazy["deflection_ratio"] == pytest.approx(before, abs=1e-4 if k else 1e-2)
        before = eager["deflection_ratio"]
    assert np.all(lazy.arrays["clock"] >= 0.0)
    assert lazy["deflection_ratio_max"] == pytest.approx(0.1, abs=2e-3)


def test_nobody_is_bent_farther_than_the_largest_deflection() -> None:
    lazy = brush(n=30)
    alone = 0
    for moment in story(seed=11, steps=240):
        lazy.call("table")
        asleep = lazy.arrays["clock"] >= 0.0
        bent = np.abs(lazy.arrays["filament_y"][asleep]) / 0.08
        taken(lazy, moment)
        if np.any(asleep):
            alone += bool(np.max(bent) > 0.99 * lazy["deflection_ratio"])
            assert lazy["deflection_ratio"] >= np.max(bent) - 1.0001e-4
            assert lazy["deflection_ratio_max"] >= lazy["deflection_ratio"]
    assert alone > 5  # it was one that slept, now and then
