"""A figure of merit as it is written: an operation and the signals it is made of, `mean motor.i`, `ratio a.x b.y`."""

from __future__ import annotations

import re

OPERATIONS = {
    "mean": 1, "rms": 1, "frequency": 1, "peak": 1, "max": 1, "min": 1, "last": 1, "ratio": 2, "positive": 1,
    "share": 1,
}  # and how many signals  # fmt: skip
WORD = re.compile(r'"([^"]*)"|(\S+)')


def merit(text: object) -> tuple[str, list[str]]:
    """Operation and signals. A single signal's name may have spaces; of two such ones each stands in "quotes"."""
    operation, _, rest = str(text).strip().partition(" ")
    rest = rest.strip()
    if OPERATIONS.get(operation) == 1 and rest and not rest.startswith('"'):
        return operation, [rest]
    return operation, [quoted or word for quoted, word in WORD.findall(rest)]


def written(operation: str, names: list[str]) -> str:
    """The text of an operation and its signals."""
    return " ".join([operation, *(f'"{name}"' if len(names) > 1 else name for name in names)])
