"""What stands beside an arrow: as many names as fit, and how many more there are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .blocks import Flow
from .ink import shortened

LONGEST = 20  # characters of a line of names
SHORTEST = 16  # of one in a diagram of many blocks
MANY = 8  # blocks


@dataclass(frozen=True)
class Label:
    """Lines of names, each with its transfer."""

    lines: tuple[tuple[str, str], ...]


def label_of(flow: Flow, blocks: int) -> Label:
    """One line for each transfer."""
    most = LONGEST if blocks < MANY else SHORTEST
    return Label(tuple((names_in(names, most), transfer) for transfer, names in flow.signals))


def names_in(names: Sequence[str], most: int) -> str:
    """`x, y, +3`: the first names, within so many characters, and the number of the others."""
    for count in range(len(names), 0, -1):
        more = f", +{len(names) - count}" if count < len(names) else ""
        line = ", ".join(names[:count]) + more
        if len(line) <= most:
            return line
    more = f", +{len(names) - 1}" if len(names) > 1 else ""
    return shortened(names[0], most - len(more)) + more
