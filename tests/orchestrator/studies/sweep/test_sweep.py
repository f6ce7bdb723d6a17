"""Sweeps: every point is the run that it says, whoever computes it."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
import xarray
from helpers import rovbrush, system_text
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.results.summary.figures_of_merit import figure_units
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.sweep.design.design import make_design
from rovbrush.orchestrator.studies.sweep.file import shipped_sweeps, sweep_file
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.studies.sweep.workers.point import Job, load, needed
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.request import changes_of
from sweep_cases import design_of, plain_case


def test_a_grid_is_the_product_of_its_axes_with_the_last_one_fastest(case: Path, fmus: Path) -> None:
    design = design_of(case, fmus, "w.c0=0.48:0.72:7", "w.a=8,10,12")
    assert design.shape == (7, 3) and len(design) == 21
    assert design.axes[0].values == (0.48, 0.52, 0.56, 0.6, 0.64, 0.68, 0.72), "as a person would write them"
    assert [design.point(k)["w.a"] for k in range(4)] == [8.0, 10.0, 12.0, 8.0]
    assert design.point(20) == {"w.c0": 0.72, "w.a": 12.0}
    assert design.axes[0].unit == "m/s"
    assert design_of(case, fmus, "w.w=1:100:3:log").axes[0].values == (1.0, 10.0, 100.0)


def test_a_random_design_follows_from_its_seed_and_each_axis_from_its_name(case: Path, fmus: Path) -> None:
    one = design_of(case, fmus, "w.c0=2:3", count=50, seed=1)
    both = design_of(case, fmus, "w.a=0,5", "w.c0=2:3", count=50, seed=1)
    other = design_of(case, fmus, "w.c0=2:3", count=50, seed=2)
    assert one.axes[0].values == both.axes[1].values != other.axes[0].values
    assert all(2.0 <= float(value) <= 3.0 for value in one.axes[0].values)
    assert set(both.axes[0].values) == {0.0, 5.0}
    assert len(both) == 50 and both.shape == (50,)


def test_random_values_of_an_integer_are_whole_and_reach_both_ends(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "gain.toml"
    path.write_text(system_text({"g": ("gain", "1 ms", {"=u": 1.0})}))
    values = design_of(path, fmus, "g.count=1:3", count=60).axes[0].values
    assert set(values) == {1, 2, 3} and all(isinstance(value, int) for value in values)


def test_a_table_lists_every_point(case: Path, fmus: Path, tmp_path: Path) -> None:
    table = tmp_path / "points.csv"
    table.write_text("w.c0, w.a\n1, 2\n3, 4\n")
    design = make_design(load_system(str(case), fmus), {}, table=table)
    assert [design.point(k) for k in range(2)] == [{"w.c0": 1.0, "w.a": 2.0}, {"w.c0": 3.0, "w.a": 4.0}]
    table.write_text("w.c0,w.a\n1\n")
    with pytest.raises(InputError, match="row 2 has 1 cells"):
        make_design(load_system(str(case), fmus), {}, table=table)


@pytest.mark.parametrize("name", shipped_sweeps())
def test_every_shipped_sweep_can_be_planned(name: str, fmus: Path) -> None:
    study = sweep_file(name)
    values = tuple((key, tuple(value) if isinstance(value, list) else value) for key, value in study.values.items())
    system: System = load(Job(study.system, str(fmus), values, tuple(study.summary.items()), study.stop)).system
    design = make_design(system, study.vary, study.random, study.seed, None, study.design)
    assert len(design) >= 5 and study.description and figure_units(system)


def test_a_worker_keeps_only_the_signals_that_the_summary_reads(fmus: Path) -> None:
    plan = load(Job("nominal", str(fmus)))
    recorded = {".".join(key) for group in plan.groups for key in group.columns}
    assert {name for name in recorded if not name.startswith("coupling.")} == set(needed(plan.system))
    assert len(recorded) < 20


def test_results_are_those_of_single_runs_whatever_the_number_of_workers(fmus: Path, tmp_path: Path) -> None:
    options = Options(["brush.delta=0.004,0.005", "motor.V_in=10,12"], {}, "100 ms", fmus=fmus)
    found = {}
    for workers in (1, 2):
        out = tmp_path / str(workers)
        sweep("test_stand", out, Options(**{**vars(options), "workers": workers})).require_all()
        found[workers] = [(out / name).read_bytes() for name in ("sweep.nc", "sweep.csv")]
    assert found[1] == found[2], "bitwise"
    with xarray.open_dataset(tmp_path / "2" / "sweep.nc") as result:
        assert result.F_z_mean.dims == ("brush.delta", "motor.V_in") and result.F_z_mean.attrs["units"] == "N"
        assert result["brush.delta"].attrs["units"] == "m" and result.attrs["complete"] == 1
        values = {"brush.delta": 0.005, "motor.V_in": 10.0}
        alone = summarize(simulate(planned(assemble("test_stand", values, "100 ms", fmus))))
        for name in figure_units(planned(assemble("test_stand", {}, fmus=fmus)).system):
            assert float(result.sel(values)[name]) == alone[name], name


def test_a_random_sweep_is_indexed_by_point(case: Path, fmus: Path, tmp_path: Path) -> None:
    result = sweep(
        str(case), tmp_path / "out", Options(["w.c0=1:2"], random=4, seed=3, workers=1, fmus=fmus)
    ).require_all()
    assert result.x_last.dims == ("point",) and result.attrs["seed"] == 3
    np.testing.assert_allclose(result.x_last, 0.01 * result["w.c0"], rtol=1e-12)
    with (tmp_path / "out" / "sweep.csv").open() as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["point", "w.c0 [m/s]", "x_last [1]", "y_mean [1]", "error"]
    assert [float(row[2]) for row in rows[1:]] == result.x_last.values.tolist()


def test_a_failed_point_is_recorded_and_the_rest_goes_on(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    options = ("--fmus", fmus, "--out", out, "--workers", 2)
    assert rovbrush(monkeypatch, "sweep", plain_case(tmp_path), "--vary", "p.mode=0,1,3", *options) == 1
    assert "1 of 3 points failed" in capsys.readouterr().err
    with xarray.open_dataset(out / "sweep.nc") as result:
        assert np.isnan(result.y_last.values).tolist() == [False, True, False]
        errors = result.error.values.tolist()
    assert errors[0] == errors[2] == "" and "component p returned" in errors[1] and "100 % of %s%n gone" in errors[1]


def test_a_point_that_kills_its_process_costs_nothing_but_itself(fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with pytest.raises(RunError, match=r"1 of 4 points failed(.|\n)*process that computed this point died"):
        sweep(str(plain_case(tmp_path)), out, Options(["p.mode=0,6,3,7"], workers=2, fmus=fmus)).require_all()
    with xarray.open_dataset(out / "sweep.nc") as result:
        assert np.isnan(result.y_last.values).tolist() == [False, True, False, False]


@pytest.mark.parametrize("sampler", ["latin", "sobol"])
def test_latin_and_sobol_points_fill_every_range_evenly(sampler: str, case: Path, fmus: Path) -> None:
    """Of 64 points every 64th of a Latin hypercube's range holds one, every 8th of the Sobol sequence's holds 8."""
    design = design_of(case, fmus, "w.c0=1:3", "w.a=2:8:log", count=64, seed=5, sampler=sampler)
    again = design_of(case, fmus, "w.c0=1:3", "w.a=2:8:log", count=64, seed=5, sampler=sampler)
    other = design_of(case, fmus, "w.c0=1:3", "w.a=2:8:log", count=64, seed=6, sampler=sampler)
    assert design == again and design != other and (design.kind, design.seed) == (sampler, 5)
    c0, a = (np.array(axis.values, dtype=float) for axis in design.axes)
    for share in ((c0 - 1.0) / 2.0, np.log(a / 2.0) / np.log(4.0)):
        cells = 64 if sampler == "latin" else 8
        assert set(np.bincount((share * cells).astype(int), minlength=cells)) == {64 // cells}


def test_latin_and_sobol_points_take_lists_and_whole_numbers(fmus: Path, tmp_path: Path) -> None:
    path = plain_case(tmp_path)
    design = design_of(path, fmus, "p.mode=0:3", "p.u=1.5,2.5", count=16, sampler="sobol")
    mode, u = (axis.values for axis in design.axes)
    assert {mode.count(k) for k in range(4)} == {4} and {u.count(v) for v in (1.5, 2.5)} == {8}
    assert all(isinstance(value, int) for value in mode)


def test_an_unknown_sampler_or_one_without_a_count_is_refused(case: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match="--design sobl; did you mean 'sobol'"):
        design_of(case, fmus, "w.c0=1:3", count=4, sampler="sobl")
    with pytest.raises(InputError, match="--design latin needs the number of points"):
        design_of(case, fmus, "w.c0=1:3:4", sampler="latin")


def test_a_parameter_without_any_effect_is_named(
    case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The angular frequency w of a wave without amplitude; c0 changes what is read."""
    vary = ("--vary", "w.c0=1,2", "--vary", "w.w=1,2")
    assert rovbrush(monkeypatch, "sweep", case, *vary, "--out", tmp_path, "--fmus", fmus, "--workers", "1") == 0
    said = capsys.readouterr().out
    assert said.count("has no effect here") == 1 and "w.w has no effect here" in said


