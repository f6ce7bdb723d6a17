"""Kernel, Python FMU and native FMUs of FMI 2.0 and 3.0 give the same bits over 10 000 steps of random input."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from driven import DrivenFmu, DrivenKernel, component, input_layout
from helpers import Measured
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machine_life import machine
from rovbrush.components.declare.interface import Variable, parameter_variables

STEPS = 10_000
# Communication step [s] and ranges of the inputs; what is not named here stays at its start value.
CASES: dict[str, tuple[float, Mapping[str, tuple[float, float]]]] = {
    "filament_brush": (5e-4, {"omega_b": (5.0, 25.0), "delta": (-0.002, 0.006), "v_rov": (-0.2, 0.2),
                              "friction_scale": (0.5, 2.0), "tilt_x": (-0.05, 0.05)}),
    "cup_brush": (5e-4, {"omega_b": (-5.0, 25.0), "delta": (-0.002, 0.008), "v_rov": (-0.2, 0.2),
                         "delta_dot": (-0.1, 0.1), "friction_scale": (0.0, 2.0), "misalignment": (-0.05, 0.05)}),
    "dc_motor": (1e-3, {"V_in": (-12.0, 12.0), "T_brush": (-20.0, 20.0)}),
    "rov_vehicle": (5e-3, {"u_thruster": (-1.2, 1.2), "F_x": (-60.0, 60.0), "F_z": (-120.0, 90.0), "M_y": (-9.0, 9.0),
                           "H_x": (-1.0, 1.0), "H_y": (-12.0, 12.0), "H_z": (-1.0, 1.0), "V_thruster": (9.0, 17.0),
                           "v_c": (-0.3, 0.3), "F_external": (-9.0, 9.0), "M_external": (-1.5, 1.5)}),
    "rov_controller": (2e-2, {"x_n": (-0.3, 0.3), "z_n": (-0.5, 0.7), "phi": (-1.0, 1.0), "theta": (-1.5, 1.5),
                              "psi": (-3.1, 3.1), "u": (-0.3, 0.3), "q": (-0.3, 0.3), "F_tool": (-50.0, 20.0),
                              "M_tool": (-9.0, 4.0), "F_n_ref": (0.0, 60.0), "v_ref": (-0.1, 0.1)}),
    "mission": (5e-2, {"x_n": (-0.7, 0.3)}),
    "constant_speed": (1e-3, {"V_in": (-3.0, 15.0), "T_brush": (-20.0, 5.0)}),
    "tool_frame": (5e-4, {"delta": (-0.01, 0.01), "delta_dot": (-0.1, 0.1), "v_rov": (-0.2, 0.2), "tilt_x": (-0.3, 0.3),
                          "tilt_y": (-0.3, 0.3), "p": (-1.0, 1.0), "q": (-1.0, 1.0), "r": (-1.0, 1.0),
                          "F_x_tool": (-9.0, 9.0), "F_z_tool": (-90.0, 0.0), "M_y_tool": (-9.0, 9.0)}),
    "battery": (1.0, {"i": (-30.0, 70.0), "i_other": (0.0, 9.0)}),
    "hull_fouling": (5e-2, {"s": (-0.3, 1.3), "delta": (-0.002, 0.006), "omega_b": (-5.0, 20.0), "v_rov": (-0.1, 0.1),
                            "F_z": (-50.0, 0.0), "W_friction": (0.0, 500.0)}),
    "rov_sensors": (5e-3, {"x_n": (-0.3, 0.3), "z_n": (-0.5, 0.7), "phi": (-1.0, 1.0), "theta": (-1.5, 1.5),
                           "psi": (-3.1, 3.1), "u": (-0.3, 0.3), "q": (-0.3, 0.3), "nu_dot": (-1.0, 1.0),
                           "F_tool": (-50.0, 20.0), "M_tool": (-9.0, 4.0)}),
}  # fmt: skip
# Sizes and internal steps set how much work a step is: they vary in small steps so that a test stays a test.
WHOLE = {
    "n": (1, 60),
    "N_m": (1, 6),
    "gear_stages": (1, 3),
    "rotor_sense": (-1, 1),
    "mode": (0, 3),
    "friction_law": (0, 2),
    "n_strips": (1, 3),
    "n_groups": (1, 2),
    "n_series": (1, 9),
    "n_parallel": (1, 9),
    "seed": (0, 2147483647),
}
STATED = {"h_min", "h_max", "tolerance", "max_step"}


@st.composite
def parameters_of(draw: Any, name: str) -> dict[str, Any]:
    """A few parameters away from their defaults: by up to a third where that is admissible, switches freely."""
    declared = parameter_variables(component(name).parameters)
    chosen = draw(st.lists(st.sampled_from(declared), max_size=8, unique_by=lambda v: v.name))
    return {v.name: draw(_value(v)) for v in chosen if v.name not in STATED}


def _value(v: Variable) -> Any:
    if v.kind == "Boolean":
        return st.booleans()
    if v.kind == "Integer":
        low, high = WHOLE[v.name]
        return st.integers(max(low, int(v.minimum)), min(high, int(v.maximum)))
    elements = [st.floats(*_near(v, start)) for start in v.start]
    return st.tuples(*elements) if v.size else elements[0]


def _near(v: Variable, start: float) -> tuple[float, float]:
    ends = sorted((start / 1.3, start * 1.3))
    return max(ends[0], v.minimum), min(ends[1], v.maximum)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", CASES)
def test_kernel_python_fmu_and_native_fmus_give_the_same_bits(
    name: str, fmus: Path, native: Path, tmp_path: Path, measured: Measured
) -> None:
    h, ranges = CASES[name]
    layout = input_layout(name)
    functions = machine(component(name).kernel)
    files = {
        "python": fmus / f"{name}.fmu",
        "fmi2": native / "fmi2" / f"{name}.fmu",
        "fmi3": native / "fmi3" / f"{name}.fmu",
    }
    compared = differing = 0

    @settings(max_examples=4, deadline=None, derandomize=True, database=None,
              suppress_health_check=list(HealthCheck))  # fmt: skip
    @given(parameters=parameters_of(name), seed=st.integers(0, 2**32 - 1))
    def compare(parameters: dict[str, Any], seed: int) -> None:
        nonlocal compared, differing
        rows = random_inputs(name, ranges, layout, seed)
        start = {key: rows[0, place] if place.stop - place.start > 1 else rows[0, place.start]
                 for key, place in layout.items()}  # fmt: skip
        kernel = DrivenKernel(name, functions, parameters)
        kernel.start(start)
        expected = kernel.run(rows, layout, h)
        assert np.all(np.isfinite(expected))
        for life, path in files.items():
            driven = DrivenFmu(path, tmp_path / life, parameters)
            driven.start(start)
            seen = driven.run(rows, layout, h)
            driven.close()
            different = np.argwhere(seen.view(np.int64) != expected.view(np.int64))
            differing += len(different)
            compared += seen.size
            assert not len(different), f"{life}: step and output {different[0]}"

    compare()
    measured(f"{name}: outputs that differ between kernel, Python FMU, native FMUs, of {compared}", differing, "0")
    assert compared >= 3 * STEPS


def random_inputs(
    name: str, ranges: Mapping[str, tuple[float, float]], layout: Mapping[str, slice], seed: int
) -> np.ndarray:
    """A table (steps, inputs): each input wanders in its range, held for 20 steps; others at their start value."""
    generator = np.random.default_rng(seed)
    rows = np.empty((STEPS, max(place.stop for place in layout.values())))
    for v in component(name).inputs:
        place = layout[v.name]
        rows[:, place] = v.start
        if v.name in ranges:
            points = generator.uniform(*ranges[v.name], (STEPS // 20, len(v.start)))
            rows[:, place] = np.repeat(points, 20, axis=0)
    return rows
