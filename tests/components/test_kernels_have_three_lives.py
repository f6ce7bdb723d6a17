"""Every kernel gives the same bits in all its lives, and writes its outputs in declared order."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Case, component, history, lives
from machine_life import machine
from rovbrush.components.lowering.lowered import lowered

MEASURED = {
    "x_n": (0.0, 0.3), "z_n": (0.1, 0.6), "phi": (0.0, 0.9), "theta": (0.0, 1.6), "psi": (0.0, 3.1), "u": (0.0, 0.2),
    "q": (0.0, 0.3), "psi_ref": (0.4, 0.3), "V_ref": (11.0, 1.0),
}  # fmt: skip
TOOL = {"F_tool": (-20.0, 30.0), "M_tool": (-5.0, 4.0), "F_n_ref": (30.0, 40.0), "v_ref": (0.0, 0.1)}
NOISY = {
    "delay": 0.012, "gain": 1.1, "rate_dvl": 15.0, "noise_dvl": 0.01, "dropout_dvl": 0.3, "delay_dvl": 0.1,
    "noise_force": 0.5, "rate_depth": 50.0, "quantum_depth": 0.002, "rate_gyro": 400.0, "noise_gyro": 0.003,
    "bias_gyro": (0.1, 0.0, -0.1),
    "bias_attitude": (0.0, 0.0, 1.0), "r_imu": (0.1, 0.0, -0.2), "noise_accelerometer": 0.02,
}  # fmt: skip
CASES = (
    Case("filament_brush", 1e-3, 10, {"omega_b": (15.0, 3.0), "delta": (0.005, 0.003), "v_rov": (0.05, 0.05)}),
    Case(
        "filament_brush", 1e-3, 12,
        {"omega_b": (12.0, 9.0), "delta": (0.004, 0.004), "v_rov": (0.05, 0.05), "delta_dot": (0.0, 0.1)},
        {"C_d": 1.1, "C_a": 1.0, "shielding": 0.2, "pack_drag": 1.0, "C_paddle": 1.2, "linear_below": 2.0}, "wet",
    ),
    Case("cup_brush", 1e-3, 10, {"omega_b": (15.0, 3.0), "delta": (0.005, 0.003), "v_rov": (0.05, 0.05),
                                 "misalignment": (0.0, 0.05), "delta_dot": (0.0, 0.1)}),
    Case(
        "cup_brush", 1e-3, 10, {"omega_b": (0.0, 3.0), "delta": (0.002, 0.003), "friction_scale": (0.6, 0.6)},
        {"alpha": 0.2, "pack_drag": 1.0, "row_tufts": (7.0, 5.0, 0.0, 3.0, 0.0, 0.0, 0.0, 1.0)}, "rows",
    ),
    Case("dc_motor", 1e-3, 60, {"V_in": (8.0, 6.0), "T_brush": (-10.0, 9.0)}),
    Case(
        "dc_motor", 5e-3, 40, {"V_in": (0.0, 12.0), "T_brush": (0.0, 20.0)},
        {"current_limit": 60.0, "gear_efficiency": 0.7}, "limited",
    ),
    Case(
        "rov_vehicle", 5e-3, 60,
        {"u_thruster": (0.1, 1.2), "F_x": (-60.0, 50.0), "F_z": (-120.0, 90.0), "M_y": (-9.0, 8.0), "H_y": (5.0, 4.0),
         "v_c": (0.2, 0.3), "F_external": (2.0, 9.0), "M_external": (0.0, 1.5)},
        {"attitude_start": (0.3, -0.4, 2.0), "rates_start": (0.1, 0.5, -0.2)},
    ),
    Case("rov_vehicle", 5e-3, 60, {"M_y": (0.0, 4.0)}, {"attitude_start": (0.3, 1.5707963267948966, 2.0)}, "vertical"),
    Case(
        "rov_vehicle", 5e-3, 60,
        {"u_thruster": (0.1, 1.2), "F_x": (-60.0, 50.0), "F_y": (0.0, 9.0), "F_z": (-120.0, 90.0), "H_y": (5.0, 4.0)},
        {"attitude_start": (0.3, -0.4, 2.0), "m_tool": 4.5, "r_g_tool": (0.02, -0.05, 0.03),
         "I_tool": (0.05, 0.04, 0.06), "I_products_tool": (0.004, -0.002, 0.003), "buoyancy_tool": 30.0,
         "r_b_tool": (0.01, 0.02, -0.04), "wrench_along_normal": True}, "tool",
    ),
    Case(
        "rov_vehicle", 5e-3, 60, {"u_thruster": (0.1, 1.2), "V_thruster": (13.0, 4.0), "F_z": (-120.0, 90.0)},
        {"thruster_delay": 0.033, "thrust_table": True, "hull_loss": 0.4, "thruster_dead_band": 0.02}, "thrusters",
    ),
    Case("rov_controller", 0.02, 60, MEASURED),
    Case("rov_controller", 0.01, 60, MEASURED, {"attitude_first": False}, "clipping"),
    Case("rov_controller", 0.005, 120, MEASURED | TOOL, {"mode": 1}, "feedforward"),
    Case("rov_controller", 0.005, 120, MEASURED | TOOL, {"mode": 2, "K_force": 0.3}, "force"),
    Case(
        "rov_controller", 0.005, 120, MEASURED | TOOL,
        {"mode": 2, "K_force_a": 5.0, "bumpless": True, "hull_normal": (0.6, 0.0, -0.8), "bounded_least_squares": True},
        "bounded",
    ),
    Case("rov_controller", 0.005, 120, MEASURED | TOOL, {"mode": 3, "observed_velocity": True}, "observer"),
    Case("mission", 0.05, 60, {"x_n": (-0.3, 0.4)}, {"fouling_scale": (1.0, 0.6, 0.6, 1.0, 1.0, 1.4, 1.4, 1.0),
                                                     "t_settle": 0.1, "length": 0.03}),
    Case("constant_speed", 1e-3, 30, {"V_in": (6.0, 9.0), "T_brush": (-10.0, 9.0)}),
    Case("battery", 0.5, 60, {"i": (30.0, 70.0), "i_other": (5.0, 4.0)}, {"soc_start": 0.905}),
    Case("battery", 60.0, 60, {"i": (40.0, 70.0)}, {"soc_start": 0.3, "R_1_cell": 0.0}, "emptied"),
    Case("hull_fouling", 0.05, 60, {"s": (0.4, 0.5), "delta": (0.001, 0.003), "omega_b": (12.0, 5.0),
                                    "v_rov": (0.0, 0.1), "F_z": (-20.0, 15.0), "W_friction": (500.0, 400.0)},
         {"fouling_scale": (1.0, 0.6, 0.6, 1.0, 1.0, 1.4, 1.4, 1.0)}),
    Case("rov_sensors", 0.005, 60, MEASURED | TOOL | {"nu_dot": (0.0, 0.4)}),
    Case("rov_sensors", 0.005, 60, MEASURED | TOOL | {"nu_dot": (0.0, 0.4)}, NOISY, "noisy"),
    Case("tool_frame", 1e-3, 20, {"delta": (0.005, 0.003), "tilt_x": (0.0, 0.3), "tilt_y": (0.1, 0.3), "q": (0.0, 0.5),
                                  "r": (0.1, 0.5), "F_x_tool": (-5.0, 9.0), "F_z_tool": (-20.0, 9.0)},
         {"x_tool": (0.16, -0.16, 0.0), "y_tool": (-0.1, 0.1, 0.3), "hull_curvature": 0.2}),
)  # fmt: skip
NAMES = tuple(dict.fromkeys(case.name for case in CASES))


SMALL = ("dc_motor-limited", "tool_frame-default")  # Numba takes up to one and a half minutes for the others
ALL_LIVES = [case if str(case) in SMALL else pytest.param(case, marks=pytest.mark.evidence) for case in CASES]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_python_and_machine_code_agree_bit_by_bit(case: Case, measured: Measured) -> None:
    unequal = compared(case, {"machine": machine(component(case.name).kernel)})
    measured(f"kernel {case}: numbers that differ between Python and machine code", unequal, "0")


@pytest.mark.parametrize("case", ALL_LIVES, ids=str)
def test_python_numba_and_c_agree_bit_by_bit(case: Case, measured: Measured) -> None:
    """Of what is not small `make test` has the C in the native FMUs (tests/fmus/native/test_native_equality.py)."""
    unequal = compared(case, {life: functions for life, functions in lives(case.name).items() if life != "python"})
    measured(f"kernel {case}: numbers that differ between Python, machine code, Numba and C", unequal, "0")


def compared(case: Case, others: dict[str, Any]) -> int:
    """How many numbers differ from those of plain Python: none."""
    python = history(case, component(case.name).kernel)
    assert np.all(np.isfinite(python[-1]["y"]))
    unequal = 0
    for life, functions in others.items():
        for k, (expected, seen) in enumerate(zip(python, history(case, functions), strict=True)):
            for name, array in expected.items():
                different = np.flatnonzero(array.ravel().view(np.int64) != seen[name].ravel().view(np.int64))
                unequal += different.size
                assert not different.size, f"{life}: {name}{different[:5]} after {k} steps"
    return unequal


@pytest.mark.parametrize("case", CASES, ids=str)
def test_no_output_reads_what_only_another_call_left(case: Case) -> None:
    """Scratch holds nothing from one call to the next: whatever lies there, outputs and states are the same."""
    clean, dirty = (history(case, component(case.name).kernel, spoiled) for spoiled in (False, True))
    lasting = {"y", *(a.name for a in component(case.name).arrays if not a.scratch)}
    for k, (expected, seen) in enumerate(zip(clean, dirty, strict=True)):
        for name in lasting:
            assert np.array_equal(expected[name], seen[name], equal_nan=False), f"{name} after {k} steps"


@pytest.mark.parametrize("name", NAMES)
def test_outputs_are_written_in_declared_order(name: str) -> None:
    declared = component(name)
    if "Outputs" in vars(declared.kernel):  # a record, whose order is the declared one: all of it is written
        text = "".join(part.path.read_text(encoding="utf-8") for part in lowered(declared.kernel).parts)
        assert {v.name for v in declared.outputs} <= set(re.findall(r"\by\.(\w+)(?:\[[^\]]+\])? (?:[-+*/]?=)", text))
        return
    tree = ast.parse(Path(str(declared.kernel.__file__)).read_text())
    function = next(f for f in tree.body if isinstance(f, ast.FunctionDef) and f.name == "outputs")
    written = [entry for entry in map(_written, function.body) if entry is not None]
    block = function.body[len(function.body) - len(written) :]
    assert all(_written(statement) is not None for statement in block), "y is written in one block at the end"
    expected = []
    first = 0
    for v in declared.outputs:
        expected.append((first, v.name, v.size))
        first += max(v.size, 1)
    assert written == expected


def _written(statement: ast.stmt) -> tuple[int, str, int] | None:
    """(first index, name, size) of `y[3] = name` or of `for r in range(8): y[3 + r] = name[r]`; None if neither."""
    size = 0
    if isinstance(statement, ast.For) and len(statement.body) == 1:
        count = ast.unparse(statement.iter)
        if not count.startswith("range("):
            return None
        loop, statement, size = statement, statement.body[0], int(count[6:-1]) if count[6:-1].isdigit() else 0
    if not (isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]).startswith("y[")):
        return None
    index = ast.unparse(statement.targets[0])[2:-1]
    value = ast.unparse(statement.value)
    if size:
        counter = ast.unparse(loop.target)
        index = "0" if index == counter else index.removesuffix(f" + {counter}")
        value = value.removesuffix(f"[{counter}]")
    return int(index), value, size
