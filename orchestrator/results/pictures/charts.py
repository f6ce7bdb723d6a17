"""Figures of merit over varied parameters: lines over one, maps over two, a scatter matrix over any."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .canvas import matrix_figure, tiles_figure
from .shown import shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MATRIX = 8  # parameters, and figures of merit, that a scatter matrix has room for

Figures = Mapping[str, tuple[np.ndarray, str]]  # by name: values in the shape of the design, and unit


class Axis(NamedTuple):
    """A varied parameter: its values along the grid, or at each point; texts stand for themselves."""

    name: str
    unit: str
    values: np.ndarray

    def places(self) -> tuple[np.ndarray, list[str]]:
        """Numbers to draw at, in the unit in which they are read, and what stands there where they are no numbers."""
        if self.values.dtype.kind in "fiu":
            return shown(self.unit, [self.values]).factor * self.values.astype(float), []
        texts = [str(value) for value in self.values.tolist()]
        known = {text: k for k, text in enumerate(dict.fromkeys(texts))}
        return np.array([float(known[text]) for text in texts]), list(known)

    @property
    def label(self) -> str:
        """`name [unit]`."""
        if self.values.dtype.kind not in "fiu":
            return self.name
        return shown(self.unit, [self.values]).label(self.name)


def lines(title: str, axis: Axis, figures: Figures) -> Figure:
    """Each figure of merit over one parameter; points without a value are gaps."""
    places, texts = axis.places()
    order = np.argsort(places, kind="stable")
    figure, drawn = tiles_figure(title, len(figures))
    for tile, (name, (values, unit)) in zip(drawn, figures.items(), strict=True):
        read = shown(unit, [values])
        tile.plot(places[order], read.factor * values[order], "o" if texts else "o-", markersize=4, linewidth=1.1)
        tile.set_ylabel(read.label(name), fontsize="small")
        tile.set_xlabel(axis.label, fontsize="small")
        tile.margins(x=0.04, y=0.08)
        if texts:
            tile.set_xticks(range(len(texts)), texts)
    return figure


def heat_maps(title: str, axes: Sequence[Axis], figures: Figures) -> Figure:
    """Each figure of merit over two parameters, the first one upwards; a point without a value is hatched."""
    (y, y_texts), (x, x_texts) = axes[0].places(), axes[1].places()
    y_order, x_order = np.argsort(y, kind="stable"), np.argsort(x, kind="stable")
    figure, drawn = tiles_figure(title, len(figures))
    for tile, (name, (values, unit)) in zip(drawn, figures.items(), strict=True):
        read = shown(unit, [values])
        ordered = read.factor * values[np.ix_(y_order, x_order)]
        tile.grid(False)
        tile.patch.set(hatch="////", edgecolor="lightgray")
        mesh = tile.pcolormesh(edges(x[x_order]), edges(y[y_order]), np.ma.masked_invalid(ordered), cmap="viridis")
        bar = figure.colorbar(mesh, ax=tile)
        bar.set_label(read.label(name), fontsize="small")
        bar.ax.tick_params(labelsize="small")
        tile.set_xlabel(axes[1].label, fontsize="small")
        tile.set_ylabel(axes[0].label, fontsize="small")
        for texts, ticks in ((x_texts, tile.set_xticks), (y_texts, tile.set_yticks)):
            if texts:
                ticks(range(len(texts)), texts)
    return figure


def edges(places: np.ndarray) -> np.ndarray:
    """Half way between neighbouring places, in rising order, (places + 1,)."""
    if len(places) == 1:
        return np.array([places[0] - 0.5, places[0] + 0.5]) if places[0] == 0 else places[0] * np.array([0.95, 1.05])
    middle = (places[1:] + places[:-1]) / 2.0
    return np.concatenate([[2.0 * places[0] - middle[0]], middle, [2.0 * places[-1] - middle[-1]]])


def scatter_matrix(title: str, axes: Sequence[Axis], figures: Figures) -> Figure:
    """Each figure of merit, a row, over each parameter, a column: the first MATRIX of both."""
    columns, names = list(axes[:MATRIX]), list(figures)[:MATRIX]
    figure, drawn = matrix_figure(title, len(names), len(columns))
    full = next(iter(figures.values()))[0].shape
    for row, name in zip(drawn, names, strict=True):
        values, unit = figures[name]
        read = shown(unit, [values])
        for k, (tile, axis) in enumerate(zip(row, columns, strict=True)):
            places, texts = axis.places()
            if len(full) > 1:  # a grid: its points one after the other
                along = next(n for n, one in enumerate(axes) if one is axis) if len(axes) == len(full) else k
                places = np.broadcast_to(places.reshape([-1 if n == along else 1 for n in range(len(full))]), full)
            tile.plot(places.ravel(), read.factor * values.ravel(), "o", markersize=3, alpha=0.6)
            tile.margins(0.06)
            if texts:
                tile.set_xticks(range(len(texts)), texts)
        row[0].set_ylabel(broken(read.label(name)), fontsize="x-small")
    for tile, axis in zip(drawn[-1], columns, strict=True):
        tile.set_xlabel(broken(axis.label), fontsize="x-small")
    if len(axes) > MATRIX or len(figures) > MATRIX:
        figure.suptitle(f"{title}\n(the first {len(columns)} of {len(axes)} parameters, "
                        f"{len(names)} of {len(figures)} figures of merit)")  # fmt: skip
    return figure


def broken(label: str) -> str:
    """A long label on two lines."""
    return label.replace(".", ".\n", 1).replace(" [", "\n[") if len(label) > 14 else label
