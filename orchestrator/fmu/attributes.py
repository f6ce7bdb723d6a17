"""What a description says of a variable's values: type, unit and range; and values that must keep to it."""

from __future__ import annotations

from fmpy.model_description import ModelVariable

from ..errors import InputError
from .types import REALS, TYPES, FmiType, Value


def parse_value(variable: ModelVariable, value: object, label: str, kind: FmiType | None = None) -> Value:
    """A parameter or start value in the variable's type and range. Raises InputError saying what is allowed."""
    unit = f" {variable.unit}" if variable.unit not in (None, "", "1") else ""
    real = variable.type in REALS
    try:
        if variable.type in ("String", "Binary"):
            return str(value)
        if variable.type == "Boolean":
            return {"true": True, "1": True, "1.0": True, "false": False, "0": False, "0.0": False}[
                str(value).strip().lower()
            ]
        number: float | int = float(str(value)) if real else _whole(str(value))
        if number != number or abs(number) == float("inf"):
            raise ValueError
    except (ValueError, KeyError, OverflowError):
        what = "a finite number" if real else "true or false" if variable.type == "Boolean" else "a whole number"
        raise InputError(f"{label} = {value!s} is not {what}") from None
    low, high = _bounds(variable, real, kind or TYPES[2].get(variable.type) or TYPES[3].get(variable.type))
    if not low <= number <= high:
        shown = f"{number:g}" if real else f"{number}"
        raise InputError(f"{label} = {shown}{unit} is out of range: {_text(low)} to {_text(high)}{unit} are allowed")
    return number


def _whole(text: str) -> int:
    """A whole number, exact to 64 bits; `3.0` is one."""
    try:
        return int(text)
    except ValueError:
        if float(text) != int(float(text)):
            raise ValueError from None
        return int(float(text))


def _bounds(variable: ModelVariable, real: bool, kind: FmiType | None) -> tuple[float | int, float | int]:
    """The allowed range: what the variable declares, within what its type can hold."""
    if real:
        low = float(variable.min) if variable.min is not None else -float("inf")
        return low, float(variable.max) if variable.max is not None else float("inf")
    limits = kind.range if kind else (-(2**63), 2**63 - 1)
    low = max(limits[0], int(variable.min)) if variable.min is not None else limits[0]
    return low, min(limits[1], int(variable.max)) if variable.max is not None else limits[1]


def _text(bound: float | int) -> str:
    return f"{bound:g}" if isinstance(bound, float) else f"{bound}"
