"""Equations as MathML, which every browser of today sets by itself: no script, no fonts, no network."""

from __future__ import annotations

from typing import TYPE_CHECKING

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.util.math import get_node_equation_number

if TYPE_CHECKING:
    from sphinx.writers.html5 import HTML5Translator


def inline(self: HTML5Translator, node: nodes.math) -> None:
    """`$x$` within a line."""
    self.body.append(convert(node.astext()))
    raise nodes.SkipNode


def block(self: HTML5Translator, node: nodes.math_block) -> None:
    """An equation of its own; its number stands to the right, and is a link to itself."""
    number = node.get("number") and get_node_equation_number(self, node)
    label = f'<a class="number" href="#equation-{node["label"]}">({number})</a>' if number else ""
    name = f' id="equation-{node["label"]}"' if number else ""
    self.body.append(f'<div class="equation"{name}>{convert(node.astext(), display="block")}{label}</div>\n')
    raise nodes.SkipNode
