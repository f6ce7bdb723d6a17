"""The FMI 2.0 model description of a component, written from its interface declaration.

References: FMI 2.0.4, sections 2.2.3 (UnitDefinitions), 2.2.7 (ModelVariables), 2.2.8 (ModelStructure),
4.3.1 (CoSimulation).
"""

from __future__ import annotations

import re
from typing import Any
from xml.etree.ElementTree import Element, SubElement

from .interface import Variable

GUID_PLACEHOLDER = "{content-hash}"
VERSION = "0.1.0"

# SI base-unit exponents of the symbols used in declarations: kg, m, s, A, rad.
SYMBOLS = {
    "1": {}, "kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "A": {"A": 1}, "rad": {"rad": 1}, "Hz": {"s": -1},
    "N": {"kg": 1, "m": 1, "s": -2}, "Pa": {"kg": 1, "m": -1, "s": -2}, "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3}, "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "Ohm": {"kg": 1, "m": 2, "s": -3, "A": -2}, "H": {"kg": 1, "m": 2, "s": -2, "A": -2},
}  # fmt: skip


def base_unit(unit: str) -> dict[str, int] | None:
    """SI exponents of a unit such as `N.m.s/rad` or `kg.m2`; None if an exponent is not whole (`N/m1.5`).

    Everything behind the slash is in the denominator. Raises ValueError for an unknown symbol.
    """
    exponents: dict[str, float] = {}
    numerator, _, denominator = unit.partition("/")
    for part, sign in ((numerator, 1), (denominator, -1)):
        for factor in filter(None, part.strip("()").split(".") if not re.search(r"\d\.\d", part) else [part]):
            match = re.fullmatch(r"([A-Za-z]+|1)(-?[\d.]+)?", factor)
            if match is None or match[1] not in SYMBOLS:
                raise ValueError(f"unit '{unit}': unknown symbol in '{factor}'; known are {', '.join(SYMBOLS)}")
            for base, exponent in SYMBOLS[match[1]].items():
                exponents[base] = exponents.get(base, 0.0) + sign * exponent * float(match[2] or 1)
    if any(exponent != int(exponent) for exponent in exponents.values()):
        return None
    return {base: int(exponent) for base, exponent in exponents.items() if exponent}


def model_description(component: type[Any], sources: tuple[str, ...] = ()) -> Element:
    """The `fmiModelDescription` element of a ComponentSlave subclass; the GUID is filled in by the build.

    `sources`: the C files of a native FMU; without them it is a Python FMU.
    """
    variables: tuple[Variable, ...] = component.variables()
    name = component.component_name()
    root = Element("fmiModelDescription", {
        "fmiVersion": "2.0", "modelName": name, "guid": GUID_PLACEHOLDER,
        "description": (component.__doc__ or "").strip().splitlines()[0], "version": VERSION, "license": "MIT",
        "generationTool": f"rovbrush {VERSION}" + ("" if sources else " with pythonfmu 0.7.0"),
        "variableNamingConvention": "structured",
    })  # fmt: skip
    # needsExecutionTool: a Python FMU needs a Python interpreter with numpy and numba, but no simulation tool.
    co_simulation = SubElement(root, "CoSimulation", {
        "modelIdentifier": name, "needsExecutionTool": "false", "canHandleVariableCommunicationStepSize": "true",
        "canInterpolateInputs": "false", "canBeInstantiatedOnlyOncePerProcess": "false",
        "canNotUseMemoryManagementFunctions": "true", "canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true",
    })  # fmt: skip
    if sources:
        files = SubElement(co_simulation, "SourceFiles")
        for source in sources:
            SubElement(files, "File", {"name": source})
    add_definitions(root, component, variables)
    scalars = SubElement(root, "ModelVariables")
    index: dict[str, list[int]] = {}
    for v in variables:
        index[v.name] = [len(scalars) + k + 1 for k in range(len(v.start))]
        for k, element_name in enumerate(v.element_names):
            scalars.append(_scalar_variable(v, element_name, len(scalars), v.start[k]))
    _model_structure(root, variables, index, component.started_by())
    return root


