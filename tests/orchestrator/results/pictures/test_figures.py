"""Figures show what there is: a ripple is a band about its mean, and one signal does not hide another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.paper.lab import Lab
from rovbrush.orchestrator.results.pictures.canvas import new_figure
from rovbrush.orchestrator.results.pictures.figures import figure
from rovbrush.orchestrator.results.pictures.lines import COLUMNS, SAMPLES, STYLES, draw


@pytest.mark.parametrize("samples", [50, SAMPLES * COLUMNS - 1, SAMPLES * COLUMNS, 100_003])
def test_a_ripple_too_fast_to_be_seen_is_a_band_about_its_mean(samples: int) -> None:
    time = np.linspace(0.0, 10.0, samples)
    _, (axis,) = new_figure("ripple")
    draw(axis, time, 3.0 + np.sin(2 * np.pi * 50.1 * time), "a.y", "-")
    (line,) = axis.lines
    if samples < SAMPLES * COLUMNS:
        assert len(line.get_xdata()) == samples and not axis.collections
        return
    assert len(line.get_xdata()) == COLUMNS
    (band,) = axis.collections
    if samples > 20 * COLUMNS:
        low, high = band.get_datalim(axis.transData).intervaly
        assert (low, high) == (pytest.approx(2.0, abs=0.01), pytest.approx(4.0, abs=0.01))
    assert np.max(np.abs(np.asarray(line.get_ydata()) - 3.0)) <= 1.0


def test_signals_of_one_axis_have_styles_of_their_own() -> None:
    assert len(set(STYLES)) == len(STYLES) >= 4


def test_a_figure_says_what_its_parameter_set_says_of_itself(fmus: Path) -> None:
    entry = {"file": "forces.png", "title": "Forces", "signals": ["brush.F_z"]}
    with_a_set, without = (Lab(fmus).case(name, stop="0.02 s").run for name in ("test_stand", "constant_speed"))
    drawn = figure(with_a_set, entry)
    assert drawn is not None and drawn.get_supxlabel().startswith("parameters: paper (the paper's Table 3; not a build")
    plain = figure(without, entry)
    assert plain is not None and plain.get_supxlabel() == ""
