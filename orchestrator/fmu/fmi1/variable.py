"""One variable of FMI 1.0 in the words of FMI 2.0."""

from __future__ import annotations

from typing import Any

from ..types import TYPES

NEGATED = "negatedAlias"


def type_of(variable: Any) -> str:
    """The type of a ScalarVariable; empty where it has none that is known."""
    return next((str(child.tag) for child in variable if child.tag in TYPES[1]), "")


def translate_variable(variable: Any) -> None:
    """Rewrite causality, variability and what they say of the start value.

    A parameter with a start value can be set, one without is calculated, and so is one whose start value is a guess
    (`fixed="false"`). Other variables that begin with their start value have `initial="exact"`. The default of
    `variability` is that of the type: only real numbers are continuous.
    """
    kind = type_of(variable)
    value = next((child for child in variable if child.tag == kind), None)
    started = value is not None and value.get("start") is not None
    fixed = value is None or value.attrib.pop("fixed", "true").strip() not in ("false", "0")
    causality = variable.get("causality", "internal")
    variability = variable.get("variability") or ("continuous" if kind == "Real" else "discrete")
    if causality in ("internal", "none"):
        causality = "local"
    if variability == "parameter" and causality == "output":
        variability = "discrete"
    elif variability == "parameter":
        settable = causality == "input" or (started and fixed)
        causality, variability = "parameter" if settable else "calculatedParameter", "fixed"
    elif variability == "constant" and causality == "input":
        causality = "local"
    if started and causality in ("output", "local") and variability in ("discrete", "continuous"):
        variable.set("initial", "exact" if fixed else "approx")
    if started and causality == "calculatedParameter":
        variable.set("initial", "approx")
    variable.set("causality", causality)
    variable.set("variability", variability)
    if variable.get("alias") not in (None, NEGATED):
        del variable.attrib["alias"]
