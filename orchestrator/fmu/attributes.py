"""What a description says of a variable's values: type, unit and range; and values that must keep to it."""

from __future__ import annotations

import math
from typing import Any

from fmpy.model_description import ModelDescription, ModelVariable

from ..errors import InputError, nearest, point_wanted, shown
from .binary import bytes_of
from .types import REALS, TYPES, FmiType, Value

INHERITED = ("quantity", "unit", "displayUnit", "min", "max", "nominal")


def resolve(description: ModelDescription, root: Any) -> None:
    """Give every variable all its attributes: its own, then its declared type's, then the default.

    `root` is the XML that the description was read from: fmpy passes over `relativeQuantity` and the range of UInts.
    """
    elements = {element.get("name"): element for element in root.iterfind("ModelVariables/*")}
    for v in description.modelVariables:
        element = elements[v.alias.name if v.alias is not None else v.name]
        value = next((child for child in element if child.tag == v.type), element)
        v.min, v.max = value.get("min"), value.get("max")
        for name in INHERITED:
            if getattr(v, name) is None and v.declaredType is not None:
                setattr(v, name, getattr(v.declaredType, name))
        own = value.get("relativeQuantity")
        inherited = v.declaredType is not None and v.declaredType.relativeQuantity
        v.relativeQuantity = bool(inherited) if own is None else own in ("true", "1")
        if v.min is not None and v.max is not None and float(v.min) > float(v.max):
            v.min = v.max = None


def parse_value(variable: ModelVariable, value: object, label: str, kind: FmiType | None = None) -> Value:
    """A parameter or start value in the variable's type and range; an item of an Enumeration also by its name.

    Raises InputError saying what is allowed.
    """
    unit = f" {variable.unit}" if variable.unit not in (None, "", "1") else ""
    number = _number(variable, value, label)
    if isinstance(number, (str, bool, bytes)):
        return number
    low, high = _bounds(variable, kind or TYPES[2].get(variable.type) or TYPES[3].get(variable.type))
    if not low <= number <= high:
        said = f"{number:g}" if variable.type in REALS else f"{number}"
        raise InputError(f"{label} = {said}{unit} is out of range: {_text(low)} to {_text(high)}{unit} are allowed")
    items = items_of(variable)
    if items and number not in items.values():
        known = ", ".join(f"{name} ({n})" for name, n in items.items())
        raise InputError(f"{label} = {number} is none of the items of the enumeration: {known}")
    return number


def start_value(variable: ModelVariable, label: str) -> Value:
    """The start value that an FMU states, be it in its range or not; zero, false or empty where it states none."""
    empty = "" if variable.type in ("String", "Binary") else "0"
    return _number(variable, empty if variable.start is None else variable.start, label)


def items_of(variable: ModelVariable) -> dict[str, int]:
    """The items of an Enumeration by name; none where its type is not declared."""
    if variable.type != "Enumeration" or variable.declaredType is None:
        return {}
    return {item.name: int(item.value) for item in variable.declaredType.items}


def _number(variable: ModelVariable, value: object, label: str) -> Value:
    """A value in the variable's type."""
    real = variable.type in REALS
    if variable.type == "Binary":
        return bytes_of(value, label)
    if variable.type == "String":
        return str(value)
    items = items_of(variable)
    try:
        if variable.type == "Boolean":
            return {"true": True, "1": True, "1.0": True, "false": False, "0": False, "0.0": False}[
                str(value).strip().lower()
            ]
        if str(value) in items:
            return items[str(value)]
        number: float | int = float(str(value)) if real else _whole(str(value))
        if number != number or abs(number) == float("inf"):
            raise ValueError
    except (ValueError, KeyError, OverflowError):
        what = "a finite number" if real else "true or false" if variable.type == "Boolean" else "a whole number"
        what += f", and no item of the enumeration{nearest(str(value), items)}" if items else ""
        raise InputError(f"{label} = {shown(value)} is not {what}{point_wanted(value)}") from None
    return number


def is_number(text: str) -> bool:
    """Whether a text is a number by itself, with no unit behind it."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def _whole(text: str) -> int:
    """A whole number, exact to 64 bits; `3.0` is one."""
    try:
        return int(text)
    except ValueError:
        if float(text) != int(float(text)):
            raise ValueError from None
        return int(float(text))


def _bounds(variable: ModelVariable, kind: FmiType | None) -> tuple[float | int, float | int]:
    """The allowed range: what the variable declares, within what its type can hold."""
    if variable.type in REALS:
        most = kind.largest if kind else math.inf
        low = max(-most, float(variable.min)) if variable.min is not None else -most
        return low, min(most, float(variable.max)) if variable.max is not None else most
    limits = kind.range if kind else (-(2**63), 2**63 - 1)
    low = max(limits[0], int(variable.min)) if variable.min is not None else limits[0]
    return low, min(limits[1], int(variable.max)) if variable.max is not None else limits[1]


def _text(bound: float | int) -> str:
    return f"{bound:g}" if isinstance(bound, float) else f"{bound}"
