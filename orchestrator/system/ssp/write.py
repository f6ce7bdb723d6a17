"""System -> SSP: one .ssp file with the FMUs, the structure, and the values of each component as a parameter set."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path
from typing import Any

from fmpy.model_description import ModelVariable
from lxml import etree

from ...errors import InputError
from ...files import prepare_folder, write_file
from ...fmu.fmu import Fmu
from ..component import Component
from ..connection import Connection
from ..inputs.series import refuse_series
from ..model import System
from ..replace.view import crossings_of
from .files.annotations import annotate, component_keys, connection_keys, system_keys
from .files.document import NAMESPACES, validate
from .files.hints import NAMESPACE as OSP
from .files.hints import hint_base_step, hint_step

VERSIONS = ("1.0", "2.0")
EARLIEST = (1980, 1, 1, 0, 0, 0)  # the date of every entry: the same system, the same file
TYPES = {**dict.fromkeys(("Real", "Float64", "Float32"), "Real"), **{t: t for t in ("Boolean", "String", "Binary")}}
KINDS = ("input", "output", "parameter")


def write_ssp(system: System, path: Path, ssp_version: str = "1.0") -> Path:
    """Write a system as an SSP of version 1.0 (validated by its schemas) or 2.0. Raises InputError or RunError."""
    if ssp_version not in VERSIONS:
        raise InputError(f"SSP version {ssp_version!r} cannot be written; take {' or '.join(VERSIONS)}")
    refuse_series(system, "is not written to an SSP")
    for name, component in system.components.items():
        component.require_file("an SSP is made of FMUs only")
        if crossings_of(component.fmu):
            raise InputError(f"component {name} has its variables mapped, which is not written to an SSP")
    prepare_folder(path.parent)
    files = resource_names(system)
    structure = structure_of(system, files, ssp_version)
    entries: dict[str, bytes | Path] = {"SystemStructure.ssd": _text(structure)}
    for name, component in system.components.items():
        values = parameter_set(component, system.name, ssp_version)
        entries[f"resources/{name}.ssv"] = _text(values)
        entries[files[name]] = component.fmu.archive
    if ssp_version == "1.0":
        for shown, content in entries.items():
            if isinstance(content, bytes):
                validate(etree.fromstring(content), shown)
    return write_file(path, lambda temporary: _pack(temporary, entries))


def resource_names(system: System) -> dict[str, str]:
    """Where each component's FMU goes: under its own name, once for all components that share it."""
    names: dict[str, str] = {}
    digests: dict[str, str] = {}
    for name, component in system.components.items():
        fmu = component.fmu
        place = f"resources/{fmu.path.name}" if fmu.path.suffix == ".fmu" else f"resources/{fmu.path.stem}.fmu"
        if digests.setdefault(place, fmu.digest) != fmu.digest:  # another FMU of the same name
            place = f"resources/{fmu.path.stem}_{fmu.digest[:8]}.fmu"
            digests[place] = fmu.digest
        names[name] = place
    return names


def structure_of(system: System, files: Mapping[str, str], ssp_version: str) -> Any:
    """The SystemStructureDescription of a system."""
    root = _root("ssd", "SystemStructureDescription", ssp_version, system.name)
    if system.description:
        root.set("description", system.description)
    top = _add(root, "ssd:System", name="system")
    elements = _add(top, "ssd:Elements")
    units = _units(component.fmu for component in system.components.values())
    for name, component in system.components.items():
        element = _add(elements, "ssd:Component", name=name, source=files[name], type="application/x-fmu-sharedlibrary")
        _connectors(element, component.fmu, units)
        bindings = _add(element, "ssd:ParameterBindings")
        _add(bindings, "ssd:ParameterBinding", source=f"resources/{name}.ssv")
        annotate(element, component_keys(component))
        hint_step(element, component.period)
    if system.connections:
        connections = _add(top, "ssd:Connections")
        for connection in system.connections:
            _connection(connections, system, connection)
    _add_units(root, "ssd:Units", units)
    times = {"start": repr(float(system.start)), "stop": repr(float(system.stop))}
    experiment = _add(root, "ssd:DefaultExperiment", startTime=times["start"], stopTime=times["stop"])
    hint_base_step(experiment, min(component.period for component in system.components.values()))
    exact = {key: getattr(system, key) for key in times}
    rounded = {f"{key}_time": f"{time} s" for key, time in exact.items() if Fraction(times[key]) != time}
    annotate(root, system_keys(system) | rounded)
    return root


