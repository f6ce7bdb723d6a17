"""What the pages of the documentation take from the code: a comment `<!-- made: KIND ARGUMENTS -->` becomes Markdown.

Nothing is copied into the pages, so that nothing there can go stale; KINDS has what there is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import maths, pages

if TYPE_CHECKING:
    from sphinx.application import Sphinx


def setup(app: Sphinx) -> dict[str, bool]:
    """Entry point of the Sphinx extension."""
    app.connect("source-read", pages.fill)
    app.add_html_math_renderer("mathml", inline_renderers=(maths.inline, None), block_renderers=(maths.block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
