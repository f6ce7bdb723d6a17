"""The FMI 2.0 model description of a whole system.

References: FMI 2.0.4, sections 2.2.3 (UnitDefinitions), 2.2.7 (ModelVariables), 2.2.8 (ModelStructure),
4.3.1 (CoSimulation).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from importlib.metadata import version
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from ..fmu.attributes import items_of
from ..fmu.types import BOOLEAN, TEXT
from ..units import Definition
from .code.exposed import CALCULATED, HIDDEN, INPUT, OUTPUT, PARAMETER, TUNABLE, Exposed
from .dependencies import at_the_start
from .prepared import Prepared

SMALL = ("Integer", "Enumeration", "Int8", "UInt8", "Int16", "UInt16", "Int32")  # what an Integer of FMI 2.0 can hold
NO_CHARACTER = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")  # of XML 1.0
BASE = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")


def type2(e: Exposed) -> str:
    """The type in FMI 2.0; empty where none holds all of its values."""
    kind = e.kind
    if kind.real:
        return "Real"
    if kind.code in (BOOLEAN, TEXT):
        return "Boolean" if kind.code == BOOLEAN else "String"
    items = items_of(e.variable).values() if e.variable is not None else ()
    if kind.name == "Enumeration" and kind.size > 4:  # of FMI 3.0
        return "Integer" if items and all(abs(item) < 2**31 for item in items) else ""
    return "Integer" if kind.name in SMALL else ""


def variables2(shown: Iterable[Exposed]) -> list[tuple[int, Exposed]]:
    """What FMI 2.0 can show, each with its number."""
    return [(k, e) for k, e in enumerate(shown) if e.causality != HIDDEN and type2(e)]


def description2(found: Prepared, guid: str, sources: Iterable[str]) -> bytes:
    """`modelDescription.xml`; `sources`: the files to be compiled, by path in the folder `sources`."""
    plan, code = found.plan, found.code
    root = Element("fmiModelDescription", {
        "fmiVersion": "2.0", "modelName": plan.system.name, "guid": guid, "description": plan.system.description,
        "generationTool": made_by(), "variableNamingConvention": convention(code.shown),
    })  # fmt: skip
    states = {key.replace("State", "state"): value for key, value in can_save(found).items()}
    interface = SubElement(root, "CoSimulation", {
        "modelIdentifier": code.name, "needsExecutionTool": "false",
        "canHandleVariableCommunicationStepSize": str(found.plan.adaptive).lower(),
        "canInterpolateInputs": "false", "canBeInstantiatedOnlyOncePerProcess": once(found),
        "canNotUseMemoryManagementFunctions": "true", **states,
    })  # fmt: skip
    files = list(sources)
    if files:
        element = SubElement(interface, "SourceFiles")
        for name in files:
            SubElement(element, "File", {"name": name})
    add_units(root, found)
    categories = SubElement(root, "LogCategories")
    SubElement(categories, "Category", {"name": "logAll", "description": "what components say"})
    SubElement(categories, "Category", {"name": "logStatusWarning", "description": "what may be wrong"})
    SubElement(categories, "Category", {"name": "logStatusError", "description": "what went wrong"})
    SubElement(root, "DefaultExperiment", experiment(found))
    listed = variables2(code.shown)
    scalars = SubElement(root, "ModelVariables")
    for k, e in listed:
        element = SubElement(scalars, "ScalarVariable", attributes(e, k))
        kind = type2(e)
        typed = typed_attributes(e, kind == "Real")
        SubElement(
            element, kind, typed if kind in ("Real", "Integer") else {k: v for k, v in typed.items() if k == "start"}
        )
    structure = SubElement(root, "ModelStructure")
    outputs, unknowns = Element("Outputs"), Element("InitialUnknowns")
    known, places = at_the_start(found), {k: str(index) for index, (k, _) in enumerate(listed, 1)}
    for index, (k, e) in enumerate(listed, 1):
        if e.causality == OUTPUT:  # read at communication points: inputs act on them in the next step
            SubElement(outputs, "Unknown", {"index": str(index), "dependencies": ""})
        if e.causality in (OUTPUT, CALCULATED):
            depends = " ".join(places[j] for j in known[k] if j in places)
            SubElement(unknowns, "Unknown", {"index": str(index), "dependencies": depends})
    structure.extend(element for element in (outputs, unknowns) if len(element))
    return written(root)


def made_by() -> str:
    """What writes these files; not the words of a component, which are another kind of FMU."""
    return f"rovbrush-export {version('rovbrush')}"


QUOTED = r"'(?:[\w!#$%&()*+,./:;<>=?@\[\]^{}|~ -]|\\['\"?\\abfnrtv])+'"
NAME = rf"(?:[A-Za-z_]\w*|{QUOTED})(?:\[\d+(?:,\d+)*\])?"
NAMES = rf"{NAME}(?:\.{NAME})*"
STRUCTURED = re.compile(rf"{NAMES}|der\({NAMES}(?:,\d+)?\)", re.ASCII)  # `a.der(x)` is none, `der(a.x)` is


def convention(shown: Iterable[Exposed]) -> str:
    """How variables are called (FMI 2.0.4, section 2.2.9): where the name of one does not follow its rules, anyhow."""
    names = (e.name for e in shown if e.causality != HIDDEN)
    return "structured" if all(STRUCTURED.fullmatch(name) for name in names) else "flat"


def once(found: Prepared) -> str:
    """Whether a process can have one instance only, as one of the components says."""
    return str(
        any(c.fmu.interface.canBeInstantiatedOnlyOncePerProcess for c in found.plan.system.components.values())
    ).lower()


def can_save(found: Prepared) -> dict[str, str]:
    """Whether all components can save their states, and write them."""
    fmus = [c.fmu for c in found.plan.system.components.values()]
    return {
        "canGetAndSetFMUState": str(all(fmu.can_save_state for fmu in fmus)).lower(),
        "canSerializeFMUState": str(all(fmu.can_serialize_state for fmu in fmus)).lower(),
    }


def experiment(found: Prepared) -> dict[str, str]:
    """From the system's start to its stop, by its fastest period."""
    clock = found.plan.clock
    step = Fraction(min(component.period for component in found.plan.system.components.values()))
    if found.plan.algorithm.saves_states and not found.plan.adaptive:  # its macro steps are whole
        step = clock.seconds(clock.hyperperiod)
    stop = found.plan.system.stop
    return {"startTime": repr(clock.time(0)), "stopTime": repr(float(stop)), "stepSize": repr(float(step))}


