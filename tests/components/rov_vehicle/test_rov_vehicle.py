"""The vehicle's matrices, and its thrusters and tool with the numbers of their sources."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import numpy as np
import pytest
from helpers import ROOT, Measured
from lives import Instance, component
from machine_life import machine
from rovbrush.components.library.thrusters import K_T
from rovbrush.components.rov_vehicle.parameters import NOMINAL, Parameters, about_origin

DECLARED = component("rov_vehicle")
REFERENCE = ROOT / "tests" / "reference"


def vehicle(chosen: Parameters = NOMINAL, inputs: dict[str, Any] | None = None, **changes: Any) -> Instance:
    parameters = {f.name: getattr(chosen, f.name) for f in dataclasses.fields(chosen)} | changes
    instance = Instance(DECLARED, machine(DECLARED.kernel), **parameters)
    instance.set(**(inputs or {}))
    instance.start()
    return instance


def run(instance: Instance, duration: float, h: float = 5e-3) -> Instance:
    for _ in range(round(duration / h)):
        instance.step(h)
    return instance


def test_mass_matrix_is_symmetric_and_its_inverse_is_exact() -> None:
    seen = vehicle(r_g=(0.01, -0.02, 0.03), I_products=(0.01, -0.02, 0.005))
    M = seen.arrays["M"]
    np.testing.assert_array_equal(M, M.T)
    np.testing.assert_allclose(M @ seen.arrays["M_inv"], np.eye(6), atol=1e-14)


def test_parallel_axes_add_mass_times_distance_squared() -> None:
    moments, products = about_origin((0.1, 0.2, 0.3), 2.0, (0.5, 0.0, 1.0))
    assert moments == pytest.approx((2.1, 2.7, 0.8))
    assert products == pytest.approx((0.0, -1.0, 0.0))


def test_allocation_matrix_equals_the_printed_one_up_to_column_signs(measured: Measured) -> None:
    printed = np.array(json.loads((REFERENCE / "bluerov2.json").read_text())["thrusters"]["B_wu2018_rows_XYZKMN"])
    signs = np.array([-1, -1, -1, -1, -1, 1, 1, -1])
    difference = np.abs(vehicle().arrays["B"] - printed * signs).max()
    measured("vehicle: allocation matrix against the printed one, up to signs", difference, "1.2e-4 (printed digits)")
    # Printed to three decimals, 0.0601 as 0.06.
    assert difference <= 1.2e-4


def test_thrust_authority_is_that_of_the_thrust_curve() -> None:
    authority = json.loads((REFERENCE / "bluerov2.json").read_text())["thrusters"]["authority_12V"]
    surge = run(vehicle(inputs={"u_thruster": (-1, -1, 1, 1, 0, 0, 0, 0)}), 0.5)["F_control"][0]
    # The quoted authority is taken from the table, which lies 8 to 11 % below the fit at full command.
    assert surge == pytest.approx(np.sqrt(2.0) * (K_T[12][0] + K_T[12][1]), rel=1e-9)
    assert surge == pytest.approx(authority["surge_sway_N"], rel=0.13)
    heave = run(vehicle(inputs={"u_thruster": (0, 0, 0, 0, 1, 1, 1, 1)}), 0.5)["F_control"][2]
    assert heave == pytest.approx(4.0 * K_T[12][0], rel=1e-9)
    assert heave == pytest.approx(authority["heave_N_four_forward"], rel=0.13)


@pytest.mark.parametrize(
    ("volt", "rms", "at_full"), [(12, (2.67, 2.51), (36.42, 28.48)), (16, (3.89, 3.71), (51.44, 39.91))]
)
def test_thrust_curve_follows_the_published_table(volt: int, rms: Any, at_full: Any) -> None:
    # Quoted for the whole table at 12 V: 1.7 and 1.4 N. The rms below are those of the seven rows carried here, which
    # weigh the ends more, where the quadratic law is 12 to 14 % too strong.
    lines = [line for line in (REFERENCE / "t200_thrust.csv").read_text().splitlines() if not line.startswith("#")]
    u = (np.array([float(x) for x in lines[0].split(",")[1:]]) - 1500.0) / 400.0
    table = {int(line.split(",")[0]): np.array([float(x) for x in line.split(",")[1:]]) for line in lines[1:]}
    for side, k_T, quoted, full in zip((u > 0, u < 0), K_T[volt], rms, at_full, strict=True):
        error = table[volt][side] - k_T * (u * np.abs(u))[side]
        assert np.sqrt(np.mean(error**2)) == pytest.approx(quoted, abs=0.01)
        assert 1.12 < k_T / full < 1.14


def test_brush_touches_with_the_penetration_of_table_3_at_the_origin() -> None:
    assert vehicle()["delta"] == pytest.approx(0.005, abs=1e-15)
    assert vehicle()["misalignment"] == 0.0