def add_definitions(
    root: Element, component: type[Any], variables: tuple[Variable, ...], more_units: tuple[str, ...] = ()
) -> None:
    """Units (also `more_units`), log categories and default experiment, which FMI 2.0 and 3.0 write alike."""
    units = SubElement(root, "UnitDefinitions")
    for unit in dict.fromkeys((*(v.unit for v in variables), *more_units)):
        element = SubElement(units, "Unit", {"name": unit})
        exponents = base_unit(unit)
        if exponents is not None:
            SubElement(element, "BaseUnit", {base: str(exponent) for base, exponent in exponents.items()})
    categories = SubElement(root, "LogCategories")
    for category, text in component.log_categories.items():
        SubElement(categories, "Category", {"name": category, "description": text})
    experiment = {"startTime": "0", "stopTime": "10", "stepSize": repr(component.default_step)}
    SubElement(root, "DefaultExperiment", experiment)


def _scalar_variable(v: Variable, name: str, reference: int, start: float) -> Element:
    element = Element("ScalarVariable", variable_attributes(v, name, reference))
    SubElement(element, v.kind, type_attributes(v, (start,)))
    return element


def variable_attributes(v: Variable, name: str, reference: int) -> dict[str, str]:
    """Name, description, causality, variability, initial: the same words in FMI 2.0 and 3.0."""
    source = f" (source: {v.source})" if v.source else ""
    attributes = {"name": name, "valueReference": str(reference), "description": v.description + source}
    attributes["causality"] = v.causality
    if v.causality in ("parameter", "calculatedParameter"):
        attributes["variability"] = "tunable" if v.tunable else "fixed"
    else:
        attributes["variability"] = "discrete" if v.sampled or v.kind != "Real" else "continuous"
    if v.causality == "parameter":
        attributes["initial"] = "exact"
    elif v.causality != "input":
        attributes["initial"] = "calculated"
    return attributes


def type_attributes(v: Variable, starts: tuple[float, ...]) -> dict[str, str]:
    """Unit, range, nominal and start values."""
    typed: dict[str, str] = {"unit": v.unit} if v.kind == "Real" else {}
    if v.kind != "Boolean":
        for bound, value in (("min", v.minimum), ("max", v.maximum)):
            if abs(value) != float("inf"):
                typed[bound] = _literal(value, v)
    if v.causality == "parameter" and v.kind == "Real" and starts[0]:
        typed["nominal"] = repr(abs(starts[0]))
    if v.causality in ("parameter", "input"):
        typed["start"] = " ".join(_literal(start, v) for start in starts)
    return typed


def _literal(value: float, v: Variable) -> str:
    """All digits of a number, in the lexical form of its FMI type."""
    if v.kind == "Boolean":
        return str(bool(value)).lower()
    return str(int(value)) if v.kind == "Integer" else repr(float(value))


def _model_structure(
    root: Element, variables: tuple[Variable, ...], index: dict[str, list[int]], started_by: set[str]
) -> None:
    structure = SubElement(root, "ModelStructure")
    outputs = SubElement(structure, "Outputs")
    unknowns = SubElement(structure, "InitialUnknowns")
    parameters = [k for v in variables if v.causality == "parameter" for k in index[v.name]]
    for v in variables:
        if v.causality not in ("output", "calculatedParameter"):
            continue
        inputs = sorted(k for name in v.depends for k in index[name])
        at_start = sorted(k for name in {*v.depends, *started_by} for k in index[name])
        for k in index[v.name]:
            if v.causality == "output":
                SubElement(outputs, "Unknown", {"index": str(k), **_dependencies(inputs)})
            SubElement(unknowns, "Unknown", {"index": str(k), **_dependencies(parameters + at_start)})


def _dependencies(indices: list[int]) -> dict[str, str]:
    return {"dependencies": " ".join(map(str, indices))}