def attributes(e: Exposed, number: int) -> dict[str, str]:
    """Name, description, causality, variability, initial: the same words in FMI 2.0 and 3.0."""
    made = {"name": e.name, "valueReference": str(number)}
    if e.description:
        made["description"] = e.description
    made["causality"] = {TUNABLE: PARAMETER, CALCULATED: "calculatedParameter"}.get(e.causality, e.causality)
    stated = e.variable.variability if e.variable is not None else None
    if e.causality in (PARAMETER, TUNABLE, CALCULATED):
        made["variability"] = "tunable" if e.causality == TUNABLE or stated == "tunable" else "fixed"
    else:
        made["variability"] = "discrete" if not e.kind.real or stated == "discrete" else "continuous"
    if e.causality in (PARAMETER, TUNABLE):
        made["initial"] = "exact"
    elif e.causality != INPUT:
        made["initial"] = "calculated"
    return made


def typed_attributes(e: Exposed, real: bool) -> dict[str, str]:
    """Unit, range and start value."""
    made = {"unit": e.unit} if real and e.unit else {}
    if e.variable is not None and e.kind.name != "Boolean":
        for key in ("min", "max"):
            bound = getattr(e.variable, key)
            if bound is not None:
                made[key] = str(bound)
    if e.causality in (PARAMETER, TUNABLE, INPUT):
        made["start"] = _literal(e)
    return made


def _literal(e: Exposed) -> str:
    if isinstance(e.start, bool) or e.kind.code == BOOLEAN:
        return str(bool(e.start)).lower()
    if not e.kind.real or isinstance(e.start, (str, bytes)):
        return str(e.start)
    return repr(float(e.start)).replace("inf", "INF").replace("nan", "NaN")  # as XML writes them


def add_units(root: Element, found: Prepared, more: Iterable[str] = ()) -> None:
    """The units of all that is shown, as the first FMU that has one defines it."""
    definitions = {"s": Definition((0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0))}
    for component in reversed(list(found.plan.system.components.values())):
        definitions |= component.fmu.definitions
    units = dict.fromkeys([*(e.unit for _, e in variables2(found.code.shown) if e.unit and e.kind.real), *more])
    if not units:
        return
    element = SubElement(root, "UnitDefinitions")
    for name in units:
        unit = SubElement(element, "Unit", {"name": name})
        definition = definitions.get(name)
        if definition is None or any(x != int(x) for x in definition.exponents):
            continue
        base = {key: str(int(x)) for key, x in zip(BASE, definition.exponents, strict=True) if x}
        if definition.factor != 1.0:
            base["factor"] = repr(definition.factor)
        if definition.offset != 0.0:
            base["offset"] = repr(definition.offset)
        SubElement(unit, "BaseUnit", base)


def written(root: Element) -> bytes:
    """An XML file."""
    for element in root.iter():
        element.attrib.update({key: NO_CHARACTER.sub("\ufffd", value) for key, value in element.attrib.items()})
    indent(root)
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root) + b"\n"
