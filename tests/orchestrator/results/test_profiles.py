"""Arrays along another: a table and a figure of them as they are at the end of a run, or at instants."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import column
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.results.files.writing import Written, write_products
from rovbrush.orchestrator.results.pictures.figures import figure
from rovbrush.orchestrator.results.profiles import elements, profiles
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.recorded import select_recorded
from rovbrush.orchestrator.system.file.shipped import SYSTEMS

ENTRY = """
[[figures]]
file = "modes.png"
table = "modes.csv"
title = "Share of the modes"
along = "brush.lambda_r"
signals = ["brush.kinetic_fraction"]
at = [0.005, 0.01, 7.0]
"""
WRONG = {
    "unknown array": (
        "brush.kinetic_fraction",
        "brush.kinetic_friction",
        "no array 'brush.kinetic_friction'; did you mean",
    ),
    "scalar": ('"brush.kinetic_fraction"', '"brush.F_z"', "there is no array 'brush.F_z'"),
    "unknown component": ('along = "brush.', 'along = "brosh.', "there is no array 'brosh.lambda_r'"),
    "table outside the results": ('"modes.csv"', '"../modes.csv"', "a plain name that ends in .csv"),
    "table over the results": (
        '"modes.csv"',
        '"Result.csv"',
        "table = 'Result.csv' would overwrite a file of the results",
    ),
    "table over a rate": ('"modes.csv"', '"every_500_us.csv"', "would overwrite a file of --csv-per-rate"),
    "table over a recording": ('"modes.csv"', '"motor_in.csv"', "would overwrite a file of --record-boundary"),
    "figure over the overview": ('"modes.png"', '"overview.png"', "file = 'overview.png' would overwrite"),
    "figure over another": ('"modes.png"', '"forces.png"', "would overwrite that of another figure or table"),
    "table of another kind": ('"modes.csv"', '"modes.txt"', "a plain name that ends in .csv"),
    "axis of time": ("at = ", "from = 0.0\nat = ", "from is of a figure over time"),
    "instants without an array": ('along = "brush.lambda_r"\n', "", "at goes with `along`"),
    "a kind of its own": ("at = ", 'kind = "mode_shapes"\nat = ', "along goes with signals"),
    "no signals": ('["brush.kinetic_fraction"]', "[]", "signals must be a list of names"),
    "instant that is no number": ("at = [0.005", 'at = ["5 ms"', "at must be a list, each entry a number"),
}


def written(tmp_path: Path, text: str) -> str:
    path = tmp_path / "case.toml"
    path.write_text((SYSTEMS / "test_stand.toml").read_text(encoding="utf-8") + text, encoding="utf-8")
    return str(path)


@pytest.fixture(scope="module")
def run(fmus: Path, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Twenty milliseconds of the test stand."""
    return simulate(planned(assemble(written(tmp_path_factory.mktemp("along"), ENTRY), {}, "0.02 s", fmus)))


def entry_of(run: Run, **changes: object) -> dict[str, object]:
    return {**run.plan.system.reporting["figures"][-1], **changes}


def test_vectors_are_those_of_the_row_at_an_instant(run: Run) -> None:
    found = profiles(run, entry_of(run))
    assert found is not None
    assert [vector.when for vector in found.vectors] == ["at 0.005 s", "at 0.01 s"]  # the run ends before 7 s
    for vector, instant in zip(found.vectors, (0.005, 0.01), strict=True):
        expected = []
        for k in range(1, 7):
            t, share = column(run, f"brush.kinetic_fraction[{k}]")
            expected.append(share[np.argmin(np.abs(t - instant))])
        np.testing.assert_array_equal(vector.values, expected)
    assert found.along.values.tolist() == [run.calculated[f"brush.lambda_r[{k}]"] for k in range(1, 7)]


def test_without_instants_they_are_those_of_the_end(run: Run) -> None:
    entry = entry_of(run)
    del entry["at"]
    found = profiles(run, entry)
    assert found is not None and len(found.vectors) == 1
    assert found.vectors[0].values[0] == column(run, "brush.kinetic_fraction[1]")[1][-1]


