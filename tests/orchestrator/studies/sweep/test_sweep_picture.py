"""A sweep draws itself: a line, a map, a scatter matrix, a tornado."""

from __future__ import annotations

import numpy as np
import pytest
import xarray
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.picture import correlation, draw_sweep, draw_tornado


def grid(*sizes: int) -> xarray.Dataset:
    names = ["a.x", "a.y", "a.z"][: len(sizes)]
    coordinates = {name: (name, np.linspace(1.0, 2.0, size)) for name, size in zip(names, sizes, strict=True)}
    values = np.arange(float(np.prod(sizes))).reshape(sizes)
    values.flat[0] = np.nan  # a point that failed
    errors = np.where(np.isnan(values), "it failed", "").astype(object)
    return xarray.Dataset(
        {"F": (names, values, {"units": "N"}), "error": (names, errors)}, coordinates, {"design": "grid"}
    )


def points(columns: dict[str, list[float]], values: list[float]) -> xarray.Dataset:
    coordinates = {name: ("point", column) for name, column in columns.items()}
    errors = np.array([""] * len(values), object)
    return xarray.Dataset(
        {"F": ("point", values, {"units": "N"}), "error": ("point", errors)}, coordinates, {"design": "list"}
    )


def test_a_grid_of_one_parameter_is_a_line_and_of_two_a_map() -> None:
    line = draw_sweep(grid(4))
    assert len(line.axes[0].lines) == 1 and line.axes[0].get_ylabel() == "F [N]"
    assert "1 of 4 points have no values: it failed" in line.get_supxlabel()
    heat = draw_sweep(grid(3, 2))
    assert heat.axes[0].get_xlabel() == "a.y" and heat.axes[0].get_ylabel() == "a.x"
    assert np.ma.count_masked(heat.axes[0].collections[0].get_array()) == 1
    assert len(draw_sweep(grid(2, 2, 3)).axes) == 3  # a figure of merit over three parameters
    assert draw_tornado(grid(3, 2)) is None


def test_other_points_are_a_scatter_matrix_and_a_tornado_of_correlations() -> None:
    x, y = np.random.default_rng(1).uniform(size=(2, 40))
    table = points({"a.x": x.tolist(), "a.y": y.tolist()}, (3.0 * x).tolist())
    assert len(draw_sweep(table).axes) == 2
    tornado = draw_tornado(table)
    assert tornado is not None and tornado.axes[0].get_yticklabels()[0].get_text() == "a.x"
    assert correlation(x, 3.0 * x) == pytest.approx(1.0) and np.isnan(correlation(x, np.ones(40)))


def test_points_that_differ_in_one_parameter_each_are_a_tornado_about_the_rest() -> None:
    table = points({"a.x": [1.0, 0.5, 1.5, 1.0, 1.0], "a.y": [2.0, 2.0, 2.0, 1.0, 3.0]}, [10.0, 9.0, 11.0, 14.0, 6.0])
    tornado = draw_tornado(table)
    assert tornado is not None
    (axis,) = tornado.axes
    assert [bar.get_width() for bar in axis.patches] == [4.0, -1.0, -4.0, 1.0]
    assert axis.get_xlabel() == "F [N]" and axis.get_yticklabels()[0].get_text() == "a.y"


def test_a_figure_of_merit_that_is_not_there_is_an_error() -> None:
    with pytest.raises(InputError, match="no figure of merit 'G' in the sweep"):
        draw_sweep(grid(4), ["G"])