@pytest.mark.parametrize("name", ["soft", "soft.toml"])
def test_a_sweep_file_names_a_parameter_set(tmp_path: Path, fmus: Path, name: str) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text({"g": ("gain", "1 ms", {"=u": 1.0})}, stop="2 ms") + '[summary]\ny = "last g.y"\n')
    (tmp_path / "soft.toml").write_text("[g]\nk = 0.5\n")
    (tmp_path / "hard.toml").write_text("[g]\nk = 7.0\n")
    study = tmp_path / "study.toml"
    study.write_text(f'system = "case.toml"\nparameters = "{name}"\n[vary]\n"g.offset" = [0.0, 1.0]\n')
    swept = sweep(str(study), tmp_path / "out", Options(fmus=fmus, workers=1)).require_all()
    assert swept["y"].values.tolist() == [0.5, 1.5]
    over = Options(fmus=fmus, workers=1, changes=changes_of((), (), (), parameters=str(tmp_path / "hard.toml")))
    assert sweep(str(study), tmp_path / "hard", over).require_all()["y"].values.tolist() == [7.0, 8.0]


def test_a_set_that_a_sweep_file_names_must_be_there(tmp_path: Path, fmus: Path) -> None:
    study = tmp_path / "study.toml"
    study.write_text('system = "test_stand"\nparameters = "rollr"\n[vary]\n"motor.R" = [0.08, 0.09]\n')
    with pytest.raises(InputError, match=r"no parameter set 'rollr'; did you mean 'roller'"):
        sweep(str(study), tmp_path / "out", Options(fmus=fmus, workers=1))
