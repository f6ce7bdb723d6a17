"""Linear models of FMUs that say which their states are, against the matrices of their equations."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from exchange_build import exchange
from helpers import Measured
from native_build import needs_gcc
from rovbrush.orchestrator.studies.linear.linearise import linearise
from rovbrush.orchestrator.studies.linear.options import Options
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc

# x_k' = (push_k - x_k) / tau_k, y_k = x_k + d_k push_k; push_1 = y_2 + w, push_2 = y_1
TAU, D = (0.5, 0.25), (0.5, -0.4)
SYSTEM = """
format = 2
stop_time = "1 s"
connections = ["b.y -> a.push", "a.y -> b.push"]
[components.a]
fmu = "{name}.fmu"
period = "10 ms"
parameters = {{ tau = {tau[0]}, d = {d[0]} }}
inputs = {{ on = false }}
[components.b]
fmu = "{name}.fmu"
period = "10 ms"
parameters = {{ tau = {tau[1]}, d = {d[1]} }}
inputs = {{ on = false }}
"""


def wanted(d: tuple[float, float]) -> tuple[np.ndarray, ...]:
    """A, B, C, D from w, which is added to push_1, to y_1 and y_2: the direct loop is solved by hand."""
    K = np.array([[0.0, 1.0], [1.0, 0.0]])
    inverse = np.linalg.inv(np.eye(2) - K @ np.diag(d))  # push = K (x + d push) + e w
    e = np.array([[1.0], [0.0]])
    push_x, push_w = inverse @ K, inverse @ e
    rate = np.diag(1.0 / np.array(TAU))
    return rate @ (push_x - np.eye(2)), rate @ push_w, np.eye(2) + np.diag(d) @ push_x, np.diag(d) @ push_w


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize(("name", "bound"), [("lag", 1e-12), ("plain_lag", 1e-8)])
@pytest.mark.parametrize("d", [(0.0, 0.0), D])
def test_models_for_model_exchange_have_the_matrices_of_their_equations(
    name: str, bound: float, d: tuple[float, float], version: int, tmp_path: Path, measured: Measured
) -> None:
    """By directional derivatives, and by differences where there are none; with a loop of direct dependence too."""
    exchange(tmp_path, name, version)
    (tmp_path / "case.toml").write_text(SYSTEM.format(name=name, tau=TAU, d=d))
    system = load_system(str(tmp_path / "case.toml"), tmp_path)
    (model,) = linearise(system, ["b.y -> a.push"], ["a.y", "b.y"], Options(at=["0 s"], method="states"))
    error = max(
        float(np.max(np.abs(found - known)))
        for found, known in zip((model.A, model.B, model.C, model.D), wanted(d), strict=True)
    )
    if version == 2:
        measured(f"linear model of two {name}, d = {d}: matrices against the equations", error, f"{bound:g}")
    assert model.dt == 0.0 and error < bound and model.states == ("a.x", "b.x")


def test_sampled_it_has_the_poles_of_the_exponential(tmp_path: Path) -> None:
    exchange(tmp_path, "lag", 2)
    (tmp_path / "case.toml").write_text(SYSTEM.format(name="lag", tau=TAU, d=D))
    system = load_system(str(tmp_path / "case.toml"), tmp_path)
    (model,) = linearise(system, ["b.y -> a.push"], ["a.y"], Options(at=["0 s"], sample="20 ms"))
    poles = np.sort(np.array([pole.z.real for pole in model.poles]))
    assert np.allclose(poles, np.sort(np.exp(np.linalg.eigvals(wanted(D)[0]).real * 0.02)), rtol=1e-9)
