"""Time averages: the whole run at once has the bits of the general rule, also where instants come twice."""

from __future__ import annotations

import numpy as np
import pytest
from rovbrush.orchestrator.results.signals import Signal


def by_interpolation(t: np.ndarray, values: np.ndarray, begin: float, end: float) -> float:
    inside = (t > begin) & (t < end)
    x = np.concatenate([[begin], t[inside], [end]])
    return float(np.trapezoid(np.interp(x, t, values), x) / (end - begin))


@pytest.mark.parametrize("twice", [False, True])
@pytest.mark.parametrize("seed", range(5))
def test_a_mean_over_a_whole_run_has_the_bits_of_any_mean(seed: int, twice: bool) -> None:
    rng = np.random.default_rng(seed)
    t, values = np.cumsum(rng.uniform(0.001, 0.01, 200)), rng.normal(size=200)
    if twice:  # before and after an event
        t[50] = t[49]
        t[0] = t[1]
    signal = Signal("y", "1", "", t, values)
    for begin, end in ((t[0], t[-1]), (t[0], t[120]), (t[10] + 1e-4, t[-1])):
        assert signal.mean(begin, end) == by_interpolation(t, values, begin, end)


def test_a_mean_is_the_integral_over_the_time() -> None:
    t = np.linspace(2.0, 4.0, 11)
    assert Signal("y", "1", "", t, 3.0 * t).mean(2.0, 4.0) == pytest.approx(9.0)
