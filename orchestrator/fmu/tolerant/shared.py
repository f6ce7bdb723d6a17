"""Variables of FMI 2.0 that share a value reference: their value is one, so one of them is set, in one unit."""

from __future__ import annotations

from typing import Any

from ..reading.aliases import BASE
from .literals import place
from .rules import SET_TWICE, UNITS_DIFFER, Notes
from .variable import Known, value_of


def note_shared(kept: list[Any], known: Known) -> None:
    """Note inputs and parameters that are set under two names, and aliases that are called another unit."""
    notes: Notes = known.notes
    settable: set[tuple[str, str, str]] = set()
    units: dict[tuple[str, str], str] = {}
    for element in kept:
        value, causality = value_of(element, 2), element.get("causality")
        key = BASE.get(value.tag, value.tag), element.get("valueReference")
        if causality in ("input", "parameter"):
            if (causality, *key) in settable:
                notes.add(SET_TWICE, place(element))
            settable.add((causality, *key))
        unit = _unit(value, known)
        if unit and (first := units.setdefault(key, unit)) != unit and not known.same_unit(first, unit):
            notes.add(UNITS_DIFFER, f"{unit} of {place(element)}, before {first}")


def _unit(value: Any, known: Known) -> str:
    """The unit that a variable states, itself or by its declared type."""
    declared = known.types.get(value.get("declaredType"))
    return value.get("unit") or (declared.get("unit") if declared is not None else "") or ""
