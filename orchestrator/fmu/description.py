"""Reading a model description from a stranger: the version, and errors that say what to ask for instead."""

from __future__ import annotations

from pathlib import Path

import fmpy
from fmpy.model_description import ModelDescription

from ..errors import FmuError
from .binary import check_binary, check_identifiers
from .xml import safe_xml


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
    check_identifiers(path, description)
    if description.coSimulation is None:
        kind = "model exchange" if description.modelExchange else "scheduled execution"
        raise FmuError(f"FMU {path} is for {kind} only; export it for co-simulation")
    check_binary(path, folder, description)
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
