"""What an FMI 3.0 description says of variables beside what fmpy keeps: of clocks, of binaries, of when they are set.

Values stay as they are written: the interval of a clock is a decimal number, which no double holds exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

OF_TYPE = {
    "Clock": (
        "canBeDeactivated", "priority", "intervalVariability", "intervalDecimal", "shiftDecimal", "supportsFraction",
        "resolution", "intervalCounter", "shiftCounter",
    ),
    "Binary": ("mimeType", "maxSize"),
}  # fmt: skip
OF_ANY = ("intermediateUpdate", "canHandleMultipleSetPerTimeInstant")

Details = Mapping[str, Mapping[str, str]]  # by the name of a variable, then of an attribute


def details_of(root: Any) -> dict[str, dict[str, str]]:
    """The further attributes of every variable that has any: its own, then its declared type's."""
    declared = {element.get("name"): element for element in root.iterfind("TypeDefinitions/*")}
    declared.pop(None, None)
    found: dict[str, dict[str, str]] = {}
    for element in root.iterfind("ModelVariables/*"):
        own = {name: element.get(name) for name in OF_ANY}
        shared = declared.get(element.get("declaredType"))
        for name in OF_TYPE.get(str(element.tag), ()):
            own[name] = element.get(name, None if shared is None else shared.get(name))
        stated = {name: value for name, value in own.items() if value is not None}
        if stated and element.get("name"):
            found.setdefault(element.get("name"), stated)
    return found


def leave_to_fmpy(root: Any) -> None:
    """Take from a description what fmpy's classes of declared types do not have; see `details_of` for what it says."""
    for kind, names in OF_TYPE.items():
        for declared in root.iterfind(f"TypeDefinitions/{kind}Type"):
            for name in names:
                declared.attrib.pop(name, None)
    for clock in root.iterfind("ModelVariables/Clock"):
        clock.attrib.pop("declaredType", None)  # it passes over the types of clocks
