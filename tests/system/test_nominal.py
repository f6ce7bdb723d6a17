"""The paper's nominal run, from the system file to what is left on disk."""

from __future__ import annotations

import csv
import hashlib
import json
import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import xarray
from helpers import Measured
from matplotlib.image import imread
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.files.writing import write_results
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import comparison, summarize
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.convergence import converge
from rovbrush.orchestrator.system.assemble import assemble

KEYS = (
    "F_z_mean", "F_x_mean", "T_brush_mean", "omega_b_mean", "pitch_rate_mean", "pitch_rate_peak", "blade_pass_hz",
    "max_deflection_ratio", "energy_residual_relative", "coupling_energy_relative", "real_time_factor", "wall_s",
    "simulated_s",
)  # fmt: skip
TABLE_3 = {"F_z": (-221.7, 0.01, "N"), "F_x": (-110.9, 0.03, "N"), "T_brush": (-16.63, 0.03, "N m"),
           "omega_b": (15.7, 0.01, "rad/s")}  # fmt: skip
FIGURES = ("fig2_mode_shapes", "fig3_normal_force", "fig4_brush_torque", "brush_speed", "pitch_rate")


@pytest.fixture(scope="module")
def summary(nominal: Run) -> dict[str, Any]:
    return summarize(nominal)


