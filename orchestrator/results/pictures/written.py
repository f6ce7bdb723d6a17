"""Names in pictures as they are written: no formula between two dollars, and no warning where a font lacks a letter."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

OWN = r"$\mathdefault{"  # how matplotlib writes powers of ten


@contextmanager
def as_written(figure: Figure) -> Iterator[None]:
    """While a figure is drawn: FMUs from elsewhere may name their variables by any letters."""
    from matplotlib.text import Text

    for text in figure.findobj(Text):
        if isinstance(text, Text) and "$" in text.get_text() and not text.get_text().startswith(OWN):
            text.set_parse_math(False)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph", UserWarning)  # a box stands for it
        yield
