"""The dual mass oscillator in two units, against the exact solution."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from helpers import ROOT, Measured, last, run_of

REFERENCE = json.loads((ROOT / "tests" / "reference" / "dual_mass.json").read_text())["exact_t10"]


@pytest.mark.evidence
@pytest.mark.parametrize("periods", [("2 ms", "2 ms"), ("2 ms", "1 ms")])
@pytest.mark.parametrize("algorithm", ["iterated", "gauss-seidel"])
def test_positions_at_10_s_are_the_exact_ones(
    algorithm: str, periods: tuple[str, str], tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    """Second order by iteration, or by extrapolation between two rates; one rate with held inputs is first order."""
    parts = {"a": ("mass1", periods[0]), "b": ("mass2", periods[1])}
    transfer = " (linear)" if algorithm == "gauss-seidel" else ""
    wires = [f"a.x -> b.x1{transfer}", f"a.v -> b.v1{transfer}", f"b.F -> a.F{' (mean)' if transfer else ''}"]
    run = run_of(tmp_path, fmus, parts, wires, stop="10 s", algorithm=algorithm)
    for name, key in (("a", "x1"), ("b", "x2")):
        error = last(run, f"{name}.x") - REFERENCE[key]
        measured(f"dual mass oscillator, {algorithm} {'/'.join(periods)}: error of {key}(10 s) [m]", error, "1e-5")
        assert abs(error) <= 1e-5


@pytest.mark.evidence
def test_by_iteration_at_half_a_millisecond_they_are_right_to_a_micrometre(
    tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    parts = {"a": ("mass1", "0.5 ms"), "b": ("mass2", "0.5 ms")}
    wires = ["a.x -> b.x1", "a.v -> b.v1", "b.F -> a.F"]
    run = run_of(tmp_path, fmus, parts, wires, stop="10 s", algorithm="iterated")
    error = max(abs(last(run, "a.x") - REFERENCE["x1"]), abs(last(run, "b.x") - REFERENCE["x2"]))
    measured("dual mass oscillator, iterated, 0.5 ms: largest error at 10 s [m]", error, "1e-6")
    assert error <= 1e-6
