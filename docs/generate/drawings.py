"""Drawings of our own, put into the page itself, so that their colours follow the theme, light or dark."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parents[1] / "drawings"


def drawing(name: str) -> str:
    """The SVG `name`, with its title for those who cannot see it."""
    lines = (FOLDER / f"{name}.svg").read_text(encoding="utf-8").splitlines()
    return f'<figure class="drawing">{"".join(line.strip() for line in lines)}</figure>'
