"""Every run has a picture; it can be drawn again, compared, and asked for by signal and span."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Part, plan_of
from rovbrush.orchestrator.cli.commands.look import compare as compare_command
from rovbrush.orchestrator.cli.commands.look import plot
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.results.names import names_in
from rovbrush.orchestrator.results.pictures.comparison import compare, difference
from rovbrush.orchestrator.results.pictures.overview import choose
from rovbrush.orchestrator.results.pictures.rows import rows
from rovbrush.orchestrator.results.pictures.shown import shown
from rovbrush.orchestrator.results.pictures.traces import traces
from rovbrush.orchestrator.results.pictures.zoom import zoom
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.results.signals import Signal
from rovbrush.orchestrator.run.simulation import simulate

PARTS: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0}), "i": ("integrator", "2 ms", {})}
BROKEN: dict[str, Part] = {"bad": ("faulty", "5 ms", {"raise_at": 0.05}), "w": ("wave", "1 ms", {"c1": 1.0})}


def signal(name: str, time: np.ndarray, values: np.ndarray, unit: str = "N") -> Signal:
    return Signal(name, unit, "", time, values)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, fmus: Path) -> Path:
    place = tmp_path_factory.mktemp("pictures")
    for name, level in (("a", 1.0), ("b", 2.0)):
        parts = {**PARTS, "w": ("wave", "1 ms", {"c0": level})}
        Result(simulate(plan_of(place, fmus, parts, ["w.y -> i.u"], stop="0.1 s"))).save(place / name)
    Result(simulate(plan_of(place, fmus, BROKEN, stop="0.1 s"))).save(place / "broken")
    return place


@pytest.mark.parametrize("name", ["a", "broken"])
def test_every_run_has_a_picture_also_one_that_failed(folder: Path, name: str) -> None:
    assert (folder / name / "overview.png").read_bytes().startswith(b"\x89PNG")


def test_a_picture_of_a_failed_run_says_so(folder: Path) -> None:
    assert "ended early: component bad" in Result.open(folder / "broken").plot().get_supxlabel().replace("\n", " ")


def test_a_folder_is_drawn_again_by_name_and_span(folder: Path) -> None:
    figure = Result.open(folder / "a").plot("i.*", begin=0.02, end=0.06)
    assert figure.axes[0].get_ylabel().startswith("i")
    low, high = figure.axes[0].dataLim.intervalx
    assert (low, high) == pytest.approx((0.02, 0.06))
    for ending in ("png", "svg", "html"):
        plot(folder / "a", ["w.y"], out=folder / f"own.{ending}")
        assert (folder / f"own.{ending}").stat().st_size > 1000
    assert "<script src" not in (folder / "own.html").read_text(encoding="utf-8")  # it needs no network


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"signals": ["w.z"]}, r"no recorded signal 'w\.z'; did you mean 'w\.y'"),
        ({"begin": "1 s"}, "nothing was recorded after 1 s"),
        ({"begin": "2 s", "end": "1 s"}, "--to 1 s is not after --from 2 s"),
        ({"out": "result.csv"}, r"result\.csv: no \.png, \.svg, \.pdf, \.html"),
        ({"out": "nowhere/x.png"}, "there is no folder"),
    ],
)
def test_what_cannot_be_drawn_is_one_error(folder: Path, asked: dict[str, object], said: str) -> None:
    keywords = {**asked, **({"out": folder / "a" / str(asked["out"])} if "out" in asked else {})}
    with pytest.raises(InputError, match=said):
        plot(folder / "a", **keywords)  # type: ignore[arg-type]


def test_the_names_in_a_file_are_those_of_the_result_that_is_opened(folder: Path) -> None:
    opened = {str(name) for table in Result.open(folder / "a").datasets.values() for name in table.data_vars}
    found = dict(names_in(folder / "a" / "result.nc"))
    assert set(found) == opened and found["w.y"] == "signal 1"  # description and unit


def test_of_a_big_run_a_picture_shows_ten_rows_and_says_so(
    tmp_path: Path, fmus: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    parts: dict[str, Part] = {f"w{k}": ("wave", "1 ms", {"c1": 1.0}) for k in range(6)}  # two rows each
    Result(simulate(plan_of(tmp_path, fmus, parts, stop="0.01 s"))).save(tmp_path / "big")
    found = traces(Result.open(tmp_path / "big"))
    assert len(choose(found).rows) == 10 and choose(found).others == ["w5.y", "w5.Y"]
    assert not choose(found, ["*"]).left_out and not choose(found, page=True).left_out
    plot(tmp_path / "big")
    assert "drawn: the first 10 of 12 rows; what is in the others by name, such as w5.y" in capsys.readouterr().out
    plot(tmp_path / "big", ["w5.y"])
    assert "drawn:" not in capsys.readouterr().out


def test_a_folder_without_results_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"holds no result\.nc"):
        plot(tmp_path)


def test_a_comparison_has_what_differs_with_its_difference(folder: Path) -> None:
    found = compare([folder / "a", folder / "b"])
    (one,) = found.compared
    assert one.name == "w.y" and found.labels == ("a", "b")
    assert one.differences[0].values == pytest.approx(np.ones(101))
    assert compare([folder / "a", folder / "a"]).equal == ("w.y",)
    compare_command([folder / "a", folder / "b"], out=folder / "compared")
    assert {path.name for path in (folder / "compared").iterdir()} == {"compare.png", "compare.html"}
    with pytest.raises(InputError, match="two results at least"):
        compare([folder / "a"])
    with pytest.raises(InputError, match="1 labels for 2 results"):
        compare([folder / "a", folder / "b"], labels=["x"])


def test_a_difference_is_taken_on_the_times_of_the_first() -> None:
    first = signal("a", np.array([0.0, 0.5, 1.0, 2.0]), np.zeros(4))
    other = signal("b", np.array([0.0, 1.0]), np.array([1.0, 3.0]))
    assert difference(first, other).values == pytest.approx([1.0, 2.0, 3.0, np.nan], nan_ok=True)
    texts = (signal("a", np.arange(2.0), np.array(["x", "y"], object)),
             signal("b", np.arange(2.0), np.array(["x", "z"], object)))  # fmt: skip
    assert list(difference(*texts).values) == [0.0, 1.0]


def test_people_read_degrees_and_millimetres() -> None:
    assert shown("rad") == ("deg", pytest.approx(57.29578))
    assert (
        shown("m", [np.array([0.005])]) == ("mm", 1e3) and shown("m", [np.array([0.005]), np.array([2.0])]).unit == "m"
    )


def test_a_signal_too_small_for_an_axis_has_its_own() -> None:
    time = np.linspace(0.0, 1.0, 50)
    found = rows([signal("a.x", time, time), signal("a.y", time, 1e-3 * time), signal("a.z", time, 0.5 * time)])
    assert [[s.name for s in row.signals] for row in found] == [["a.x", "a.z"], ["a.y"]]


def test_a_closer_look_is_at_swings_at_events_or_where_most_changes() -> None:
    time = np.linspace(-10.0, 0.0, 20_001)  # a run may begin before 0
    quiet = signal("a.x", time, np.exp(-(time + 10.0)))
    swinging = signal("a.y", time, np.sin(2 * np.pi * 50.0 * time))
    begin, end = zoom([quiet, swinging]) or (0.0, 0.0)
    assert end - begin == pytest.approx(8 / 50.0, rel=0.05) and end <= 0.0
    begin, end = zoom([quiet]) or (0.0, 0.0)
    assert begin == -10.0 and end == pytest.approx(-9.0)
    assert zoom([quiet], [-4.0]) == pytest.approx((-4.5, -3.5))


def test_a_run_of_one_row_is_drawn_too() -> None:
    assert zoom([signal("a.x", np.zeros(1), np.ones(1))]) is None
