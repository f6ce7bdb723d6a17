"""Points drawn in ranges: independent random ones, a Latin hypercube, or Sobol's sequence."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence

import numpy as np

from ...errors import InputError
from ...system.model import System
from .axis import checked_axis, listed, range_of

RANDOM = "random"
SAMPLERS = (RANDOM, "latin", "sobol")


def drawn(
    system: System, vary: Mapping[str, object], count: int, seed: int, sampler: str = ""
) -> dict[str, Sequence[object]]:
    """`count` values of every name.

    Random draws of one name do not depend on what else is varied. A Latin hypercube or Sobol's sequence (scrambled; any
    count, but a power of 2 keeps it balanced) fill all ranges together, evenly.
    """
    if sampler in ("", RANDOM):
        return {name: _random(system, name, text, count, seed) for name, text in vary.items()}
    from scipy.stats import qmc

    engine = (qmc.LatinHypercube if sampler == "latin" else qmc.Sobol)(len(vary), rng=np.random.default_rng(seed))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of counts that are no power of 2
        points = engine.random(count)
    return {name: _spread(system, name, text, points[:, k]) for k, (name, text) in enumerate(vary.items())}


def _spread(system: System, name: str, text: object, shares: np.ndarray) -> Sequence[object]:
    """Values of a range, or of a list, at `shares` of it in 0 to 1, (count,)."""
    items = listed(name, text)
    if items is not None:
        return [items[int(k)] for k in np.minimum(shares * len(items), len(items) - 1)]
    low, high, log = _random_range(system, name, text)
    if _whole(system, name):
        first, last = int(low), int(high)
        return [int(k) for k in np.minimum(first + np.floor(shares * (last - first + 1)), last)]
    values = np.exp(math.log(low) + shares * math.log(high / low)) if log else low + shares * (high - low)
    return [min(max(float(value), low), high) for value in values]


def _random(system: System, name: str, text: object, count: int, seed: int) -> Sequence[object]:
    """`count` independent draws; those of one name do not depend on what else is varied."""
    generator = np.random.default_rng([seed, *name.encode()])
    items = listed(name, text)
    if items is not None:
        return [items[k] for k in generator.integers(len(items), size=count)]
    low, high, log = _random_range(system, name, text)
    if _whole(system, name):
        return [int(value) for value in generator.integers(int(low), int(high), size=count, endpoint=True)]
    values = (
        np.exp(generator.uniform(math.log(low), math.log(high), count)) if log else generator.uniform(low, high, count)
    )
    return [min(max(float(value), low), high) for value in values]


def _random_range(system: System, name: str, text: object) -> tuple[float, float, bool]:
    """Ends of a range to draw from, both allowed, and whether in equal ratios."""
    form = "low:high (or low:high:log) with --random"
    low, high, more = range_of(name, text, form)
    if more not in ([], ["log"]):
        raise InputError(f"--vary {name}={text}: write {form}; the number of points is that of --random")
    checked_axis(system, name, [low, high])
    return low, high, bool(more)


def _whole(system: System, name: str) -> bool:
    """Whether a variable takes whole numbers only."""
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu
    return bool(fmu.variables[fmu.expand(variable)[0]].type != "Real")
