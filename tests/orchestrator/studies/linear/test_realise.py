"""States from pulse responses: the poles of known plants are found again."""

from __future__ import annotations

import numpy as np
import pytest
from rovbrush.orchestrator.studies.linear.realise import realise, shifts
from rovbrush.orchestrator.studies.linear.statespace import Linear

T = 0.01  # s


def sampled(A: list[list[float]], B: list[float], C: list[float], D: float = 0.0) -> Linear:
    """A continuous plant with one input and one output, its input held over T."""
    matrices = [np.array(m, dtype=float) for m in (A, np.array(B)[:, None], [C], [[D]])]
    return Linear(*matrices, 0.0, ("u",), ("y",)).sampled(T)


def discrete(A: list[list[float]], B: list[float], C: list[float], D: float = 0.0) -> Linear:
    matrices = [np.array(m, dtype=float) for m in (A, np.array(B)[:, None], [C], [[D]])]
    return Linear(*matrices, T, ("u",), ("y",))


PLANTS = {
    "double integrator": sampled([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0]),
    "motor": sampled([[-800.0, -500.0], [1.0, -3.0]], [1.0, 0.0], [0.0, 1.0]),
    "oscillator of damping 0.001": sampled([[0.0, 1.0], [-400.0, -0.04]], [0.0, 1.0], [1.0, 0.0]),
    "unstable": sampled([[2.0, 0.0], [0.0, -5.0]], [1.0, 1.0], [1.0, 1.0]),
    "zero at Nyquist": discrete([[0.5, 0.0], [1.0, 0.0]], [1.0, 0.0], [1.0, 1.0]),
    "slow beside fast": discrete([[0.9999, 0.0], [0.0, 0.1]], [1.0, 1.0], [1.0, 1e-3]),
}


@pytest.mark.parametrize("name", PLANTS)
def test_poles_and_responses_of_known_plants_are_found_again(name: str) -> None:
    """Rounding of the response, 1e-16 of its size, is what is left: 1e-7 of a double pole, which takes its root."""
    plant = PLANTS[name]
    found = realise(plant.pulses(600))
    assert len(found.A) == plant.order or name == "zero at Nyquist"  # whose pole at 0 a zero at 0 takes away
    wanted = np.sort_complex(np.linalg.eigvals(plant.A))[-len(found.A) :]
    assert np.allclose(np.sort_complex(np.linalg.eigvals(found.A)), wanted, atol=1e-6 if "double" in name else 1e-9)
    again = Linear(found.A, found.B, found.C, plant.D, T, ("u",), ("y",))
    omega = np.array([1.0, 30.0, 250.0, np.pi / T])
    assert np.allclose(again.response(omega), plant.response(omega), rtol=1e-6, atol=1e-10)


def test_a_delay_is_as_many_poles_at_zero() -> None:
    pulses = np.zeros((50, 1, 1))
    pulses[4] = 3.0
    found = realise(pulses)
    assert len(found.A) == 4 and np.allclose(np.linalg.matrix_power(found.A, 4), 0.0, atol=1e-12)


def test_pure_feedthrough_has_no_states() -> None:
    pulses = np.zeros((50, 2, 1))
    pulses[0] = [[2.0], [0.0]]
    assert realise(pulses).A.shape == (0, 0)


def test_a_stated_order_is_taken_and_what_it_leaves_is_told() -> None:
    plant = PLANTS["motor"]
    found = realise(plant.pulses(600), order=1)
    assert len(found.A) == 1 and 1e-6 < found.error < 1.0


def test_units_of_inputs_and_outputs_do_not_decide_what_is_found() -> None:
    plant = PLANTS["unstable"]
    pulses = plant.pulses(300)
    both = np.concatenate([pulses, 1e9 * pulses], axis=1)
    assert np.allclose(np.linalg.eigvals(realise(both).A), np.linalg.eigvals(realise(pulses).A), atol=1e-9)


def test_shifts_begin_at_zero_rise_and_are_no_more_than_asked_for() -> None:
    for limit, most in ((5, 10), (1000, 100), (100_000, 350), (1, 1)):
        found = shifts(limit, most)
        assert found[0] == 0 and np.all(np.diff(found) > 0) and len(found) <= most and found[-1] < max(limit, 1)
