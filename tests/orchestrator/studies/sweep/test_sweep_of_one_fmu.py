"""A sweep of an FMU alone: its variables are named with the FMU's name in front or without, and mean the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.design.design import make_design
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp
from sweep_cases import PARTS

POINTS = {"alone": "c0\n1\n2\n", "in full": "wave.c0\n1\n2\n"}


@pytest.mark.parametrize("name", ["c0", "wave.c0"])
@pytest.mark.parametrize("count", [0, 3], ids=["grid", "random"])
def test_a_varied_parameter_has_its_full_name(name: str, count: int, fmus: Path) -> None:
    system = load_system(str(fmus / "wave.fmu"), fmus)
    design = make_design(system, {name: "0.5:1.5" if count else "0.5:1.5:3"}, count)
    assert [axis.name for axis in design.axes] == ["wave.c0"] and len(design) == 3


@pytest.mark.parametrize("text", POINTS.values(), ids=POINTS)
def test_so_has_a_column_of_points(text: str, fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text(text)
    design = make_design(load_system(str(fmus / "wave.fmu"), fmus), {}, table=tmp_path / "p.csv")
    assert [(axis.name, axis.values) for axis in design.axes] == [("wave.c0", (1.0, 2.0))]


def test_one_parameter_by_two_names_is_an_error(fmus: Path, tmp_path: Path) -> None:
    system = load_system(str(fmus / "wave.fmu"), fmus)
    with pytest.raises(InputError, match="varied twice"):
        make_design(system, {"c0": "1,2", "wave.c0": "1,2"})
    (tmp_path / "p.csv").write_text("c0,wave.c0\n1,2\n")
    with pytest.raises(InputError, match="two columns"):
        make_design(system, {}, table=tmp_path / "p.csv")


def test_a_name_that_begins_like_none_of_its_variables_is_one_clear_error(fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text("n.m\n1\n")
    with pytest.raises(InputError, match=r"no component 'n' in 'n\.m'"):
        make_design(load_system(str(fmus / "wave.fmu"), fmus), {}, table=tmp_path / "p.csv")


def test_a_sweep_of_an_ssp_of_another_tool_gathers_the_last_value_of_every_output(fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(system_text(PARTS, ["w.y -> x.u"], stop="10 ms"))
    write_ssp(load_system(str(tmp_path / "two.toml"), fmus), tmp_path / "two.ssp")
    result = sweep(str(tmp_path / "two.ssp"), tmp_path, Options(["w.c0=1,2"], workers=1)).require_all()
    assert {"w.y_last", "x.x_last"} <= set(map(str, result.data_vars))
