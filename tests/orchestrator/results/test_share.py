"""The figure of merit `share`: for what share of the window a signal is above 0."""

from __future__ import annotations

import numpy as np
import pytest
from rovbrush.orchestrator.results.signals import Signal
from rovbrush.orchestrator.results.summary.figures_of_merit import figure_of_merit

TIME = np.linspace(0.0, 10.0, 1001)


def signal(values: np.ndarray) -> Signal:
    return Signal("a.y", "m", "", TIME, values)


def test_share_is_1_only_where_the_signal_is_above_0_all_the_time() -> None:
    always = np.ones(1001)
    assert figure_of_merit("share", [signal(always)], 2.0, 8.0) == 1.0
    once = always.copy()
    once[500] = 0.0
    assert figure_of_merit("share", [signal(once)], 2.0, 8.0) < 1.0
    assert figure_of_merit("share", [signal(once)], 6.0, 8.0) == 1.0, "outside the window it does not count"


def test_share_of_a_sine_is_a_half() -> None:
    assert figure_of_merit("share", [signal(np.sin(2 * np.pi * TIME))], 0.0, 10.0) == pytest.approx(0.5, abs=0.01)
