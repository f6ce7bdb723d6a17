"""A picture is drawn once for its file, and is what matplotlib makes of it in two goes."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from rovbrush.orchestrator.results.pictures.canvas import caption, legend_above, new_figure


def drawn() -> Figure:
    figure, axes = new_figure("a title", 2)
    for axis in axes:
        axis.plot(np.linspace(0.0, 10.0, 50), 1e3 * np.sin(np.arange(50)), label="y")
        axis.set_ylabel("long name of a quantity [N.m]")
        legend_above(axis)
    caption(figure, ["parameters: of a test", "constant: " + ", ".join(f"x_{k} = {k}" for k in range(40))])
    return figure


@pytest.mark.parametrize("given", ["path", "text", "buffer"])
def test_the_picture_is_that_of_matplotlib(given: str, tmp_path: Path) -> None:
    file, expected, buffer = tmp_path / "own.png", tmp_path / "matplotlib.png", io.BytesIO()
    if given == "buffer":
        drawn().savefig(buffer, format="png")
        file.write_bytes(buffer.getvalue())
    else:
        drawn().savefig(str(file) if given == "text" else file)
    Figure.savefig(drawn(), expected)
    assert file.read_bytes() == expected.read_bytes()


def test_other_formats_and_options_are_left_to_matplotlib(tmp_path: Path) -> None:
    figure = drawn()
    figure.savefig(tmp_path / "a.svg")
    figure.savefig(tmp_path / "a.png", dpi=30)
    assert b"<svg" in (tmp_path / "a.svg").read_bytes()
    assert 0 < (tmp_path / "a.png").stat().st_size < 40_000
