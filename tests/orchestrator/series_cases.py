"""A system of one integrator whose input follows a table."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from helpers import read_system
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.system.inputs.series_file import with_inputs
from rovbrush.orchestrator.system.model import System

ONE = {"i": ("integrator", "2 ms", {"=u": 0.0})}
ROWS = [0.0, 0.003, 0.0045, 0.0045, 0.02]
VALUES = [1.0, 4.0, -2.0, 5.0, 5.0]


def one(tmp_path: Path, fmus: Path, stop: str = "20 ms", period: str = "2 ms") -> System:
    return read_system(tmp_path, fmus, {"i": ("integrator", period, {"=u": 0.0})}, stop=stop)


def planned(system: System, inputs: dict[str, Any]) -> Plan:
    return make_plan(with_inputs(system, inputs))


CONTROLLER = {
    f"={name}": 0.0
    for name in (
        *("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r", "x_ref", "y_ref", "z_ref"),
        *("phi_ref", "theta_ref", "psi_ref", "v_ref", "V_ref", "F_n_ref", "F_tool", "M_tool"),
    )
}
