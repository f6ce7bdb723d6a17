"""A tornado has what matters most on top, and a bar for each end of what was varied."""

from __future__ import annotations

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.results.pictures.tornado import longest_first, tornado

NAMES = ["a.R", "a.K", "a.J"]


def test_the_longest_bar_is_on_top_and_what_is_not_finite_last() -> None:
    assert longest_first([[1.0, float("nan"), -3.0], [1.5, float("nan"), 0.5]], 0.0) == [2, 0, 1]
    assert longest_first([[9.0, 12.0]], 10.0) == [1, 0]


def test_bars_go_from_the_base_to_both_ends() -> None:
    series = {"low": [9.0, 10.0, 8.0], "high": [11.5, 10.0, 11.0]}
    (axis,) = tornado("t", NAMES, series, "F [N]", base=10.0).axes
    assert [label.get_text() for label in axis.get_yticklabels()] == ["a.J", "a.R", "a.K"]
    assert [bar.get_width() for bar in axis.patches] == pytest.approx([-2.0, -1.0, 0.0, 1.0, 1.5, 0.0])
    assert axis.get_ylim()[0] > axis.get_ylim()[1]  # the first row on top


def test_indices_lie_beside_each_other_with_their_intervals_and_a_rest_is_told() -> None:
    series = {"first order": [0.1, 0.6, 0.2], "total": [0.2, 0.7, 0.2]}
    intervals = {"total": ([0.1, 0.6, 0.1], [0.3, 0.8, 0.3])}
    (axis,) = tornado("t", NAMES, series, "index", intervals=intervals, beside=True, most=2).axes
    assert len(axis.patches) == 4 and len(axis.collections) == 1 and axis.get_ylabel() == "the first 2 of 3"


def test_lengths_that_differ_are_an_error() -> None:
    with pytest.raises(InputError, match="t: low has another length than the 3 labels"):
        tornado("t", NAMES, {"low": [1.0]}, "F [N]")
    with pytest.raises(InputError, match="nothing to draw"):
        tornado("t", [], {}, "F [N]")
