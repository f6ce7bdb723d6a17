"""The brush kernel gives the same bits as plain Python, as machine code, under Numba and as C."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Case, component, history, lives
from machine_life import machine

INPUTS = {"omega_b": (12.0, 6.0), "delta": (4e-3, 3e-3), "v_rov": (0.05, 0.1), "delta_dot": (0.0, 0.5),
          "friction_scale": (1.0, 0.3), "tilt_x": (0.0, 0.03)}  # fmt: skip
CASES = (
    Case("filament_brush", 1e-3, 50, INPUTS, {"n": 8}),
    Case(
        "filament_brush", 1e-3, 20, INPUTS,
        {"n": 3, "N_m": 6, "theta_b_0": -0.4, "foreshortening": False, "mode_acceleration": False, "c_c": 20.0},
        "six modes, linear",
    ),
    Case(
        "filament_brush", 2e-3, 20, INPUTS, {"n": 20, "N_m": 1, "centrifugal": False, "c_c": 20.0, "Delta_s": 0.0},
        "one mode",
    ),
    Case("filament_brush", 1e-3, 40, INPUTS, {"n": 8, "friction_law": 1}, "static peak"),
    Case(
        "filament_brush", 1e-3, 40, INPUTS,
        {"n": 8, "n_strips": 3, "hull_curvature": 0.2, "n_groups": 2, "length_spread": 0.05}, "strips and groups",
    ),
    Case(
        "filament_brush", 1e-3, 40, INPUTS | {"omega_b": (1.0, 6.0)}, {"n": 8, "friction_law": 2, "c_c": 5.0}, "LuGre",
    ),
)  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=str)
def test_python_and_machine_code_agree_bit_by_bit(case: Case) -> None:
    compare(case, {"machine": machine(component("filament_brush").kernel)})


@pytest.mark.evidence
@pytest.mark.parametrize("case", CASES, ids=str)
def test_python_numba_and_c_agree_bit_by_bit(case: Case) -> None:
    compare(case, {life: functions for life, functions in lives("filament_brush").items() if life != "python"})


def compare(case: Case, others: dict[str, Any]) -> None:
    python = history(case, component("filament_brush").kernel)
    assert np.all(np.isfinite(python[-1]["y"]))
    assert any(snapshot["y"][1] != 0.0 for snapshot in python)  # there was contact
    for life, functions in others.items():
        for k, (expected, seen) in enumerate(zip(python, history(case, functions), strict=True)):
            for name, array in expected.items():
                assert np.array_equal(array.view(np.int64), seen[name].view(np.int64)), f"{life}: {name}, step {k}"
