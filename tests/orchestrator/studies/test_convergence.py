"""`rovbrush converge`: observed orders and error bars against what is known of the quarter car."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import column, run_of, system_text
from native_build import FREE3, built, needs_gcc
from quarter_car import exact
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.convergence import converge, signal_row

PARTS = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]


def report(tmp_path: Path, fmus: Path, **keys: Any) -> dict[str, dict[str, Any]]:
    path = tmp_path / "car.toml"
    path.write_text(system_text(PARTS, WIRES, stop="2 s", **keys))
    converge(str(path), tmp_path / "out", fmus)
    return {r["signal"]: r for r in json.loads((tmp_path / "out" / "convergence.json").read_text())["signals"]}


@pytest.mark.parametrize(("algorithm", "order"), [("jacobi", 1.0), ("iterated", 2.0)])
def test_the_observed_order_and_the_error_bar_are_the_true_ones(
    algorithm: str, order: float, tmp_path: Path, fmus: Path
) -> None:
    rows = report(tmp_path, fmus, algorithm=algorithm)
    run = run_of(tmp_path, fmus, PARTS, WIRES, stop="2 s", algorithm=algorithm)
    for name in ("c.z_c", "w.z_w"):
        times, values = column(run, name)
        true = float(np.max(np.abs(values - exact(times)[name[2:]])))
        assert rows[name]["order"] == pytest.approx(order, abs=0.2)
        assert rows[name]["error_bar"] == pytest.approx(true, rel=0.1)  # Richardson's: up to the next order


def test_table_and_figure_are_written(tmp_path: Path, fmus: Path) -> None:
    rows = report(tmp_path, fmus, algorithm="jacobi")
    with (tmp_path / "out" / "convergence.csv").open() as file:
        table = list(csv.DictReader(file))
    assert {r["signal"] for r in table} == set(rows) == {"w.F", "w.z_w", "w.J", "w.v_c", "c.z_c", "c.v_c", "c.F"}
    assert float(table[0]["error_bar"]) == rows[table[0]["signal"]]["error_bar"]
    assert (tmp_path / "out" / "convergence.png").read_bytes()[:4] == b"\x89PNG"


def test_what_does_not_converge_has_no_error_bar() -> None:
    from rovbrush.orchestrator.results.signals import Signal

    time = np.linspace(0.0, 1.0, 5)
    for scale, bar in ((1.0, None), (0.5, 2.0), (0.0, None)):
        runs: Any = [{"s": Signal("s", "1", "", time, np.full(5, v))} for v in (1.0, 2.0, 2.0 + scale)]
        assert signal_row("s", runs)["error_bar"] == bar
    same: Any = [{"s": Signal("s", "1", "", time, time)}] * 3
    assert signal_row("s", same)["error_bar"] == 0.0 and signal_row("s", same)["order"] is None


def test_the_command_prints_the_table(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "car.toml"
    path.write_text(system_text(PARTS, WIRES, stop="1 s", algorithm="jacobi"))
    command = [sys.executable, "-m", "rovbrush.orchestrator", "converge", str(path), "--fmus", str(fmus)]
    done = subprocess.run([*command, "--out", str(tmp_path)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "observed" in done.stdout and "c.z_c" in done.stdout and "convergence.png" in done.stdout


def test_adaptive_steps_have_no_periods_to_halve(tmp_path: Path, fmus: Path) -> None:
    bond = {"name": "strut", "effort": "c.F", "flow": "w.v_c"}
    with pytest.raises(InputError, match="the tolerances decide the steps"):
        report(tmp_path, fmus, algorithm="ecco", bonds=[bond])


@needs_gcc
def test_texts_do_not_converge_and_whole_numbers_are_compared_exactly(tmp_path: Path) -> None:
    parts = {"a": ("feedthrough3", "2 ms", FREE3)}
    (tmp_path / "types.toml").write_text(system_text(parts, stop="8 ms"))
    signals = {r["signal"]: r for r in converge(str(tmp_path / "types.toml"), tmp_path, built(tmp_path)).signals}
    assert "a.String_out" not in signals and "a.t_out[1]" not in signals
    for name in ("UInt8_out", "Int8_out", "Boolean_out", "Enumeration_out", "Float32_out"):
        assert (signals[f"a.{name}"]["difference_halved"], signals[f"a.{name}"]["error_bar"]) == (0.0, 0.0)
