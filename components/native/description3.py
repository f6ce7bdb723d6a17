"""The FMI 3.0 model description of a component, and the build description of its sources.

References: FMI 3.0.1, sections 2.4 (model description), 2.4.7 (variables; arrays by Dimension) and 2.5.1.1 (sources).
"""

from __future__ import annotations

from typing import Any
from xml.etree.ElementTree import Element, SubElement

from ..declare.interface import Variable
from ..declare.model_description import GUID_PLACEHOLDER, VERSION, add_definitions, type_attributes, variable_attributes

TYPES = {"Real": "Float64", "Integer": "Int32", "Boolean": "Boolean"}


def model_description3(component: type[Any]) -> Element:
    """The `fmiModelDescription` element; the value reference of a variable is the place of its first element."""
    variables: tuple[Variable, ...] = component.variables()
    name = component.component_name()
    root = Element("fmiModelDescription", {
        "fmiVersion": "3.0", "modelName": name, "instantiationToken": GUID_PLACEHOLDER,
        "description": (component.__doc__ or "").strip().splitlines()[0], "version": VERSION, "license": "MIT",
        "generationTool": f"rovbrush {VERSION}", "variableNamingConvention": "structured",
    })  # fmt: skip
    SubElement(root, "CoSimulation", {
        "modelIdentifier": name, "needsExecutionTool": "false", "canBeInstantiatedOnlyOncePerProcess": "false",
        "canGetAndSetFMUState": "true", "canSerializeFMUState": "true",
        "canHandleVariableCommunicationStepSize": "true",
    })  # fmt: skip
    add_definitions(root, component, variables, more_units=("s",))  # of the time
    references: dict[str, int] = {}
    places = 0
    declared = SubElement(root, "ModelVariables")
    for v in variables:
        references[v.name] = places
        places += len(v.start)
        element = SubElement(declared, TYPES[v.kind], variable_attributes(v, v.name, references[v.name]))
        element.attrib.update(type_attributes(v, v.start))
        if v.size:
            SubElement(element, "Dimension", {"start": str(v.size)})
    time = {"name": "time", "valueReference": str(places), "causality": "independent", "variability": "continuous"}
    SubElement(declared, "Float64", {**time, "description": "simulation time", "unit": "s"})
    _model_structure(root, variables, references, component.started_by())
    return root


def _model_structure(
    root: Element, variables: tuple[Variable, ...], references: dict[str, int], started_by: set[str]
) -> None:
    structure = SubElement(root, "ModelStructure")
    parameters = [references[v.name] for v in variables if v.causality == "parameter"]
    outputs = [v for v in variables if v.causality == "output"]
    calculated = [v for v in variables if v.causality == "calculatedParameter"]
    for v in outputs:
        inputs = sorted(references[name] for name in v.depends)
        SubElement(structure, "Output", _unknown(references[v.name], inputs))
    for v in (*outputs, *calculated):
        at_start = sorted(references[name] for name in {*v.depends, *started_by})
        SubElement(structure, "InitialUnknown", _unknown(references[v.name], parameters + at_start))


def _unknown(reference: int, dependencies: list[int]) -> dict[str, str]:
    return {"valueReference": str(reference), "dependencies": " ".join(map(str, dependencies))}


def build_description(name: str, sources: tuple[str, ...], options: str) -> Element:
    """`sources/buildDescription.xml`."""
    root = Element("fmiBuildDescription", {"fmiVersion": "3.0"})
    configuration = SubElement(root, "BuildConfiguration", {"modelIdentifier": name})
    files = SubElement(configuration, "SourceFileSet", {"language": "C11", "compilerOptions": options})
    for source in sources:
        SubElement(files, "SourceFile", {"name": source})
    return root
