"""The examples of orchestrator/README.md run as they stand, and do what the text says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import ROOT
from markdown_it import MarkdownIt

TEXT = (ROOT / "orchestrator" / "README.md").read_text(encoding="utf-8")
BLOCKS = [token for token in MarkdownIt().parse(TEXT) if token.type == "fence" and token.info == "python"]


@pytest.fixture(scope="module")
def names(shipped: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The names that all blocks leave, run in their order in one folder."""
    found: dict[str, Any] = {"folder": tmp_path_factory.mktemp("examples")}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(found["folder"])
        patch.setenv("ROVBRUSH_FMUS", str(shipped))
        for block in BLOCKS:
            assert block.map is not None
            code = "\n" * (block.map[0] + 1) + block.content  # the line numbers of the file
            exec(compile(code, str(ROOT / "orchestrator" / "README.md"), "exec"), found)
    return found


def test_a_run_in_three_lines_is_saved_and_read_as_xarray(names: dict[str, Any]) -> None:
    assert {"result.nc", "result.csv", "summary.json", "manifest.json"} <= {
        path.name for path in (names["folder"] / "results").iterdir()
    }
    assert names["force"].attrs["units"] == "N" and float(names["force"][-1]) < -100.0
    with xarray.open_dataset(names["folder"] / "results" / "result.nc", group="every_500_us") as saved:
        assert np.array_equal(saved["brush.F_z"], names["force"])


def test_a_parameter_study_in_five_lines_shows_the_parameter(names: dict[str, Any]) -> None:
    speeds = list(names["speeds"].values())
    assert len(speeds) == 3 and speeds == sorted(speeds, reverse=True) and speeds[0] > speeds[2] + 0.1


def test_profiles_from_arrays_and_files_arrive(names: dict[str, Any]) -> None:
    ramp, profile = names["ramp"]["brush.delta"], names["profile"]["brush.delta"]
    assert float(ramp[-1]) == pytest.approx(0.005 * (0.2 - 0.00025) / 0.2, rel=1e-12)
    assert float(profile[-1]) == pytest.approx(float(ramp[-1]), rel=1e-12)
    V_in = names["profile"]["motor.V_in"]
    assert float(V_in.sel(time=0.1)) == 12.0 and float(V_in.sel(time=0.1005)) == 10.0


def test_the_observer_sees_the_period_it_asked_for(names: dict[str, Any]) -> None:
    assert [time for time, _ in names["seen"]] == [0.0, 0.05, 0.1, 0.15, 0.2]
    assert names["seen"][0][1] > names["seen"][-1][1]  # the brush is loaded


def test_the_controller_that_acts_does_better_than_none(names: dict[str, Any]) -> None:
    assert names["costs"][1.0] < names["costs"][0.0]
