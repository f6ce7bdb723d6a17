"""States from pulse responses: the eigensystem realisation algorithm.

J.-N. Juang and R. S. Pappa, An eigensystem realization algorithm for modal parameter identification and model
reduction, J. Guidance 8 (1985) 620-627. The blocks of its Hankel matrix may stand at any shifts: all of them where they
are few, and beyond that ever further apart, so that fast and slow modes are both seen.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

WIDEST = 700  # rows or columns of the Hankel matrix
MOST = 60  # states that are tried
ROUNDING = 1e-13  # of the largest singular value: smaller ones are none
ENOUGH = 1e-10  # of the response's size: a model that leaves less is as good as any
AS_GOOD = 3.0  # times the best: what the order is not raised for


@dataclass(frozen=True)
class Realised:
    """A, B, C of a response whose first sample is D; `singular`: of the Hankel matrix, scaled, falling.

    `error`: what the model leaves of the response, root mean square, relative to it.
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    singular: np.ndarray
    error: float


def realise(pulses: np.ndarray, order: int | None = None) -> Realised:
    """The model of Markov parameters (samples, p, m): D, C B, C A B, ...

    `order`: how many states; None: the fewest that leave of the response no more than three times what the best order
    leaves (MOST are tried), or 1e-10 of it. Outputs and inputs count alike, whatever their units.
    """
    p, m = pulses.shape[1:]
    rows, columns = _scales(pulses)
    h = pulses / rows[:, None] / columns
    if not np.any(h[1:]) or order == 0:
        size = float(np.linalg.norm(h))
        return Realised(
            np.zeros((0, 0)), np.zeros((0, m)), np.zeros((p, 0)), np.zeros(0),
            float(np.linalg.norm(h[1:])) / size if size else 0.0,
        )  # fmt: skip
    half = (len(h) - 1) // 2
    down, across = shifts(half, WIDEST // p), shifts(half, WIDEST // m)
    now, then = (_hankel(h[1 + later :], down, across) for later in (0, 1))
    left, singular, right = np.linalg.svd(now, full_matrices=False)
    known = int(np.sum(singular > ROUNDING * singular[0]))
    tried = [min(order, known)] if order is not None else list(range(1, min(known, MOST) + 1))
    middle = left[:, : tried[-1]].T @ then @ right[: tried[-1]].T
    found, errors = [], []
    for n in tried:
        root = np.sqrt(singular[:n])
        A = middle[:n, :n] / root[:, None] / root
        B, C = root[:, None] * right[:n, :m], left[:p, :n] * root
        found.append((A, B, C))
        errors.append(_error(h, A, B, C))
    allowed = max(AS_GOOD * min(errors), ENOUGH)
    best = next(k for k, error in enumerate(errors) if error <= allowed)
    A, B, C = found[best]
    return Realised(A, B * columns, C * rows[:, None], singular, errors[best])


def shifts(limit: int, most: int) -> np.ndarray:
    """At most `most` shifts from 0 to below `limit`, rising: all, or dense at first and then in equal ratios."""
    if limit <= most:
        return np.arange(max(limit, 1))
    found = np.unique(np.round(np.geomspace(1.0, limit, most)).astype(int)) - 1
    dense = most
    while len(found) > most // 2 and len(np.union1d(found, np.arange(dense))) > most:
        dense -= max(dense // 20, 1)
    return np.union1d(found, np.arange(dense))


def _scales(pulses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The size of each output's and of each input's response, 1 where there is none."""
    size = np.sqrt(np.sum(np.square(pulses), axis=0))
    rows = np.max(size, axis=1)
    rows = np.where(rows > 0.0, rows, 1.0)
    columns = np.max(size / rows[:, None], axis=0)
    return rows, np.where(columns > 0.0, columns, 1.0)


def _hankel(h: np.ndarray, down: np.ndarray, across: np.ndarray) -> np.ndarray:
    """The blocks h[down + across] as one matrix."""
    p, m = h.shape[1:]
    blocks = h[down[:, None] + across[None, :]]
    return np.ascontiguousarray(blocks.transpose(0, 2, 1, 3)).reshape(len(down) * p, len(across) * m)


def _error(h: np.ndarray, A: np.ndarray, B: np.ndarray, C: np.ndarray) -> float:
    """What a model leaves of a response, relative to it; infinite where it grows beyond all bounds."""
    left, state = 0.0, B
    with np.errstate(over="ignore", invalid="ignore"):
        for sample in h[1:]:
            left += float(np.sum(np.square(C @ state - sample)))
            state = A @ state
    size = float(np.sum(np.square(h)))
    return float(np.sqrt(left / size)) if np.isfinite(left) else np.inf
