"""Constraints as they are written: `figure <= value`, `figure >= 5 mm`."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from ...errors import InputError, point_wanted
from ...fmu.attributes import is_number
from ...system.file.merits import merit
from ...system.quantities import QUANTITY, in_own_unit
from ...units import conversion
from ..sweep.merits import require_known
from ..sweep.request import Request

OPTION = "--subject-to"
WRITTEN = re.compile(r"\s*(?P<figure>[^<>=]+?)\s*(?P<sign><=|>=)\s*(?P<bound>[^<>=]+?)\s*")


@dataclass(frozen=True)
class Constraint:
    """A figure of merit that stays at or below (`sign` 1), or at or above (-1), a bound in its own unit."""

    figure: str
    sign: int
    bound: float

    def excess(self, value: float) -> float:
        """By how much a value breaks it, as a share of the bound (of 1 where that is 0); NaN where there is none."""
        return self.sign * (value - self.bound) / (abs(self.bound) or 1.0)

    def text(self, unit: str) -> str:
        own = "" if unit == "1" else f" {unit}"
        return f"{self.figure} {'<=' if self.sign > 0 else '>='} {self.bound:.6g}{own}"


def figure_of(text: str) -> str:
    """The figure that a constraint is about. Raises InputError for what is no constraint."""
    found = WRITTEN.fullmatch(text)
    if found is None:
        raise InputError(f'{OPTION} "{text}": write "figure <= value" or "figure >= value", or "figure <= 5 mm"')
    return found["figure"]


def constraint_of(text: str, request: Request) -> Constraint:
    """A constraint as it is written, its bound in the unit of the figure. Raises InputError."""
    figure, found = figure_of(text), WRITTEN.fullmatch(text)
    assert found is not None
    require_known([figure], request.units, OPTION)
    bound = _bound(figure, found["bound"], f'{OPTION} "{text}"', request)
    return Constraint(figure, 1 if found["sign"] == "<=" else -1, bound)


def _bound(figure: str, text: str, label: str, request: Request) -> float:
    if not is_number(text):
        match = QUANTITY.fullmatch(text)
        if match is None:
            raise InputError(f"{label}: '{text}' is no number, and none with a unit{point_wanted(text)}")
        unit = request.units[figure]
        operation, names = merit(request.figures[figure][1])
        component, _, variable = (names or [""])[0].partition(".")
        own = operation in ("mean", "rms", "peak", "max", "min", "last") and component in request.system.components
        if own:
            return float(str(in_own_unit(request.system.components[component].fmu, variable, text, label)))
        gain, offset = conversion(match[2].strip(), unit, label)
        return gain * float(match[1]) + offset
    value = float(text)
    if not math.isfinite(value):
        raise InputError(f"{label}: the bound must be finite")
    return value
