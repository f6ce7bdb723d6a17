"""Points drawn in ranges: independent random ones, a Latin hypercube, or Sobol's sequence."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ....errors import InputError
from ....system.model import System
from .axis import Range, checked_axis, listed, range_of, spaced
from .blocks import BLOCKS, block_shares

RANDOM = "random"
SAMPLERS = (RANDOM, "latin", "sobol")


def drawn(
    system: System, vary: Mapping[str, object], count: int, seed: int, sampler: str = ""
) -> dict[str, Sequence[object]]:
    """`count` values of every name; of BLOCKS the values of `count` blocks.

    Random draws of one name do not depend on what else is varied. A Latin hypercube or Sobol's sequence (scrambled; any
    count, but a power of 2 keeps it balanced) fill all ranges together, evenly.
    """
    if sampler in ("", RANDOM):
        return {name: _random(system, name, text, count, seed) for name, text in vary.items()}
    if sampler in BLOCKS:
        shares = block_shares(sampler, len(vary), count, seed)
        return {name: choices(system, name, text).at(shares[:, k]) for k, (name, text) in enumerate(vary.items())}
    from scipy.stats import qmc

    engine = (qmc.LatinHypercube if sampler == "latin" else qmc.Sobol)(len(vary), rng=np.random.default_rng(seed))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of counts that are no power of 2
        points = engine.random(count)
    return {name: _spread(system, name, text, points[:, k]) for k, (name, text) in enumerate(vary.items())}


def _spread(system: System, name: str, text: object, shares: np.ndarray) -> Sequence[object]:
    """Values of a range, or of a list, at `shares` of it in 0 to 1, (count,)."""
    items = listed(system, name, text)
    if items is not None:
        return Choices(items).at(shares)
    return _random_range(system, name, text).at(shares)


@dataclass(frozen=True)
class Choices:
    """A list of values, taken in its order."""

    items: Sequence[object]

    def at(self, shares: np.ndarray) -> list[object]:
        """The values at `shares` from 0 to 1 of the list, (count,)."""
        return [self.items[int(k)] for k in np.minimum(shares * len(self.items), len(self.items) - 1)]


def choices(system: System, name: str, text: object) -> Range | Choices:
    """What a study chooses from: a range `low:high` or `low:high:log`, a list, or a grid `low:high:count` as a list.

    Raises InputError for a single value too, with which nothing varies.
    """
    items = listed(system, name, text)
    if items is None and len([part for part in str(text).split(":") if part.strip() != "log"]) > 2:
        items = spaced(name, text, range_of(system, name, text, "low:high:count", grid=True))
    if items is None:
        ends = range_of(system, name, text, "low:high, low:high:log or a list a,b,c", grid=False)
        checked_axis(system, name, [ends.low, ends.high])
        return ends
    if len({str(item) for item in items}) < len(items):
        raise InputError(f"--vary {name}={text}: a value is there twice")
    if len(items) < 2:
        raise InputError(f"--vary {name}={text}: a single value does not vary; write low:high or a list a,b,c")
    return Choices(checked_axis(system, name, items).values)


def _random(system: System, name: str, text: object, count: int, seed: int) -> Sequence[object]:
    """`count` independent draws; those of one name do not depend on what else is varied."""
    generator = np.random.default_rng([seed, *name.encode()])
    items = listed(system, name, text)
    if items is not None:
        return [items[k] for k in generator.integers(len(items), size=count)]
    ends = _random_range(system, name, text)
    if ends.items:
        return [ends.items[k] for k in generator.integers(len(ends.items), size=count)]
    low, high = ends.low, ends.high
    if isinstance(low, int) and isinstance(high, int) and not ends.log:  # exact to 64 bits
        above = generator.integers(high - low, size=count, endpoint=True, dtype=np.uint64)
        return [low + k for k in above.tolist()]
    if ends.whole:
        return ends.at(generator.uniform(0.0, 1.0, count))
    values = (
        np.exp(generator.uniform(math.log(low), math.log(high), count))
        if ends.log
        else generator.uniform(low, high, count)
    )
    return [min(max(float(value), low), high) for value in values]


def _random_range(system: System, name: str, text: object) -> Range:
    """A range to draw from, with both of its ends allowed."""
    ends = range_of(system, name, text, "low:high (or low:high:log) with --random", grid=False)
    checked_axis(system, name, [ends.low, ends.high])
    return ends