@pytest.fixture(scope="module")
def results(nominal: Run, summary: dict[str, Any], tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("results")
    write_results(nominal, folder, {**summary, "comparison": comparison(nominal, summary)})
    return folder


@pytest.mark.parametrize("name", TABLE_3)
def test_table_3_is_met(name: str, summary: dict[str, Any], measured: Measured) -> None:
    reference, bound, unit = TABLE_3[name]
    value = summary[f"{name}_mean"]
    measured(f"nominal: mean of {name} [{unit}]", value, f"{reference:g} within {100 * bound:g} %")
    assert value == pytest.approx(reference, rel=bound)


def test_compared_values_are_within_the_bounds_that_the_system_file_states(
    nominal: Run, summary: dict[str, Any]
) -> None:
    rows = {row["label"]: row for row in comparison(nominal, summary)}
    assert rows.keys() == {"F_z", "F_y", "T_brush", "omega_b", "q"}
    assert [label for label, row in rows.items() if row["within"] is not True] == ["q"]
    assert rows["q"]["reference"] == -0.17 and rows["q"]["within"] is None  # reported, not claimed


def test_summary_has_every_figure_of_merit_over_whole_turns(summary: dict[str, Any], measured: Measured) -> None:
    assert [key for key in KEYS if not math.isfinite(summary[key])] == []
    assert summary["complete"] is True and summary["simulated_s"] == 10.0
    begin, end = summary["window_s"]
    assert summary["window_turns"] >= 10 and begin >= 5.0 and end == 10.0
    turns = (end - begin) * summary["omega_b_mean"] / (2.0 * math.pi)
    assert turns == pytest.approx(summary["window_turns"], abs=1e-3)
    measured("nominal: mean pitch rate [rad/s]", summary["pitch_rate_mean"], "reported (paper -0.17)")
    measured("nominal: peak pitch rate [rad/s]", summary["pitch_rate_peak"], "reported")
    measured("nominal: real-time factor in this session", summary["real_time_factor"], "reported, see rovbrush bench")


def test_ripple_has_the_blade_pass_frequency(summary: dict[str, Any], measured: Measured) -> None:
    expected = 50.0 * summary["omega_b_mean"] / (2.0 * math.pi)
    measured("nominal: blade-pass frequency [Hz]", summary["blade_pass_hz"], f"{expected:.2f} within 0.3")
    # The window has whole turns, so that its spectrum has a line there; the next one is 0.21 Hz away.
    assert summary["blade_pass_hz"] == pytest.approx(expected, abs=0.3)


def test_deflections_stay_in_the_range_of_the_model(summary: dict[str, Any], measured: Measured) -> None:
    measured("nominal: largest deflection |y|/L", summary["max_deflection_ratio"], "0.2")
    assert 0.0 < summary["max_deflection_ratio"] <= 0.2


def test_energy_of_the_brush_is_accounted_for(signals: Signals, summary: dict[str, Any], measured: Measured) -> None:
    measured("nominal: energy residual of the brush over its work", summary["energy_residual_relative"], "1e-3")
    assert summary["energy_residual_relative"] <= 1e-3
    residual, work = (signals[f"brush.{name}"].values for name in ("energy_residual", "W_hub"))
    assert np.abs(residual).max() <= 1e-3 * abs(work[-1]) and abs(work[-1]) > 1000.0


def test_coupling_makes_and_loses_hardly_any_energy(summary: dict[str, Any], measured: Measured) -> None:
    measured("nominal: energy made by the coupling over what it carries", summary["coupling_energy_relative"], "1e-4")
    assert summary["coupling_energy_relative"] < 1e-4


def test_no_load_speed_is_that_of_the_circuit(fmus: Path, measured: Measured) -> None:
    run = require_complete(simulate(planned(assemble("no_load", {}, fmus=fmus))))
    motor = run.plan.system.components["motor"]
    start = {name: motor.fmu.variables[name].start for name in motor.fmu.names("parameter")} | motor.parameters
    K_t, K_e, R, B_m = (float(start[name]) for name in ("K_t", "K_e", "R", "B_m"))
    N_g = float(start["gear_ratio_per_stage"]) ** float(start["gear_stages"])
    expected = 12.0 * K_t / (K_e * K_t + R * B_m) / N_g
    seen = summarize(run)["omega_b_mean"]
    measured("no load: speed [rad/s]", seen, f"{expected:.4f} within 1e-3; 21.05 within 2 % (paper: 20)")
    assert seen == pytest.approx(expected, rel=1e-3)
    assert seen == pytest.approx(21.05, rel=0.02)


def test_halving_every_period_leaves_the_means_alone(fmus: Path, tmp_path: Path, measured: Measured) -> None:
    rows = {row["quantity"]: row for row in converge("nominal", tmp_path, fmus).rows}
    for name in (*TABLE_3, "pitch_rate"):
        change = rows[f"{name}_mean"]["change"]
        measured(f"convergence: change of the mean of {name} by halving every period", change, "5e-3")
        assert abs(change) <= 5e-3
    assert json.loads((tmp_path / "convergence.json").read_text())["rows"] == list(rows.values())


def test_two_runs_give_the_same_bits(nominal: Run, nominal_plan: Plan) -> None:
    again = simulate(nominal_plan)
    assert [a.tobytes() for a in nominal.tables] == [b.tobytes() for b in again.tables]


def test_interpreter_gives_the_same_bits(nominal: Run, nominal_plan: Plan) -> None:
    short = simulate(make_plan(replace(nominal_plan.system, stop=Fraction(1, 10))), interpreted=True)
    assert not short.failure
    for expected, seen in zip(nominal.tables, short.tables, strict=True):
        assert seen.tobytes() == expected[: len(seen)].tobytes()
    assert [len(table) for table in short.tables] == [201, 21, 6]


def test_netcdf_has_a_group_per_rate_with_units(results: Path, signals: Signals) -> None:
    sizes = {"every_500_us": 20001, "every_5_ms": 2001, "every_20_ms": 501}
    with h5py.File(results / "result.nc") as file:
        assert set(file) == set(sizes)
    seen = set()
    for group, rows in sizes.items():
        with xarray.open_dataset(results / "result.nc", group=group) as dataset:
            assert dataset.sizes["time"] == rows and dataset.attrs["complete"] == 1
            for name, variable in dataset.data_vars.items():
                signal = signals[str(name)]
                assert (variable.attrs["units"], variable.dims) == (signal.unit, ("time",))
                np.testing.assert_array_equal(variable.values, signal.values)
                np.testing.assert_array_equal(dataset["time"].values, signal.time)
                seen.add(name)
    assert seen == set(signals.places)
    assert signals["brush.F_z"].unit == "N" and signals["motor.omega_b"].unit == "rad/s"


def test_csv_is_complete(results: Path, signals: Signals) -> None:
    with (results / "result.csv").open(newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    assert header[0] == "time [s]" and set(header[1:]) == {signals[name].label for name in signals.places}
    assert len(rows) == 20001 and {len(row) for row in rows} == {len(header)}
    for name, stride in (("brush.F_z", 1), ("vehicle.q", 10), ("controller.saturated", 40)):
        cells = [row[header.index(signals[name].label)] for row in rows]
        assert all(cell == "" for k, cell in enumerate(cells) if k % stride)
        # ten digits are written
        np.testing.assert_allclose([float(c) for c in cells[::stride]], signals[name].values, rtol=1e-9, atol=1e-300)


def test_manifest_tells_what_was_run(results: Path, nominal_plan: Plan) -> None:
    manifest = json.loads((results / "manifest.json").read_text())
    assert manifest["complete"] is True and manifest["stop_s"] == 10.0
    assert manifest["components"].keys() == {"motor", "brush", "vehicle", "controller"}
    for name, component in nominal_plan.system.components.items():
        entry = manifest["components"][name]
        assert entry["sha256"] == hashlib.sha256(component.fmu.path.read_bytes()).hexdigest()
        assert entry["guid"] == component.fmu.description.guid
        assert entry["parameters"].keys() == set(component.fmu.names("parameter"))
        assert all(entry["parameters"][key] == value for key, value in component.parameters.items())
    assert manifest["components"]["brush"]["inputs"]["delta"] == 0.005
    assert manifest["components"]["motor"]["parameters"]["R"] == 0.08  # a default counts too
    assert {"python", "rovbrush", "numpy", "numba", "fmpy", "pythonfmu"} <= manifest["versions"].keys()
    assert any(
        "brush.F_z -> vehicle.F_z" in line and "mean" in line
        for line in (results / "plan.txt").read_text().splitlines()
    )


@pytest.mark.parametrize("name", FIGURES)
def test_figures_are_drawn(name: str, results: Path) -> None:
    path = results / f"{name}.png"
    assert path.read_bytes().startswith(b"\x89PNG\r\n")
    pixels = imread(path)[..., :3]
    assert min(pixels.shape[:2]) > 300
    assert np.mean(pixels.min(axis=2) < 0.9) > 0.01, "hardly anything but paper"


def test_summary_file_is_the_summary(results: Path, summary: dict[str, Any]) -> None:
    written = json.loads((results / "summary.json").read_text())
    assert {key: written[key] for key in KEYS} == {key: summary[key] for key in KEYS}
    assert [row["label"] for row in written["comparison"]] == ["F_z", "T_brush", "F_y", "omega_b", "q"]