def parameter_set(component: Component, set_name: str, ssp_version: str) -> Any:
    """The values of one component as a ParameterSet, in the order in which they are set."""
    root = _root("ssv", "ParameterSet", ssp_version, set_name)
    parameters = _add(root, "ssv:Parameters")
    units = _units([component.fmu])
    for name, value in {**component.fmu.structure, **component.parameters, **component.inputs}.items():
        variable = component.fmu.variables[name]
        entry = _add(_add(parameters, "ssv:Parameter", name=name), f"ssv:{_type(variable)}")
        value = value.hex() if isinstance(value, bytes) else value
        entry.set("value", str(value).lower() if isinstance(value, bool) else str(value))
        if variable.unit in units and _type(variable) == "Real":
            entry.set("unit", variable.unit)
    _add_units(root, "ssv:Units", units)
    return root


def _connectors(element: Any, fmu: Fmu, units: Mapping[str, Any]) -> None:
    variables = {name: v for name, v in fmu.variables.items() if v.causality in KINDS and v.type != "Clock"}
    connectors = _add(element, "ssd:Connectors") if variables else None
    for name, variable in variables.items():
        connector = _add(connectors, "ssd:Connector", name=name, kind=variable.causality)
        typed = _add(connector, f"ssc:{_type(variable)}")
        if variable.unit in units and _type(variable) == "Real":
            typed.set("unit", variable.unit)


def _connection(parent: Any, system: System, connection: Connection) -> None:
    (source, output), (target, input_) = connection.source, connection.target
    ends = {"startElement": source, "startConnector": output, "endElement": target, "endConnector": input_}
    element = _add(parent, "ssd:Connection", **ends)
    units = [system.components[name].fmu.variables[end].unit for name, end in (connection.source, connection.target)]
    if (connection.gain, connection.offset) != (1.0, 0.0) or units[0] != units[1]:
        element.set("suppressUnitConversion", "true")  # it is in the transformation, for tools that convert nothing
        linear = {"factor": repr(connection.gain), "offset": repr(connection.offset)}
        _add(element, "ssc:LinearTransformation", **linear)
    annotate(element, connection_keys(connection))


def _type(variable: ModelVariable) -> str:
    """The SSP type of an FMI variable: enumerations by their numbers."""
    return TYPES.get(variable.type, "Integer")


def _units(fmus: Any) -> dict[str, Any]:
    """The units that the FMUs define, by name; fmpy's."""
    return {unit.name: unit for fmu in fmus for unit in fmu.description.unitDefinitions or ()}


def _add_units(parent: Any, tag: str, units: Mapping[str, Any]) -> None:
    entries = _add(parent, tag) if units else None
    for name, unit in units.items():
        base = unit.baseUnit
        exponents = {key: getattr(base, key, 0) for key in ("kg", "m", "s", "A", "K", "mol", "cd", "rad")}
        numbers = {"factor": float(getattr(base, "factor", 1.0)), "offset": float(getattr(base, "offset", 0.0))}
        texts = {key: str(int(value)) for key, value in exponents.items() if value}
        texts |= {key: repr(value) for key, value in numbers.items() if value != (key == "factor")}
        _add(_add(entries, "ssc:Unit", name=name), "ssc:BaseUnit", **texts)


def _root(prefix: str, tag: str, ssp_version: str, name: str) -> Any:
    own = {key: NAMESPACES[key] for key in ("ssc", prefix)}
    hints = {"osp": OSP} if prefix == "ssd" else {}  # at the root: libcosim takes a declaration below for content
    element = etree.Element(f"{{{NAMESPACES[prefix]}}}{tag}", nsmap=own | hints)
    element.set("version", ssp_version)
    element.set("name", name)
    element.set("generationTool", f"rovbrush {version('rovbrush')}")
    return element


def _add(parent: Any, tag: str, **attributes: str) -> Any:
    prefix, _, name = tag.partition(":")
    return etree.SubElement(parent, f"{{{NAMESPACES[prefix]}}}{name}", **attributes)


def _text(element: Any) -> bytes:
    content: bytes = etree.tostring(element, xml_declaration=True, encoding="UTF-8", pretty_print=True)
    return content


def _pack(path: Path, entries: Mapping[str, bytes | Path]) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            data = content.read_bytes() if isinstance(content, Path) else content
            archive.writestr(zipfile.ZipInfo(name, EARLIEST), data, zipfile.ZIP_DEFLATED)
