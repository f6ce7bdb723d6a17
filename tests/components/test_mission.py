"""The cleaning pass: phases, continuity, fouling."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from rovbrush.components.kernels import compiled

DECLARED = component("mission")
T_S = 0.02


def mission(start: tuple[float, float, float] = (0.0, 0.0, 0.0), **parameters: Any) -> Instance:
    instance = Instance(DECLARED, compiled(DECLARED.kernel), **parameters)
    instance.set(x_n=start[0], y_n=start[1], z_n=start[2])
    instance.start()
    return instance


def run(seen: Instance, duration: float, h: float = T_S) -> np.ndarray:
    """Rows of x_ref, y_ref, z_ref, v_ref (3), F_n_ref, phase after each step."""
    rows = []
    for _ in range(round(duration / h)):
        seen.step(h)
        rows.append([seen["x_ref"], seen["y_ref"], seen["z_ref"], *seen["v_ref"], seen["F_n_ref"], seen["phase"]])
    return np.array(rows)


def test_pass_begins_where_the_vehicle_is() -> None:
    seen = mission((1.0, 2.0, 3.0))
    assert (seen["x_ref"], seen["y_ref"], seen["z_ref"]) == (1.0, 2.0, 3.0)


def test_pass_goes_through_its_phases_and_ends_off_the_hull() -> None:
    rows = run(mission(), 40.0)
    assert sorted(set(rows[:, 7])) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]
    assert np.all(np.diff(rows[:, 7]) >= 0.0)
    np.testing.assert_allclose(rows[-1, :3], [-1.0, 0.0, 0.05 - 0.1], atol=1e-15)
    at_hull = rows[rows[:, 7] == 3.0]
    np.testing.assert_allclose(at_hull[:, 2], 0.05 + 0.0022, atol=1e-15)
    assert len(at_hull) * T_S == pytest.approx(1.0 / 0.05, abs=2 * T_S)
    assert np.all(at_hull[:, 6] == 40.0) and np.all(rows[rows[:, 7] >= 6.0, 6] == 0.0)


def test_velocity_is_the_rate_of_the_set_point() -> None:
    rows = run(mission(), 40.0)
    rate = np.diff(rows[:, :3], axis=0) / T_S
    inside = (np.diff(rows[:, 7]) == 0.0)[:-1] & (np.diff(rows[:, 7]) == 0.0)[1:]
    np.testing.assert_allclose(rate[:-1][inside], rows[:-2, 3:6][inside], atol=1e-12)
    assert np.abs(np.diff(rows[:, :3], axis=0)).max() <= 0.05 * T_S + 1e-12  # no jumps


def test_force_falls_evenly_before_the_vehicle_leaves() -> None:
    rows = run(mission(t_release=2.0), 40.0)
    falling = rows[rows[:, 7] == 5.0, 6]
    assert len(falling) == pytest.approx(100, abs=1)
    np.testing.assert_allclose(np.diff(falling), -40.0 * T_S / 2.0, atol=1e-9)


def test_phases_of_no_length_are_passed_over() -> None:
    rows = run(mission(t_start=0.0, t_settle=0.0, t_release=0.0, length=0.0, standoff=0.0), 5.0)
    assert np.all(np.isfinite(rows)) and rows[-1, 7] == 7.0


@pytest.mark.parametrize("h", [T_S / 4, 5 * T_S])
def test_set_points_do_not_depend_on_the_communication_step(h: float) -> None:
    coarse, fine = run(mission(), 10.0, h), run(mission(), 10.0)
    np.testing.assert_array_equal(coarse[round(1.0 / h) - 1 :: round(1.0 / h)], fine[49::50])


def test_friction_is_linear_between_places_and_constant_beyond() -> None:
    places, scales = (0.0, 0.1, 0.2, 0.3, 0.3, 0.5, 0.6, 0.7), (1.0, 0.6, 0.6, 1.0, 2.0, 2.0, 1.4, 1.2)
    seen = mission(fouling_place=places, fouling_scale=scales)
    for s in (-1.0, 0.0, 0.05, 0.1, 0.17, 0.26, 0.4, 0.55, 0.7, 3.0):
        seen.set(x_n=-s)  # the pass goes along -x
        seen.step(T_S)
        assert seen["s"] == pytest.approx(s, abs=1e-15)
        assert seen["friction_scale"] == pytest.approx(np.interp(s, places, scales), abs=1e-12)
