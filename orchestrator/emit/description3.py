"""The FMI 3.0 model description of a whole system, the build description of its sources, and what it does not support.

References: FMI 3.0.1, sections 2.4 (model description), 2.4.7 (variables) and 2.5.1.1 (sources).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from xml.etree.ElementTree import Element, SubElement

from ..fmu.files.compiled import HEADERS
from ..fmu.types import FmiType
from .code.exposed import CALCULATED, HIDDEN, OUTPUT, Exposed
from .compiling import OPTIONS
from .dependencies import at_the_start
from .description2 import (
    add_units,
    attributes,
    can_save,
    convention,
    experiment,
    made_by,
    once,
    typed_attributes,
    written,
)
from .prepared import Prepared

NAMES = {"Real": "Float64", "Integer": "Int32"}


def type3(kind: FmiType) -> str:
    """The type in FMI 3.0; an enumeration as the whole number that it is."""
    if kind.name == "Enumeration":
        return "Int64" if kind.size == 8 else "Int32"
    return NAMES.get(kind.name, kind.name)


def variables3(shown: Iterable[Exposed]) -> list[tuple[int, Exposed]]:
    """What FMI 3.0 can show, each with its number."""
    return [(k, e) for k, e in enumerate(shown) if e.causality != HIDDEN]


def description3(found: Prepared, token: str) -> bytes:
    """`modelDescription.xml`."""
    plan, code = found.plan, found.code
    root = Element("fmiModelDescription", {
        "fmiVersion": "3.0", "modelName": plan.system.name, "instantiationToken": token,
        "description": plan.system.description, "generationTool": made_by(),
        "variableNamingConvention": convention(code.shown),
    })  # fmt: skip
    timing = experiment(found)
    SubElement(root, "CoSimulation", {
        "modelIdentifier": code.name, "needsExecutionTool": "false", "canBeInstantiatedOnlyOncePerProcess": once(found),
        "canHandleVariableCommunicationStepSize": str(found.plan.adaptive).lower(),
        **({} if found.plan.adaptive else {"fixedInternalStepSize": timing["stepSize"]}), **can_save(found),
    })  # fmt: skip
    add_units(root, found, more=("s",))
    categories = SubElement(root, "LogCategories")
    SubElement(categories, "Category", {"name": "logAll", "description": "what components say"})
    SubElement(categories, "Category", {"name": "logStatusWarning", "description": "what may be wrong"})
    SubElement(categories, "Category", {"name": "logStatusError", "description": "what went wrong"})
    SubElement(root, "DefaultExperiment", timing)
    listed = variables3(code.shown)
    declared = SubElement(root, "ModelVariables")
    for k, e in listed:
        kind = type3(e.kind)
        element = SubElement(declared, kind, attributes(e, k))
        typed = typed_attributes(e, e.kind.real)
        if kind == "String":
            SubElement(element, "Start", {"value": typed["start"]})
        else:
            element.attrib.update(typed if kind != "Boolean" else {k: v for k, v in typed.items() if k == "start"})
    time = {"name": "time", "valueReference": str(max(len(code.shown), 1)), "causality": "independent"}
    SubElement(
        declared, "Float64", {**time, "variability": "continuous", "description": "simulation time", "unit": "s"}
    )
    structure = SubElement(root, "ModelStructure")
    known = at_the_start(found)
    for k, e in listed:
        if e.causality == OUTPUT:
            SubElement(structure, "Output", {"valueReference": str(k), "dependencies": ""})
    for k, e in listed:
        if e.causality in (OUTPUT, CALCULATED):
            depends = " ".join(map(str, known[k]))
            SubElement(structure, "InitialUnknown", {"valueReference": str(k), "dependencies": depends})
    return written(root)


def build_description(found: Prepared, compiled: Iterable[str]) -> bytes:
    """`sources/buildDescription.xml`."""
    own: Mapping[str, tuple[str, ...]] = {f: o for unit in found.code.units for f, o in unit.options.items()}
    root = Element("fmiBuildDescription", {"fmiVersion": "3.0"})
    configuration = SubElement(root, "BuildConfiguration", {"modelIdentifier": found.code.name})
    sets: dict[tuple[str, ...], list[str]] = {}
    for name in compiled:
        sets.setdefault(own.get(name, ()), []).append(name)
    for options, names in sets.items():
        words = " ".join(option for option in OPTIONS if not option.startswith("-std="))
        files = SubElement(
            configuration, "SourceFileSet", {"language": "C11", "compiler": "gcc", "compilerOptions": words}
        )
        for name in names:
            SubElement(files, "SourceFile", {"name": name})
        for folder in (".", *(option[2:] for option in options)):
            SubElement(files, "IncludeDirectory", {"name": folder})
    return written(root)


def unsupported(layer: str) -> str:
    """The functions of FMI 3.0 that the text of a layer does not define, each refused with a message."""
    text = (HEADERS / "fmi3FunctionTypes.h").read_text(encoding="utf-8")
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    found = re.findall(r"typedef\s+fmi3Status\s+(fmi3\w+)TYPE\s*\(([^;]*?)\)\s*;", text)
    there = set(re.findall(r"\b(fmi3\w+)\(", layer))
    there |= {
        f"fmi3{verb}{name}" for verb in ("Get", "Set") for name in re.findall(r"^(?:BOTH|GET|SET)\((\w+),", layer, re.M)
    }
    lines = []
    for name, arguments in found:
        if name in there:
            continue
        flat = " ".join(arguments.split())
        words = [re.sub(r"\[\]$", "", a.strip()).split()[-1].lstrip("*") for a in flat.split(",")]
        unused = ", ".join(f"(void){word}" for word in words[1:])
        lines.append(f"FMI3_Export fmi3Status {name}({flat.replace('fmi3Instance instance', 'fmi3Instance c', 1)}) {{")
        lines += [*([f"    {unused};"] if unused else []), f'    return unsupported(c, "{name}");', "}", ""]
    return "\n".join(lines)