def test_outputs_may_be_what_vectors_lie_along(run: Run) -> None:
    found = profiles(run, entry_of(run, along="brush.kinetic_fraction", at=[0.01]))
    assert found is not None
    np.testing.assert_array_equal(found.along.values, column_of(run, -1))
    np.testing.assert_array_equal(found.vectors[0].values, column_of(run, 20))


def column_of(run: Run, row: int) -> list[float]:
    return [column(run, f"brush.kinetic_fraction[{k}]")[1][row] for k in range(1, 7)]


def test_table_and_figure_are_among_the_results(run: Run, tmp_path: Path) -> None:
    results = Written(tmp_path)
    write_products(run, results)
    assert not results.failures
    names = [path.name for path in results.paths]
    assert names.index("modes.csv") < names.index("modes.png")
    lines = (tmp_path / "modes.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == ("brush.lambda_r [1],brush.kinetic_fraction [1] at 0.005 s,brush.kinetic_fraction [1] at 0.01 s")
    assert len(lines) == 7 and lines[1].startswith("1.875104069,")


def test_a_figure_has_an_axis_per_signal_and_a_line_per_instant(run: Run) -> None:
    drawn = figure(run, entry_of(run))
    assert drawn is not None
    (axis,) = drawn.axes
    assert [line.get_label() for line in axis.lines] == ["at 0.005 s", "at 0.01 s"]
    assert axis.get_xlabel() == "brush.lambda_r [1]" and axis.get_ylabel() == "brush.kinetic_fraction [1]"


def test_what_is_not_recorded_is_not_drawn(tmp_path: Path, fmus: Path) -> None:
    system = assemble(written(tmp_path, ENTRY), {}, "0.02 s", fmus)
    files = [[e["file"] for e in select_recorded(system, [p]).reporting["figures"]] for p in ("motor.i", "brush.kin*")]
    assert "modes.png" not in files[0] and "modes.png" in files[1]


@pytest.mark.parametrize("slip", WRONG)
def test_a_slip_is_found_before_the_run(slip: str, tmp_path: Path, fmus: Path) -> None:
    old, new, hint = WRONG[slip]
    assert old in ENTRY
    with pytest.raises(InputError) as error:
        planned(assemble(written(tmp_path, ENTRY.replace(old, new)), {}, fmus=fmus))
    assert hint in str(error.value)


def test_arrays_of_other_lengths_are_refused(tmp_path: Path, fmus: Path) -> None:
    text = (SYSTEMS / "station_keeping.toml").read_text(encoding="utf-8")
    path = tmp_path / "case.toml"
    more = '\n[[figures]]\nfile = "a.png"\ntitle = "a"\nalong = "vehicle.thrust"\nsignals = ["vehicle.quat"]\n'
    path.write_text(text + more, encoding="utf-8")
    with pytest.raises(InputError, match=r"vehicle\.quat has 4 elements, and vehicle\.thrust has 8"):
        planned(assemble(str(path), {}, fmus=fmus))


def test_instants_before_zero_are_rows_of_their_own(fmus: Path, tmp_path: Path) -> None:
    text = ENTRY.replace("at = [0.005, 0.01, 7.0]", "at = [-0.005]")
    plan = planned(assemble(written(tmp_path, text), {}, "0.01 s", fmus, start="-0.01 s"))
    run = simulate(plan)
    found = profiles(run, entry_of(run, at=[-0.005]))
    assert found is not None
    time = Signals(run)["brush.kinetic_fraction[1]"].time
    (row,) = np.flatnonzero(np.abs(time + 0.005) < 1e-9)  # the instant itself, not the row before it
    expected = [Signals(run)[name].values[row] for name in elements(run.plan.system, "brush.kinetic_fraction")]
    assert found.vectors[0].values == pytest.approx(expected, rel=0.0, abs=0.0)
