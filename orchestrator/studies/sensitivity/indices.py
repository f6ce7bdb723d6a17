"""Indices of one figure of merit from its values in blocks of points, with bootstrapped intervals (SALib)."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np

from ..sweep.design.blocks import LEVELS, block_size, problem

CONFIDENCE = 0.95
RESAMPLES = 200  # of whole blocks
FEWEST = 4  # blocks from which an interval can be estimated
MOST_LOST = 0.25  # of the blocks: beyond it what is left is no picture of the ranges any more
ROUNDING = 1e-12  # relative: a figure that varies by less does not change
NEGLIGIBLE = 0.05  # of the variance


@dataclass(frozen=True)
class Estimate:
    """A number with the half-width of its 95 % interval; without one where it is NaN."""

    value: float
    half: float = math.nan

    @property
    def low(self) -> float:
        return self.value - self.half

    @property
    def high(self) -> float:
        return self.value + self.half


@dataclass(frozen=True)
class Indices:
    """What the parameters do to one figure: estimates by index (`S1`, `ST`; `mu_star`, `mu`, `sigma`), (parameters,).

    `second`: the part of the variance of two together, by their positions. Where nothing could be estimated,
    `without` says why.
    """

    figure: str
    unit: str
    blocks: int  # that were complete
    lost: int  # whose points failed, or gave no number for this figure
    of: dict[str, list[Estimate]]
    second: dict[tuple[int, int], Estimate]
    without: str = ""

    @property
    def leading(self) -> list[Estimate]:
        """The index by which parameters are ordered."""
        return self.of.get("ST") or self.of.get("mu_star") or []

    def order(self) -> list[int]:
        """The parameters, what matters most first."""
        return sorted(range(len(self.leading)), key=lambda k: -self.leading[k].value)

    def undecided(self) -> list[int]:
        """The parameters of which it is open whether they matter: the interval holds 0, and more than a trifle."""
        scale = 1.0 if "ST" in self.of else max((e.value for e in self.leading), default=0.0)
        return [k for k, e in enumerate(self.leading) if 0.0 < e.value < e.half and e.high > NEGLIGIBLE * scale]


def estimated(kind: str, figure: str, unit: str, values: np.ndarray, shares: np.ndarray, seed: int) -> Indices:
    """The indices of a figure: `values` (points,), NaN where there is none, at `shares` (points, parameters).

    The bootstrap is drawn by `seed`. Blocks that are not complete are left out whole.
    """
    parameters = shares.shape[1]
    size = block_size(kind, parameters)
    table = values.reshape(-1, size)
    complete = np.all(np.isfinite(table), axis=1)
    count, lost = int(complete.sum()), int((~complete).sum())
    found = table[complete]
    without = ""
    if count < FEWEST or lost > MOST_LOST * len(table):
        without = f"{lost} of {len(table)} blocks of points are not complete, too many for an estimate"
    elif np.ptp(found) <= ROUNDING * np.max(np.abs(found)):
        without = f"it never changes: {found[0, 0]:.6g} at every point"
    if without:
        return Indices(figure, unit, count, lost, {}, {}, without)
    at = shares.reshape(-1, size, parameters)[complete].reshape(-1, parameters)
    estimate = _morris if kind == "morris" else _sobol
    of, second = estimate(found.ravel(), at, parameters, seed, kind == "saltelli2")
    return Indices(figure, unit, count, lost, of, second)


def without_effect(kind: str, columns: list[np.ndarray], shares: np.ndarray) -> list[int]:
    """The parameters that change no figure anywhere, to the last bit; `columns`: the values of each figure, (points,).

    Pairs of points of which one has no number say nothing; where no pair has, no parameter is named.
    """
    parameters, size = shares.shape[1], block_size(kind, shares.shape[1])
    first, second = _pairs(kind, shares.reshape(-1, size, parameters))
    compared, changed = np.zeros(parameters, dtype=bool), np.zeros(parameters, dtype=bool)
    for column in columns:
        table = column.reshape(-1, size)
        one, other = (np.take_along_axis(table, at, axis=1) for at in (first, second))
        known = np.isfinite(one) & np.isfinite(other)
        compared |= known.any(axis=0)
        changed |= (known & (one != other)).any(axis=0)
    return [int(k) for k in np.flatnonzero(compared & ~changed)]


def _pairs(kind: str, blocks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two points of each block that differ in a parameter alone, (blocks, parameters)."""
    count, _, parameters = blocks.shape
    if kind == "morris":
        moved = np.argmax(blocks[:, 1:] != blocks[:, :-1], axis=2)  # the parameter of each step
        step = np.argsort(moved, axis=1)
        return step, step + 1
    own = np.broadcast_to(np.arange(1, parameters + 1), (count, parameters))
    return np.zeros_like(own), own


def _sobol(
    values: np.ndarray, _shares: np.ndarray, parameters: int, seed: int, second: bool
) -> tuple[dict[str, list[Estimate]], dict[tuple[int, int], Estimate]]:
    from SALib.analyze import sobol

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of resamples in which nothing changes
        found = sobol.analyze(
            problem(parameters), values, second, RESAMPLES, CONFIDENCE, seed=seed + 1
        )  # 0 is no seed there
    of = {
        name: [Estimate(float(v), float(h)) for v, h in zip(found[name], found[f"{name}_conf"], strict=True)]
        for name in ("S1", "ST")
    }
    pairs = [(j, k) for j in range(parameters) for k in range(j + 1, parameters)] if second else []
    return of, {(j, k): Estimate(float(found["S2"][j, k]), float(found["S2_conf"][j, k])) for j, k in pairs}


def _morris(
    values: np.ndarray, shares: np.ndarray, parameters: int, seed: int, _second: bool
) -> tuple[dict[str, list[Estimate]], dict[tuple[int, int], Estimate]]:
    from SALib.analyze import morris

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = morris.analyze(
            problem(parameters), shares, values, num_resamples=RESAMPLES, conf_level=CONFIDENCE, num_levels=LEVELS,
            seed=seed + 1,
        )  # fmt: skip
    of = {
        "mu_star": [Estimate(float(v), float(h)) for v, h in zip(found["mu_star"], found["mu_star_conf"], strict=True)],
        "mu": [Estimate(float(v)) for v in found["mu"]],
        "sigma": [Estimate(float(v)) for v in found["sigma"]],
    }
    return of, {}
