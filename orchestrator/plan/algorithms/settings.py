"""Settings of an algorithm as a dataclass: read from a table of the system file, and as a schema for editors.

A field is a number above 0 (`float`), a whole number above 0 (`int`), a time (`Fraction | None`: where nothing is
stated the algorithm chooses) or one of several words (`Literal`); `setting` gives it its default and its meaning. A
`__post_init__` raises InputError where values do not fit each other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from fractions import Fraction
from typing import Any, Literal, get_args, get_origin, get_type_hints

from ...clock import duration
from ...errors import InputError, nearest

Fail = Callable[[str, str, str], InputError]  # message, what to look for in the file, below which heading


@dataclass(frozen=True)
class NoSettings:
    """An algorithm that has none."""


def setting(default: Any, meaning: str) -> Any:
    """A field of a class of settings; `meaning` states the unit."""
    return field(default=default, metadata={"meaning": meaning})


def read_settings(kind: type[Any], heading: str, table: Mapping[str, Any], fail: Fail) -> Any:
    """The table `[heading]` as an object of `kind`. Raises InputError for an unknown key or a value out of range."""
    hints = get_type_hints(kind)
    found = {}
    for key, value in table.items():
        if key not in hints:
            raise fail(f"{heading}: unknown key '{key}'{nearest(key, hints)}", key, heading)
        try:
            found[key] = _value(hints[key], key, value, heading)
        except InputError as error:
            raise fail(str(error), key, heading) from None
    try:
        return kind(**found)
    except InputError as error:
        raise fail(str(error), heading, "") from None


def _value(hint: Any, key: str, value: Any, heading: str) -> Any:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if get_origin(hint) is Literal:
        if value not in get_args(hint):
            raise InputError(f"{heading}: unknown {key} '{value}'{nearest(str(value), get_args(hint))}")
        return value
    if hint is int:
        if not number or not isinstance(value, int) or value < 1:
            raise InputError(f"{heading}: {key} = {value!r} must be a whole number above 0")
        return value
    if hint is float:
        if not number or not 0.0 < value < float("inf"):
            raise InputError(f"{heading}: {key} = {value!r} must be a number above 0")
        return float(value)
    assert Fraction in get_args(hint)
    return duration(value, f"{heading}: {key}")


def schema_of(kind: type[Any]) -> dict[str, Any]:
    """JSON schema of the table that an object of `kind` is read from."""
    hints = get_type_hints(kind)
    properties = {}
    for entry in fields(kind):
        hint, default = hints[entry.name], entry.default
        if get_origin(hint) is Literal:
            says: dict[str, Any] = {"enum": list(get_args(hint))}
        elif hint is int:
            says = {"type": "integer", "minimum": 1}
        elif hint is float:
            says = {"type": "number", "exclusiveMinimum": 0}
        else:
            says = {"type": ["number", "string"]}
        if default is not None:
            says["default"] = default
        properties[entry.name] = {**says, "description": entry.metadata["meaning"]}
    return {"type": "object", "additionalProperties": False, "properties": properties}
