"""Where blocks, labels and lines of a block diagram are: a grid with a column and a row for each block."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

Size = tuple[float, float]
BETWEEN = (16.0, 16.0)  # px, of columns and rows
MARGIN = 8.0
LOOP = 12.0  # px that the line of a component to itself runs beside its block


@dataclass(frozen=True)
class Grid:
    """The middle of each column x and row y; `block` and `label` are sizes."""

    x: list[float]
    y: list[float]
    block: list[Size]
    label: Mapping[tuple[int, int], Size]
    width: float
    height: float
    own: Mapping[int, Size] = field(default_factory=dict)  # labels of components that are connected to themselves

    def corner(self, source: int, target: int) -> Size:
        """The middle of the label between two blocks."""
        if source == target:
            return self.x[source], self.y[source] + self.block[source][1] / 2 + LOOP / 2 + self.own[source][1] / 2
        return self.x[target], self.y[source]

    def tip(self, source: int, target: int) -> Size:
        """Where the arrow touches the target: its upper edge, or its lower one if that steps earlier."""
        half = self.block[target][1] / 2
        return self.x[target], self.y[target] - half if source < target else self.y[target] + half

    def pieces(self, source: int, target: int) -> list[tuple[float, float, float, float]]:
        """The straight pieces of a line, which no label and no block covers: x, y to x, y."""
        if source == target:
            x, y = self.x[source], self.y[source] + self.block[source][1] / 2
            return [(x, y, x, y + LOOP / 2)]
        along = range(source + 1, target) if source < target else range(source - 1, target, -1)
        way = 1.0 if source < target else -1.0
        found = []
        at = self.x[source] + way * self.block[source][0] / 2
        for column in (*along, target):
            if (source, column) in self.label:
                half = self.label[source, column][0] / 2
                found.append((at, self.y[source], self.x[column] - way * half, self.y[source]))
                at = self.x[column] + way * half
        down = range(source + 1, target) if source < target else range(source - 1, target, -1)
        at = self.y[source] + way * self.label[source, target][1] / 2
        for row in down:
            if (row, target) in self.label:
                half = self.label[row, target][1] / 2
                found.append((self.x[target], at, self.x[target], self.y[row] - way * half))
                at = self.y[row] + way * half
        found.append((self.x[target], at, self.x[target], self.tip(source, target)[1]))
        return found


def grid_of(blocks: Sequence[Size], labels: Mapping[tuple[int, int], Size]) -> Grid:
    """Columns as wide and rows as high as what is in them needs."""
    own = {source: size for (source, target), size in labels.items() if source == target}
    between = {key: size for key, size in labels.items() if key[0] != key[1]}
    columns = [wide for wide, _ in blocks]
    rows = [high for _, high in blocks]
    for (source, target), (wide, high) in between.items():
        columns[target] = max(columns[target], wide)
        rows[source] = max(rows[source], high)
    for source, (wide, high) in own.items():
        columns[source] = max(columns[source], wide)
        rows[source] += 2.0 * (LOOP / 2 + high)
    x, width = _middles(columns, BETWEEN[0])
    y, height = _middles(rows, BETWEEN[1])
    return Grid(x, y, list(blocks), between, width, height, own)


def _middles(sizes: Sequence[float], between: float) -> tuple[list[float], float]:
    """The middle of each of a row of things, and how long the row is with its margins."""
    found, at = [], MARGIN
    for size in sizes:
        found.append(at + size / 2)
        at += size + between
    return found, at - between + MARGIN
