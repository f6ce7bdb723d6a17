"""What a system file reports of a run is there for the points of a sweep too: balance, locals, names with spaces."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import xarray
from helpers import system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.sweep.design.axis import Axis
from rovbrush.orchestrator.studies.sweep.design.design import Design
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.studies.sweep.table import Table, write_table
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.merits import merit, written
from sweep_cases import PARTS

BALANCE = '[balance]\nsupplied = ["x.x"]\nlost = []\nstored = ["w.y"]\n'


def balanced(folder: Path, summary: str = "") -> Path:
    path = folder / "balanced.toml"
    path.write_text(system_text(PARTS, ["w.y -> x.u"], stop="10 ms", record=["w.y"]) + f"\n{summary}\n{BALANCE}")
    return path


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("summary", ["", '[summary]\ny_last = "last w.y"\n'], ids=["balance alone", "with a summary"])
def test_a_sweep_of_a_system_with_a_balance_works_and_goes_on(
    summary: str, workers: int, fmus: Path, tmp_path: Path
) -> None:
    path, options = balanced(tmp_path, summary), Options(["w.c0=1,2"], workers=workers, fmus=fmus)
    result = sweep(str(path), tmp_path / "out", options).require_all()
    alone = planned(replace(assemble(str(path), {"w.c0": 2.0}, fmus=fmus), record=("*",)))
    assert float(result["energy_balance_relative"][1]) == summarize(simulate(alone))["energy_balance_relative"]
    assert sweep(str(path), tmp_path / "out", options).cost is None, "every point is there already"


def test_a_balance_of_unknown_signals_is_refused_before_anything_is_run(fmus: Path, tmp_path: Path) -> None:
    path = balanced(tmp_path)
    path.write_text(path.read_text().replace("x.x", "x.xx"))
    with pytest.raises(InputError, match=r"balance supplied: 'x\.xx' is not recorded"):
        sweep(str(path), tmp_path / "out", Options(["w.c0=1,2"], workers=1, fmus=fmus))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("mean", "mean takes 1 signal"),
        ("mean w.y x.x", "mean takes 1 signal"),
        ("ratio w.y", "ratio takes 2 signals"),
        ("mean w.yy", r"'w\.yy' is not recorded; did you mean 'w\.y'"),
        ("mena w.y", "unknown operation 'mena'; did you mean 'mean'"),
    ],
)
def test_a_figure_of_merit_that_cannot_be_made_is_one_clear_error(
    text: str, message: str, fmus: Path, tmp_path: Path
) -> None:
    path = balanced(tmp_path, f'[summary]\nwrong = "{text}"\n')
    with pytest.raises(InputError, match=message):
        sweep(str(path), tmp_path / "out", Options(["w.c0=1,2"], workers=1, fmus=fmus))


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("mean a.speed at the shaft", ["a.speed at the shaft"]),
        ("  last   a.x ", ["a.x"]),
        ('peak "a.x y"', ["a.x y"]),
        ("ratio a.x b.y", ["a.x", "b.y"]),
        ('ratio "a.x y" "b.y z"', ["a.x y", "b.y z"]),
        ("mean", []),
    ],
)
def test_figures_of_merit_take_names_with_spaces(text: str, names: list[str]) -> None:
    operation, found = merit(text)
    assert found == names and merit(written(operation, found)) == (operation, found)


def test_names_that_netcdf_forbids_are_mapped_and_told(tmp_path: Path) -> None:
    axis, figure = Axis("t.gain/y", "1", "", (1.0, 2.0)), "y/z_last"
    records = {k: {"figures": {figure: float(k)}} for k in range(2)}
    result = write_table(Table("", Design("grid", (axis,)), {figure: ("1", "")}, records), tmp_path)
    assert result[figure].dims == ("t.gain/y",)
    with xarray.open_dataset(tmp_path / "sweep.nc") as stored:
        assert stored["y|z_last"].values.tolist() == [0.0, 1.0] and stored["y|z_last"].dims == ("t.gain|y",)
        assert stored["y|z_last"].attrs["recorded_name"] == figure
        assert stored["t.gain|y"].attrs["recorded_name"] == "t.gain/y"
