"""What can go wrong, said once: every error that a user can meet derives from RovbrushError."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from typing import Any

SHOWN = 15  # names in a list of what there is
LONGEST = 80  # characters of a value in a message


class RovbrushError(Exception):
    """Base of all errors with a message for the user; `exit_code` is what the command line returns."""

    exit_code = 1


class InputError(RovbrushError):
    """A system file, an option, a name or a value is wrong; found before time 0."""

    exit_code = 2


class FmuError(RovbrushError):
    """An FMU is missing, corrupt, of the wrong kind, or refuses to initialize."""


class RunError(RovbrushError):
    """The run stopped early; what was computed so far is in the results: from Python in `result`, if not None."""

    result: Any = None


def counted(number: int, thing: str) -> str:
    """`1 point`, `2 points`."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def listed(names: Iterable[str], most: int = 4) -> str:
    """The first names, and how many more there are."""
    every = list(names)
    more = f" and {len(every) - most} more" if len(every) > most else ""
    return ", ".join(every[:most]) + more


def nearest(name: str, known: Iterable[str]) -> str:
    """`; did you mean 'x'?`, or the list of what there is, or nothing where there is nothing."""
    names = sorted(known)
    close = difflib.get_close_matches(name, names, n=1, cutoff=0.5)
    if close:
        return f"; did you mean '{close[0]}'?"
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return f"; there are {', '.join(names[:SHOWN])}{more}" if names else ""


def or_else(hint: str, other: str) -> str:
    """What `nearest` says, and what else would do: `; did you mean 'x'? Or ...`."""
    return f"{hint}{' Or' if hint.endswith('?') else ', or'} {other}"


def point_wanted(value: object) -> str:
    """What to say of a number with a decimal comma; nothing of others, nor of what is no text."""
    if not isinstance(value, str) or not re.match(r"\s*[+-]?\d+,\d+", value):
        return ""
    return f"; a decimal point is wanted: {shown(value.strip().replace(',', '.', 1))}"


def shown(value: object) -> str:
    """A value as a message quotes it: whole where it is short."""
    try:
        text = str(value)
    except ValueError:  # a whole number of thousands of digits
        return "a very large number"
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."
