"""Blocks of points that belong together, as the estimators of a sensitivity study need them (SALib).

A `saltelli` block is a point A, the points that take one coordinate from another point B, and B (Saltelli et al. 2010,
doi:10.1016/j.cpc.2009.09.018); `saltelli2` has those that take one coordinate from A too (Saltelli 2002,
doi:10.1016/S0010-4655(02)00280-1). A `morris` block is a path that changes one coordinate at a time, between LEVELS of
each range (Morris 1991, doi:10.1080/00401706.1991.10484804).
"""

from __future__ import annotations

import warnings

import numpy as np

from ....errors import InputError

BLOCKS = ("saltelli", "saltelli2", "morris")
LEVELS = 4  # of each range on which the paths of Morris walk, both ends among them


def block_size(kind: str, parameters: int) -> int:
    """The number of points in a block."""
    return {"saltelli": parameters + 2, "saltelli2": 2 * parameters + 2, "morris": parameters + 1}[kind]


def problem(parameters: int) -> dict[str, object]:
    """The unit cube, as SALib describes it."""
    return {
        "num_vars": parameters,
        "names": [f"x{k}" for k in range(parameters)],
        "bounds": [[0.0, 1.0]] * parameters,
    }


def require_salib() -> None:
    """Raise InputError, with what to type, where SALib is not installed."""
    try:
        import SALib  # noqa: F401
    except ImportError:
        raise InputError(
            "a sensitivity study needs SALib; install it with: pip install 'rovbrush[sensitivity]'"
        ) from None


def block_shares(kind: str, parameters: int, count: int, seed: int) -> np.ndarray:
    """The points of `count` blocks in the unit cube, (count * block_size, parameters)."""
    require_salib()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of counts that are no power of 2, and of names that SciPy has changed
        if kind == "morris":
            from SALib.sample import morris

            found = morris.sample(problem(parameters), count, num_levels=LEVELS, seed=seed)
        else:
            from SALib.sample import sobol

            found = sobol.sample(problem(parameters), count, calc_second_order=kind == "saltelli2", seed=seed)
    shares: np.ndarray = np.clip(np.asarray(found, dtype=float), 0.0, 1.0)
    return shares
