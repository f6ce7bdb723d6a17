"""A description of FMI 1.0 as one of FMI 2.0: one place reads, mends and resolves both then.

What it means is kept; what FMI 2.0 has no word for is left out (steps that can be rejected, events that are signalled).
A negated alias is marked: its value is that of its value reference with the other sign.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ...errors import FmuError
from ..tolerant.literals import place
from ..tolerant.rules import ALIAS, NOWHERE, Notes
from .variable import NEGATED, translate_variable, type_of

CAPABILITIES = (
    "canHandleVariableCommunicationStepSize", "canInterpolateInputs", "maxOutputDerivativeOrder",
    "canRunAsynchronuously", "canBeInstantiatedOnlyOncePerProcess", "canNotUseMemoryManagementFunctions",
)  # fmt: skip
TOOL, ALONE = "cosimulation_tool", "cosimulation_standalone"
SIGNED = ("Real", "Integer")  # types of which a negated alias has a meaning


def as_fmi2(path: Path, root: Any, notes: Notes) -> None:
    """Rewrite the root of a description. Raises FmuError where the model itself is in a tool, not in the FMU."""
    root.set("fmiVersion", "2.0")
    _interface(path, root)
    _units(root)
    _types(root)
    _variables(root, notes)


def negated_names(root: Any) -> frozenset[str]:
    """The negated aliases of a description that was rewritten."""
    found = root.iterfind(f"ModelVariables/ScalarVariable[@alias='{NEGATED}']")
    return frozenset(element.get("name") for element in found)


def _interface(path: Path, root: Any) -> None:
    """Without `Implementation` an FMU is for model exchange."""
    identifier = root.attrib.pop("modelIdentifier", "")
    kinds = {str(kind.tag).lower(): kind for kind in root.findall("Implementation/*")}
    if TOOL in kinds and ALONE not in kinds:
        made = root.get("generationTool") or "the tool that made it"
        raise FmuError(
            f"FMU {path} holds no model that could be run: it passes calls on to {made}, which must be installed and "
            f"started for it (CoSimulation_Tool); export it as CoSimulation_StandAlone"
        )
    interface = root.makeelement("CoSimulation" if kinds else "ModelExchange", {"modelIdentifier": identifier})
    for capabilities in (kinds[ALONE].findall("Capabilities") if ALONE in kinds else ())[:1]:
        for name in CAPABILITIES:
            if capabilities.get(name) is not None:
                interface.set(name, capabilities.get(name))
    root.insert(0, interface)
    for element in root.findall("Implementation"):
        root.remove(element)


def _units(root: Any) -> None:
    """FMI 1.0 says what a unit is called and how it is shown, not what it means."""
    for unit in root.findall("UnitDefinitions/BaseUnit"):
        unit.tag = "Unit"
        _rename(unit, "unit", "name")
        for display in unit.findall("DisplayUnitDefinition"):
            display.tag = "DisplayUnit"
            _rename(display, "displayUnit", "name")
            _rename(display, "gain", "factor")


def _types(root: Any) -> None:
    """The items of an enumeration are numbered from 1."""
    for declared in root.findall("TypeDefinitions/Type"):
        declared.tag = "SimpleType"
        for inner in declared:
            inner.tag = str(inner.tag).removesuffix("Type")
            for number, item in enumerate(inner.findall("Item"), 1):
                item.set("value", str(number))


def _variables(root: Any, notes: Notes) -> None:
    """Variables, and the dependencies of the outputs, which FMI 1.0 writes with each of them."""
    variables = root.findall("ModelVariables/ScalarVariable")
    known = _known(variables)
    numbers = {v.get("name"): str(k) for k, v in reversed(list(enumerate(variables, 1)))}
    structure, outputs = root.makeelement("ModelStructure"), root.makeelement("Outputs")
    for number, variable in enumerate(variables, 1):
        direct = known.get(_value(variable), [])
        for element in variable.findall("DirectDependency"):
            variable.remove(element)
        translate_variable(variable)
        if variable.get("alias") == NEGATED and type_of(variable) not in SIGNED:
            notes.add(ALIAS, place(variable))
            del variable.attrib["alias"]
        if variable.get("causality") == "output":
            unknown = root.makeelement("Unknown", {"index": str(number)})
            unknown.sourceline = variable.sourceline
            stated = [(name.text or "").strip() for element in direct for name in element.findall("Name")]
            if direct and all(name in numbers for name in stated):
                unknown.set("dependencies", " ".join(numbers[name] for name in stated))
            elif direct:
                unknown_name = next(name for name in stated if name not in numbers)
                notes.add(NOWHERE, f"{unknown_name!r} in DirectDependency of {place(variable)}")
            outputs.append(unknown)
    if len(outputs):
        structure.append(outputs)
    root.append(structure)


def _known(variables: list[Any]) -> dict[tuple[str, str | None], list[Any]]:
    """What is said of the dependencies of a value; an alias need not repeat it."""
    stated = [(_value(v), v.findall("DirectDependency")) for v in variables]
    return {value: direct for value, direct in reversed(stated) if direct}


def _value(variable: Any) -> tuple[str, str | None]:
    """Which value of the FMU a variable is: those of one type that have one reference are the same."""
    return type_of(variable), variable.get("valueReference")


def _rename(element: Any, old: str, new: str) -> None:
    if element.get(old) is not None:
        element.set(new, element.attrib.pop(old))
