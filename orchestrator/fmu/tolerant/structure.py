"""The model structure: entries and dependencies that name what is not there are passed over."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .literals import place, whole
from .rules import KINDS, MISSING, NOWHERE, OUTPUTS, Notes

SECTIONS = {
    2: ("Outputs/Unknown", "Derivatives/Unknown", "InitialUnknowns/Unknown"),
    3: ("Output", "ContinuousStateDerivative", "ClockedState", "InitialUnknown", "EventIndicator"),
}


def mend_structure(root: Any, version: int, places: dict[int, int], notes: Notes) -> None:
    """`places`: the new positions of the variables that stayed, by their old ones; see `mend_variables`."""
    structure = root.find("ModelStructure")
    if structure is None:
        notes.add(MISSING, "ModelStructure")
        structure = root.makeelement("ModelStructure")
        root.append(structure)
    variables = list(root.find("ModelVariables"))
    if version == 2:
        find: Callable[[str | None], int | None] = lambda text: places.get(whole(text) or 0)  # noqa: E731
        key = "index"
        outputs = {k: v for k, v in enumerate(variables, 1) if v.get("causality") == "output"}
    else:
        known = {int(v.get("valueReference")): v for v in variables}
        find = lambda text: x if (x := whole(text)) in known else None  # noqa: E731
        key = "valueReference"
        outputs = {k: v for k, v in known.items() if v.get("causality") == "output"}
    listed: set[int] = set()
    for section in SECTIONS[version]:
        for entry in structure.findall(section):
            found = find(entry.get(key))
            if found is None:
                notes.add(NOWHERE, f"{key}={entry.get(key)!r} in ModelStructure (line {entry.sourceline})")
                entry.getparent().remove(entry)
                continue
            entry.set(key, str(found))
            if section == SECTIONS[version][0]:
                listed.add(found)
            _dependencies(entry, find, notes)
    for missing in outputs.keys() - listed:
        notes.add(OUTPUTS, place(outputs[missing]))
    for surplus in listed - outputs.keys():
        notes.add(OUTPUTS, place(variables[surplus - 1] if version == 2 else known[surplus]))


def _dependencies(entry: Any, find: Callable[[str | None], int | None], notes: Notes) -> None:
    """Written with one space between them, as fmpy reads them; left out, for all that there are, where one is wrong."""
    stated, kinds = entry.get("dependencies"), entry.get("dependenciesKind")
    if stated is not None:
        found = [find(word) for word in stated.split()]
        if None in found:
            notes.add(NOWHERE, f"dependencies={stated[:40]!r} in ModelStructure (line {entry.sourceline})")
            del entry.attrib["dependencies"]
            entry.attrib.pop("dependenciesKind", None)
            return
        entry.set("dependencies", " ".join(map(str, found)))
    if kinds is not None:
        entry.set("dependenciesKind", " ".join(kinds.split()))
        if stated is None or len(kinds.split()) != len(stated.split()):
            notes.add(KINDS, f"ModelStructure (line {entry.sourceline})")
            del entry.attrib["dependenciesKind"]
