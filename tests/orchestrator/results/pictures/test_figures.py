"""Figures show what there is: a ripple is a band about its mean, and one signal does not hide another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.paper.lab import Lab
from rovbrush.orchestrator.results.pictures.bands import COLUMNS, READABLE, SAMPLES, sliding_mean
from rovbrush.orchestrator.results.pictures.canvas import legend_above, new_figure
from rovbrush.orchestrator.results.pictures.figures import figure
from rovbrush.orchestrator.results.pictures.lines import STYLES, draw


@pytest.mark.parametrize("samples", [50, SAMPLES * COLUMNS - 1, SAMPLES * COLUMNS, 100_003])
def test_a_ripple_too_fast_to_be_seen_is_a_band_about_its_mean(samples: int) -> None:
    time = np.linspace(0.0, 10.0, samples)
    _, (axis,) = new_figure("ripple")
    draw(axis, time, 3.0 + np.sin(2 * np.pi * 50.1 * time), "a.y", "-")
    (line,) = axis.lines
    if samples == 50:  # so few that each can be seen
        assert len(line.get_xdata()) == samples and not axis.collections
        return
    assert len(line.get_xdata()) == COLUMNS
    (band,) = axis.collections
    if samples > 20 * COLUMNS:
        low, high = band.get_datalim(axis.transData).intervaly
        assert (low, high) == (pytest.approx(2.0, abs=0.01), pytest.approx(4.0, abs=0.01))
    inner = np.asarray(line.get_ydata())[10:-10]
    assert np.max(np.abs(inner - 3.0)) <= 0.1  # the mean over whole swings; 0.4 for a column alone
    assert np.max(np.abs(np.asarray(line.get_ydata()) - 3.0)) <= 1.0


@pytest.mark.parametrize("swings", [COLUMNS // READABLE // 2, COLUMNS // READABLE * 2])
def test_swings_with_room_enough_are_a_line_and_faster_ones_a_band(swings: int) -> None:
    time = np.linspace(-1.0, 0.0, 2000)
    _, (axis,) = new_figure("ripple")
    draw(axis, time, np.sin(2 * np.pi * swings * time), "a.y", "-")
    assert bool(axis.collections) == (swings > COLUMNS // READABLE)


def test_a_sliding_mean_is_the_integral_over_its_width() -> None:
    time = np.array([0.0, 0.1, 0.4, 1.0])  # steps of any length
    mean = sliding_mean(time, 2.0 * time, np.array([0.0, 0.3, 0.5, 1.0]), 0.4)
    assert mean == pytest.approx([0.0, 0.6, 1.0, 2.0], abs=1e-8)


@pytest.mark.parametrize("values", [np.array([False, True, True, False]), np.array([1, 4, 4, 2])])
def test_what_is_no_real_number_is_drawn_as_steps(values: np.ndarray) -> None:
    _, (axis,) = new_figure("steps")
    draw(axis, np.arange(4.0), values, "a.n", "-")
    assert axis.lines[0].get_drawstyle() == "steps-post"


def test_texts_are_steps_that_the_axis_names() -> None:
    _, (axis,) = new_figure("texts")
    draw(axis, np.arange(3.0), np.array(["off", "on", "off"], dtype=object), "a.mode", "-")
    assert axis.lines[0].get_drawstyle() == "steps-post" and list(axis.lines[0].get_ydata()) == [0, 1, 0]
    assert [label.get_text() for label in axis.get_yticklabels()] == ["off", "on"]


def test_values_that_are_not_finite_are_gaps() -> None:
    _, (axis,) = new_figure("gaps")
    draw(axis, np.arange(4.0), np.array([0.0, np.nan, 1.0, np.inf]), "a.y", "-")
    assert np.isnan(axis.lines[0].get_ydata()[1])


def test_a_legend_lies_above_its_axis() -> None:
    figure, (axis,) = new_figure("legend")
    for k in range(8):
        draw(axis, np.arange(3.0), np.arange(3.0) + k, f"component.signal_{k}", STYLES[k % len(STYLES)])
    legend_above(axis)
    figure.canvas.draw()
    assert axis.get_legend().get_window_extent().y0 >= axis.get_window_extent().y1


def test_signals_of_one_axis_have_styles_of_their_own() -> None:
    assert len(set(STYLES)) == len(STYLES) >= 4


def test_a_figure_says_what_its_parameter_set_says_of_itself(fmus: Path) -> None:
    entry = {"file": "forces.png", "title": "Forces", "signals": ["brush.F_z"]}
    with_a_set, without = (Lab(fmus).case(name, stop="0.02 s").run for name in ("test_stand", "constant_speed"))
    drawn = figure(with_a_set, entry)
    assert drawn is not None and drawn.get_supxlabel().startswith("parameters: paper (the paper's Table 3; not a build")
    plain = figure(without, entry)
    assert plain is not None and plain.get_supxlabel() == ""
