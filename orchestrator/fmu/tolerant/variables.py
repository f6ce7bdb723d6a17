"""The variables: those that cannot be addressed are left out; names, references and sizes are made to agree."""

from __future__ import annotations

from math import prod
from typing import Any

from .literals import place, whole
from .rules import INDEPENDENT, MISSING, NAME_TWICE, NOWHERE, REFERENCE_TWICE, STARTS, UNUSABLE, Notes
from .shared import note_shared
from .variable import Known, mend_variable, value_of

LARGEST_REFERENCE = 2**32 - 1


def mend_variables(root: Any, version: int, notes: Notes) -> dict[int, int]:
    """Mend all variables; returns the new position of each that stays by its old one, both from 1."""
    variables = root.find("ModelVariables")
    if variables is None:
        notes.add(MISSING, "ModelVariables")
        variables = root.makeelement("ModelVariables")
        structure = root.find("ModelStructure")
        root.insert(len(root) if structure is None else root.index(structure), variables)
    kept: list[Any] = []
    places: dict[int, int] = {}
    names: set[str] = set()
    for k, element in enumerate(list(variables), 1):
        name, value = element.get("name") or "", value_of(element, version)
        reference = whole(element.get("valueReference"))
        if not name or value is None or reference is None or not 0 <= reference <= LARGEST_REFERENCE:
            notes.add(UNUSABLE, place(element))
        elif name in names:
            notes.add(NAME_TWICE, place(element))
        else:
            element.set("valueReference", str(reference))
            names.add(name)
            kept.append(element)
            places[k] = len(kept)
            continue
        variables.remove(element)
    known = Known(root, version, notes)
    for element in kept:
        mend_variable(element, known)
    if version == 2:
        _positions(kept, places, notes)
        note_shared(kept, known)
    else:
        _references(variables, kept, names, notes)
    return places


def _positions(kept: list[Any], places: dict[int, int], notes: Notes) -> None:
    """FMI 2.0: variables name each other by position."""
    for element in kept:
        value = value_of(element, 2)
        if value.get("derivative") is not None:
            position = places.get(whole(value.get("derivative")) or 0)
            if position is None:
                notes.add(NOWHERE, f"derivative of {place(element)}")
                del value.attrib["derivative"]
            else:
                value.set("derivative", str(position))


def _references(variables: Any, kept: list[Any], names: set[str], notes: Notes) -> None:
    """FMI 3.0: variables name each other by value reference, also those that give the size of an array."""
    by_reference: dict[int, Any] = {}
    for element in kept:
        reference = int(element.get("valueReference"))
        if reference in by_reference:
            notes.add(REFERENCE_TWICE, place(element))
        by_reference.setdefault(reference, element)
    for element in kept:
        for attribute in ("derivative", "previous"):
            if element.get(attribute) is not None and whole(element.get(attribute)) not in by_reference:
                notes.add(NOWHERE, f"{attribute} of {place(element)}")
                del element.attrib[attribute]
        clocks = element.get("clocks")
        if clocks is not None:
            found = [word for word in clocks.split() if whole(word) in by_reference]
            if len(found) < len(clocks.split()):
                notes.add(NOWHERE, f"clocks of {place(element)}")
            element.set("clocks", " ".join(found))
            if not found:
                del element.attrib["clocks"]
        for alias in element.findall("Alias"):
            if not alias.get("name") or alias.get("name") in names:
                notes.add(NAME_TWICE if alias.get("name") else UNUSABLE, place(alias))
                element.remove(alias)
            else:
                names.add(alias.get("name"))
        sizes = [_size(dimension, by_reference) for dimension in element.findall("Dimension")]
        if None in sizes:
            notes.add(UNUSABLE, place(element))
            variables.remove(element)
        elif sizes:
            _starts(element, prod(size or 0 for size in sizes), notes)
    times = sum(element.get("causality") == "independent" for element in kept)
    if times != 1:
        notes.add(INDEPENDENT, str(times))


def _starts(element: Any, count: int, notes: Notes) -> None:
    """The start values of an array are one, or one for each of its `count` elements."""
    starts = element.findall("Start")
    stated = len(starts) if element.tag in ("String", "Binary") else len(element.get("start", "").split())
    if stated not in (0, 1, count):
        notes.add(STARTS, f"{stated} for {count} of {place(element)}")
        element.attrib.pop("start", None)
        for start in starts:
            element.remove(start)


def _size(dimension: Any, by_reference: dict[int, Any]) -> int | None:
    """The size that a dimension of an array begins with; a number stays one that fmpy reads."""
    stated = dimension.get("start")
    if stated is None:
        size = by_reference.get(-1 if (at := whole(dimension.get("valueReference"))) is None else at)
        stated = None if size is None else size.get("start")
    found = whole(stated)
    if found is not None and found >= 0 and dimension.get("start") is not None:
        dimension.set("start", str(found))
    return found if found is not None and found >= 0 else None
