"""Figures of a `kind` that a system file asks for: who draws one registers an entry point `rovbrush.figures`."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.metadata import entry_points
from typing import TYPE_CHECKING, Any, Protocol

from ..model import System

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GROUP = "rovbrush.figures"


class FigureKind(Protocol):
    """What an entry point of the group names: an object or a module with these three."""

    KEYS: tuple[str, ...]  # of a `[[figures]]` entry, beside `kind`, `file` and `title`; all are needed

    def check(self, entry: Mapping[str, Any], system: System, label: str) -> None:
        """Raise InputError, beginning with `label`, for an entry that could not be drawn."""

    def shows(self, entry: Mapping[str, Any], variables: list[str]) -> list[str]:
        """Which of these variables, `component.variable`, the figure shows."""

    def draw(self, calculated: Mapping[str, float], entry: Mapping[str, Any]) -> Figure:
        """The figure, from the calculated parameters of the run."""


@cache
def figure_kinds() -> dict[str, Any]:
    """Entry points by the name of their kind."""
    return {point.name: point for point in entry_points(group=GROUP)}


def figure_kind(name: str) -> FigureKind:
    """The kind of that name; see `figure_kinds` for the names."""
    found: FigureKind = figure_kinds()[name].load()
    return found
