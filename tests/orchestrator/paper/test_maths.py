"""Symbols and formulas of a page as MathML: which are, and that nothing else changes."""

from __future__ import annotations

import pytest
from markupsafe import Markup
from rovbrush.orchestrator.paper.page.maths import maths


def symbols(text: object) -> int:
    return str(maths(text)).count("<math ")


@pytest.mark.parametrize("text", ["F_z", "omega_b", "T_brush", "omega", "omega_2/omega_1", "lambda_r [1]", "(k_T u^2)"])
def test_a_symbol_is_typeset(text: str) -> None:
    assert symbols(text) == text.count("_") + (text == "omega")


@pytest.mark.parametrize("text", ["brush.F_z", "contact_count", "F_control[1]", "--set x_y=1", "$", "mu.toml", "a-mu"])
def test_a_name_stays_as_it_is(text: str) -> None:
    assert symbols(text) == 0 and maths(text) == text


def test_a_formula_is_typeset_between_dollar_signs() -> None:
    found = maths(r"the load $\pi^2 E I / (4 L^2)$ is 12 mN")
    assert found.startswith("the load <math ") and found.endswith("</math> is 12 mN") and "<msup>" in found


def test_what_is_no_markup_is_escaped_and_markup_is_not() -> None:
    assert maths("a < F_z <b>").startswith("a &lt; <math ") and "&lt;b&gt;" in maths("a < F_z <b>")
    kept = '<p title="F_z">5 <code>F_z</code></p>'
    assert maths(Markup(kept)) == kept
    assert maths(3.5) == "3.5"
