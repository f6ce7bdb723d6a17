"""The places in the pages that are filled from the code, and with what."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from . import commands, components, drawings, messages, sections

if TYPE_CHECKING:
    from sphinx.application import Sphinx

MADE = re.compile(r"^<!-- made: ([a-z-]+) ?(.*?) -->$", re.MULTILINE)
KINDS: dict[str, Callable[..., str]] = {
    "commands": commands.reference,  # every command with its arguments and options
    "component": components.page,  # NAME: README and variables of a component
    "components": components.overview,  # a table of all of them
    "equation": components.computed,  # NUMBER: the lines of kernels that compute it
    "drawing": drawings.drawing,  # NAME: an SVG of ours, in the colours of the theme
    "messages": messages.reference,  # every error message of the code
    "mends": messages.mends,  # what the messages mean that people meet most
    "section": sections.section,  # FILE HEADING: a section of a Markdown file of the repository
    "opening": sections.opening,  # FILE: what stands before its first heading
    "file": sections.whole,  # FILE: all of it, without its title
}


def fill(app: Sphinx, page: str, source: list[str]) -> None:
    """Write what is asked for into a page that Sphinx has just read."""
    source[0] = filled(source[0])


def filled(text: str) -> str:
    """A page's text with all that it asks for."""
    return MADE.sub(lambda found: KINDS[found[1]](*found[2].split(maxsplit=1)), text)
