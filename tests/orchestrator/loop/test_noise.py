"""Noise by a counter: the published generator, the same bits compiled and interpreted, the moments of a Gaussian."""

from __future__ import annotations

import numpy as np
import pytest
from numba import njit
from rovbrush.orchestrator.loop.machine import entry
from rovbrush.orchestrator.loop.noise import gaussian, philox

entry.told_to_compiler()  # of what is compiled here beside the loop

ONES, PI = (0xFFFFFFFF,) * 6, (0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344, 0xA4093822, 0x299F31D0)
KNOWN = [  # the known answers of Random123 for philox4x32-10
    ((0,) * 6, (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)),
    (ONES, (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD)),
    (PI, (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1)),
]


@pytest.mark.parametrize(("counter_and_key", "words"), KNOWN)
def test_the_words_are_those_of_philox4x32_10(counter_and_key: tuple[int, ...], words: tuple[int, ...]) -> None:
    assert philox(*counter_and_key) == words


@njit
def drawn(seed: int, stream: int, count: int) -> np.ndarray:
    found = np.zeros(count)
    for k in range(count):
        found[k] = gaussian(seed, stream, k - count // 2)
    return found


@pytest.mark.parametrize(("seed", "stream"), [(0, 0), (7, -(2**63)), (2**63 - 1, 2**63 - 1), (3, -1)])
def test_compiled_and_interpreted_draw_the_same_bits(seed: int, stream: int) -> None:
    plain = [gaussian(np.int64(seed), np.int64(stream), np.int64(k - 500)) for k in range(1000)]
    assert plain == drawn(seed, stream, 1000).tolist()


def test_draws_are_gaussian_and_independent() -> None:
    n = 200_000
    x = drawn(1, 2, n)
    moments = [np.mean(x), np.mean(x**2) - 1.0, np.mean(x**3), np.mean(x**4) - 3.0]
    deviations = [np.sqrt(v / n) for v in (1.0, 2.0, 15.0, 96.0)]
    assert all(abs(m) < 5.0 * d for m, d in zip(moments, deviations, strict=True))
    assert abs(np.mean(x[1:] * x[:-1])) < 5.0 / np.sqrt(n)
    assert abs(np.mean(x * drawn(1, 3, n))) < 5.0 / np.sqrt(n)
    assert abs(np.mean(x * drawn(2, 2, n))) < 5.0 / np.sqrt(n)
