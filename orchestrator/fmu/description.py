"""Reading a model description from a stranger: safe XML, the version, and errors that say what to ask for instead."""

from __future__ import annotations

from itertools import product
from math import prod
from pathlib import Path
from typing import Any

import fmpy
from attrs import evolve
from fmpy.model_description import ModelDescription, ModelVariable

from ..errors import FmuError

LARGEST_XML = 64 << 20  # bytes
LARGEST_ARRAY = 100_000  # elements; every one is a signal with a name


def read_description(path: Path, folder: Path) -> tuple[ModelDescription, dict[str, list[str]]]:
    """The description of an unpacked FMU, and its texts by variable. Raises FmuError for what cannot be run."""
    xml = folder / "modelDescription.xml"
    if not xml.is_file():
        raise FmuError(f"FMU {path} has no modelDescription.xml; it is not an FMU, or not a complete one")
    root = safe_xml(path, xml)
    version = root.get("fmiVersion")
    if version is None or (version != "2.0" and not version.startswith("3.")):
        known = "1.0" if version == "1.0" else ""
        remedy = "export it again as FMI 2.0 or 3.0 for co-simulation" if known else "2.0 and 3.x can be run"
        raise FmuError(f"FMU {path} is of FMI version {version}; version 2.0 or 3.0 is needed: {remedy}")
    if (folder / "sources" / "buildDescription.xml").is_file():
        safe_xml(path, folder / "sources" / "buildDescription.xml")
    try:
        description = fmpy.read_model_description(str(folder), validate=True)
    except Exception as error:
        raise FmuError(f"FMU {path}: its modelDescription.xml is not valid: {_reason(error)}") from error
    if description.coSimulation is None:
        kind = "model exchange" if description.modelExchange else "scheduled execution"
        raise FmuError(f"FMU {path} is for {kind} only; export it for co-simulation")
    _check_binary(path, folder, description)
    texts = {
        e.get("name"): [start.get("value") for start in e.iterfind("Start")]
        for e in root.iterfind("ModelVariables/String")
    }
    return description, texts


def _reason(error: Exception) -> str:
    """The text of an error about a description; some only name what is missing."""
    if isinstance(error, (KeyError, IndexError, AttributeError, TypeError)):
        return f"it refers to something that it does not define ({error})"
    return str(error).strip()


def safe_xml(path: Path, xml: Path) -> Any:
    """The root of an XML file. One that is huge, or declares a document type (entities, other files), is refused."""
    from lxml import etree

    name = xml.name
    if xml.stat().st_size > LARGEST_XML:
        raise FmuError(f"FMU {path}: its {name} has more than {LARGEST_XML >> 20} MB; refused")
    try:
        tree = etree.parse(str(xml), etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False))
    except etree.XMLSyntaxError as error:
        raise FmuError(f"FMU {path}: its {name} is not well-formed: {error}") from error
    if tree.docinfo.doctype:
        raise FmuError(f"FMU {path}: its {name} has a document type declaration; refused")
    return tree.getroot()


def platform_folder(description: ModelDescription) -> str:
    """Name of the folder with the binary for this machine."""
    return str(fmpy.platform if description.fmiVersion == "2.0" else fmpy.platform_tuple)


def _check_binary(path: Path, folder: Path, description: ModelDescription) -> None:
    platform, identifier = platform_folder(description), description.coSimulation.modelIdentifier
    if (folder / "binaries" / platform / f"{identifier}{fmpy.sharedLibraryExtension}").is_file():
        return
    there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
    sources = any((folder / "sources").glob("**/*.c*"))
    remedy = (
        f"; it carries its sources, which can be compiled: `fmpy compile {path}`"
        if sources
        else "; ask for a binary of this platform, or for the sources"
    )
    raise FmuError(f"FMU {path} has no binary for {platform}; it has {', '.join(there)}{remedy}")


def scalars_of(path: Path, variable: ModelVariable, texts: dict[str, list[str]]) -> dict[str, ModelVariable]:
    """A variable as scalars: itself, or the elements `u[1]`, `M[1,2]` of an FMI 3 array, each with its own start."""
    if not variable.shape:
        return {variable.name: variable}
    if prod(variable.shape) > LARGEST_ARRAY:
        raise FmuError(f"FMU {path}: array {variable.name} has more than {LARGEST_ARRAY} elements; refused")
    if variable.type == "String":
        name = variable.alias.name if variable.alias is not None else variable.name
        starts = texts[name]
    else:
        starts = (variable.start or "").split()
    count = prod(variable.shape)
    if len(starts) not in (0, 1, count):
        raise FmuError(f"FMU {path}: array {variable.name} has {count} elements and {len(starts)} start values")
    values: list[str | None] = list(starts) if len(starts) == count else [starts[0] if starts else None] * count
    indices = product(*(range(1, n + 1) for n in variable.shape))
    return {
        f"{variable.name}[{','.join(map(str, index))}]": evolve(
            variable, name=f"{variable.name}[{','.join(map(str, index))}]", shape=(), start=start
        )
        for index, start in zip(indices, values, strict=True)
    }
