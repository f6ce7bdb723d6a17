"""Typeset maths: symbols and `$formulas$` in a text as MathML, which browsers draw themselves, without a network.

A symbol is one letter or the name of a Greek one, with what stands below it: `F_z`, `omega_b`, `T_brush`. Names of
variables, such as `brush.F_z` or `contact_count`, stay as they are.
"""

from __future__ import annotations

import re
from functools import cache

from markupsafe import Markup, escape

GREEK = (
    "alpha", "beta", "gamma", "delta", "epsilon", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "rho", "sigma",
    "tau", "phi", "psi", "omega", "Delta", "Omega",
)  # fmt: skip
LETTER = rf"(?:{'|'.join(GREEK)}|[A-Za-z])"
# Not inside of a longer name, of a path or option, or of the text of a tag.
SYMBOL = (
    rf"(?<![\w.\-$'\"&])({LETTER})_([A-Za-z0-9]+)(?![\w\[(=]|\.\w|-\w)|(?<![\w.\-/$&])({'|'.join(GREEK)})(?![\w.\-=])"
)
PIECES = re.compile(rf"\$([^$]+)\$|(<code.*?</code>|</?[A-Za-z][^<>]*>)|{SYMBOL}", re.DOTALL)


def maths(text: object) -> Markup:
    """A text with its symbols and formulas as MathML; all else is escaped, but for what is markup already."""
    if not isinstance(text, str):
        return escape(text)
    marked = isinstance(text, Markup)
    found, done = Markup(""), 0
    for match in PIECES.finditer(str(text)):
        formula, tag, letter, below, greek = match.groups()
        if tag is not None and not marked:
            continue  # no tag but two signs of comparison
        found += _plain(str(text)[done : match.start()], marked)
        if tag is not None:
            found += Markup(tag)
        else:
            found += formula_in_mathml(formula or _latex(letter or greek, below or ""), formula or match[0])
        done = match.end()
    return found + _plain(str(text)[done:], marked)


def _plain(part: str, marked: bool) -> Markup:
    return Markup(part) if marked else escape(part)


def _latex(letter: str, below: str) -> str:
    symbol = f"\\{letter}" if letter in GREEK else letter
    if not below:
        return symbol
    return f"{symbol}_{{{below}}}" if len(below) == 1 else f"{symbol}_{{\\text{{{below}}}}}"


@cache
def formula_in_mathml(latex: str, alternative: str) -> Markup:
    """A formula in LaTeX as MathML; `alternative` is what a reader is given that draws none."""
    from latex2mathml.converter import convert

    return Markup(convert(latex).replace("<math ", f'<math alttext="{escape(alternative)}" ', 1))
