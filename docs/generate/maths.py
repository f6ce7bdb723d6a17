"""Equations as MathML, which every browser of today sets by itself: no script, no fonts, no network."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from docutils import nodes
from latex2mathml.converter import convert

if TYPE_CHECKING:
    from sphinx.writers.html5 import HTML5Translator

TAG = re.compile(r"\\tag\{([^}]*)\}")


def inline(self: HTML5Translator, node: nodes.math) -> None:
    """`$x$` within a line."""
    self.body.append(convert(node.astext()))
    raise nodes.SkipNode


def block(self: HTML5Translator, node: nodes.math_block) -> None:
    """An equation of its own, with the number of its `\\tag{...}` to the right."""
    text = node.astext()
    tag = TAG.search(text)
    number = f'<span class="number">({tag[1]})</span>' if tag else ""
    self.body.append(f'<div class="equation">{convert(TAG.sub("", text), display="block")}{number}</div>\n')
    raise nodes.SkipNode
