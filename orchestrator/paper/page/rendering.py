"""From data to a page of HTML that needs nothing but itself: text is escaped, figures and scripts are inside."""

from __future__ import annotations

import base64
import io
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import jinja2

from .maths import maths

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEMPLATES = Path(__file__).parent / "templates"


@cache
def templates() -> jinja2.Environment:
    """The templates: every value that is no markup is escaped, and one that is missing is an error."""
    found = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True
    )
    found.filters["number"] = number
    found.filters["maths"] = maths
    return found


def render(name: str, content: Mapping[str, Any]) -> str:
    """One template with its content."""
    return templates().get_template(name).render(**content)


def number(value: float) -> str:
    """Five digits."""
    return f"{value:.5g}"


def image(figure: Figure) -> str:
    """A figure as the text of a data URI, PNG."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    return f"data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}"
