"""The literals of XML schema in attributes: numbers and truth values, and what is left of those that are none."""

from __future__ import annotations

import math
import re
from typing import Any

from .rules import BOOLEAN, NUMBER, Notes

NUMERAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?INF|NaN")
LONGEST = 400  # characters of a number
TRUTH = {"true": "true", "false": "false", "1": "true", "0": "false", "yes": "true", "no": "false"}


def number(text: str | None) -> float | None:
    """A number as XML schema writes it; None for anything else."""
    text = (text or "").strip()
    return float(text) if len(text) <= LONGEST and NUMERAL.fullmatch(text) else None


def whole(text: str | None) -> int | None:
    """A whole number; None for anything else. `3.0` and `1e3` are whole numbers."""
    text = (text or "").strip()
    if re.fullmatch(r"[+-]?\d{1,30}", text):
        return int(text)
    found = number(text)
    return int(found) if found is not None and math.isfinite(found) and found == int(found) else None


def place(element: Any, name: str = "") -> str:
    """Where an element stands, in words: `u (line 12)`."""
    named = name or element.get("name") or element.tag
    return f"{named} (line {element.sourceline})"


def mend_number(element: Any, attribute: str, notes: Notes, integer: bool = False, name: str = "") -> None:
    """Leave out an attribute that is no number; a whole one is written as such."""
    text = element.get(attribute)
    if text is None:
        return
    found = whole(text) if integer else number(text)
    if found is None or found != found:
        del element.attrib[attribute]
    elif not integer or re.fullmatch(r"\s*[+-]?\d+\s*", text):
        return
    else:
        element.set(attribute, str(found))
    notes.add(NUMBER, f"{attribute}={text[:40]!r} of {place(element, name)}")


def mend_boolean(element: Any, attribute: str, notes: Notes, name: str = "") -> None:
    """Write a truth value as the standard does; leave out what is none."""
    text = element.get(attribute)
    if text is None or text.strip() in ("true", "false", "1", "0"):
        return
    found = TRUTH.get(text.strip().lower())
    if found is None:
        del element.attrib[attribute]
    else:
        element.set(attribute, found)
    notes.add(BOOLEAN, f"{attribute}={text[:40]!r} of {place(element, name)}")
