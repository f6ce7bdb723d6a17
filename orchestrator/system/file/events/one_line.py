"""An event in one line, as `--event` takes it, as the table that a file would hold.

2 s: mission.depth = 3 m, controller.on = true
motor.i > 20 A: motor.V_in = 0
50 ms after motor.i > 20 A: loss motor.T_load
3 s: noise controller.psi 2 deg for 1 s seed 7
"""

from __future__ import annotations

import re
import tomllib
from typing import Any, get_args, get_type_hints

from ....clock import instant
from ....errors import InputError, nearest, shown
from ...schema.keys.event import EventTable

EXAMPLE = '"2 s: mission.depth = 3", "motor.i > 20 A: motor.V_in = 0" or "3 s: bias motor.T_load 0.2 for 1 s"'
WORD = re.compile(r"\s(for|until|seed)\s+")
NAME = re.compile(r"[^\s=,]+")


def faults() -> tuple[str, ...]:
    """The kinds of faults that there are."""
    literal = next(kind for kind in get_args(get_type_hints(EventTable)["fault"]) if get_args(kind))
    return get_args(literal)


def event_of_line(line: str) -> dict[str, Any]:
    """The keys of an event. What they mean is checked where events are read. Raises InputError for no such line."""
    when, colon, what = (part.strip() for part in line.partition(":"))
    if not (when and colon and what):
        raise InputError(f"'{shown(line)}' is no event; write when, a colon and what happens: {EXAMPLE}")
    kind, _, rest = what.partition(" ")
    if kind in faults():
        return {**_when(when), **_fault(kind, rest.strip())}
    return {**_when(when), "set": _settings(what)}


def _when(text: str) -> dict[str, Any]:
    try:
        instant(text, "at")
        return {"at": text}
    except InputError:
        after, behind, crossing = text.partition(" after ")
        if behind:
            return {"when": crossing.strip(), "after": after.strip()}
        if re.match(r"[-+.\d]", text):  # meant as a time
            return {"at": text}
        return {"when": text}


def _fault(kind: str, text: str) -> dict[str, Any]:
    """`motor.T_load 20 N cm for 5 ms seed 3`."""
    said, *more = WORD.split(f" {text} ")
    name, _, value = said.strip().partition(" ")
    if not name:
        raise InputError(f"{kind} of what? Write its signal behind it: {EXAMPLE}")
    found: dict[str, Any] = {"fault": kind, "on": name}
    if value.strip():
        found["value"] = _value(value.strip())
    for word, given in zip(more[::2], more[1::2], strict=True):
        if word in found:
            raise InputError(f"'{word}' stands twice")
        found[word] = _value(given.strip()) if word == "seed" else given.strip()
    return found


def _settings(text: str) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for part in re.split(r",(?![^\[]*\])", text):  # commas in brackets are those of a list
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals:
            kind = part.strip().partition(" ")[0]
            raise InputError(
                f"'{shown(part.strip())}' sets nothing and is no fault{nearest(kind, faults())}; write "
                f"component.variable = value, or a fault and its signal: {EXAMPLE}"
            )
        if not NAME.fullmatch(name) or not value:
            raise InputError(f"'{shown(part.strip())}': write component.variable = value, for instance {EXAMPLE}")
        if name in found:
            raise InputError(f"{name} is set twice")
        found[name] = _value(value)
    return found


def _value(text: str) -> Any:
    """A number, true or false, a list or a quoted text as TOML has them; all else is a text: `3 mm`, `force`."""
    try:
        value = tomllib.loads(f"v = {text}")["v"]
    except (tomllib.TOMLDecodeError, ValueError):
        return text
    return value if isinstance(value, bool | int | float | str | list) else text
