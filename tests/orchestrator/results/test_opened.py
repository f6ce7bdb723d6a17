"""What a run left is opened again as it was, be it whole, incomplete or streamed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import xarray
from helpers import Part, plan_of
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

PARTS: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0}), "i": ("integrator", "2 ms")}
BROKEN: dict[str, Part] = {"bad": ("faulty", "5 ms", {"raise_at": 0.05}), "w": ("wave", "1 ms", {"c1": 1.0})}


def require_same(opened: Result, result: Result) -> None:
    """The same tables, figures of merit and signals."""
    assert opened.datasets.keys() == result.datasets.keys()
    for name, table in result.datasets.items():
        xarray.testing.assert_identical(opened.datasets[name], table)
    xarray.testing.assert_identical(opened.dataset, result.dataset)
    xarray.testing.assert_identical(opened["w.y"], result["w.y"])
    assert {k: v for k, v in opened.summary.items() if k != "comparison"} == json.loads(json.dumps(result.summary))
    assert opened.comparison == result.comparison


def test_a_whole_run_is_opened_as_it_was(tmp_path: Path, fmus: Path) -> None:
    result = Result(simulate(plan_of(tmp_path, fmus, PARTS, ["w.y -> i.u"], stop="0.1 s")))
    result.save(tmp_path / "out")
    require_same(Result.open(tmp_path / "out"), result)
    require_same(Result.open(tmp_path / "out" / "result.nc"), result)
    opened = Result.open(str(tmp_path / "out"))
    assert opened.require_good() is opened and repr(opened).endswith("to 0.1 s: every_1_ms, every_2_ms>")
    with pytest.raises(InputError, match=r"no recorded signal 'w\.z'; did you mean 'w\.y'"):
        opened["w.z"]
    with pytest.raises(InputError, match="copy that folder"):
        opened.save(tmp_path / "other")


def test_an_incomplete_run_says_so_when_it_is_opened(tmp_path: Path, fmus: Path) -> None:
    result = Result(simulate(plan_of(tmp_path, fmus, BROKEN, stop="0.1 s")))
    result.save(tmp_path / "out")
    opened = Result.open(tmp_path / "out")
    require_same(opened, result)
    with pytest.raises(RunError, match="component bad") as error:
        opened.require_good()
    assert error.value.result is opened and "incomplete" in repr(opened)
    (tmp_path / "out" / "summary.json").unlink()
    again = Result.open(tmp_path / "out")
    assert again.summary == {"complete": False} and again["w.y"].size == result["w.y"].size


def test_a_streamed_run_is_opened_as_one_in_memory(tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, size in (("IN_MEMORY", 2000), ("PIECE", 700)):
        monkeypatch.setattr(recorder, name, size)
    plan = plan_of(tmp_path, fmus, PARTS, ["w.y -> i.u"], stop="0.5 s")
    with Session(plan, file=tmp_path / "rows.nc") as session:
        session.advance()
        run = session.run()
    assert not isinstance(run.recorded, list)
    Result(run).save(tmp_path / "out")
    whole = Result(simulate(plan))
    opened = Result.open(tmp_path / "out")
    for name, table in whole.datasets.items():
        xarray.testing.assert_identical(opened.datasets[name], table)


@pytest.mark.parametrize("damage", ["no folder", "empty", "text", "foreign"])
def test_what_is_no_result_is_one_error(damage: str, tmp_path: Path) -> None:
    if damage != "no folder":
        (tmp_path / "out").mkdir()
    if damage == "text":
        (tmp_path / "out" / "result.nc").write_text("no netCDF")
    if damage == "foreign":
        xarray.Dataset({"x": ("t", [1.0])}).to_netcdf(tmp_path / "out" / "result.nc", engine="h5netcdf")
    with pytest.raises(InputError, match="out"):
        Result.open(tmp_path / "out")
