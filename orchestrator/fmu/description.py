"""Reading a model description from a stranger: what a run needs must be right, all else is mended and noted."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import fmpy
from fmpy.model_description import ModelDescription, read_build_description

from ..errors import FmuError
from ..units import Definition
from .attributes import resolve
from .binary import check_identifiers, find_library
from .definitions import definitions_of
from .tolerant.head import mend_head, version_of
from .tolerant.rules import BUILD, SCHEMA, Note, Notes
from .tolerant.structure import mend_structure
from .tolerant.variables import mend_variables
from .tolerant.xml import safe_xml

SCHEMAS = {2: "fmi2/fmi2ModelDescription.xsd", 3: "fmi3/fmi3ModelDescription.xsd"}
KINDS = {"modelExchange": "model exchange", "scheduledExecution": "scheduled execution"}


class Described(NamedTuple):
    """What a description says."""

    description: ModelDescription  # attributes of variables resolved: see `attributes.resolve`
    texts: dict[str, list[str]]  # start values of FMI 3 String variables, which can be arrays
    definitions: Mapping[str, Definition]  # of its units, by name
    notes: tuple[Note, ...] = ()  # where it breaks the standard, and how that was taken


def read_description(path: Path, folder: Path) -> Described:
    """The description of an unpacked FMU that can be run here. Raises FmuError for what cannot."""
    found = described(path, folder)
    check_identifiers(path, found.description)
    notes = Notes()
    find_library(path, folder, found.description, notes)
    return found._replace(notes=(*found.notes, *notes.all()))


def described(path: Path, folder: Path) -> Described:
    """The description of an unpacked FMU of FMI 2.0 or 3.0 with a co-simulation interface. Raises FmuError."""
    xml = folder / "modelDescription.xml"
    if not xml.is_file():
        raise FmuError(f"FMU {path} has no modelDescription.xml; it is not an FMU, or not a complete one")
    notes = Notes()
    root = safe_xml(path, xml, notes)
    if root.tag != "fmiModelDescription":
        raise FmuError(f"FMU {path}: its modelDescription.xml begins with <{root.tag}>; it describes no FMU")
    stated = root.get("fmiVersion")
    version = version_of(stated)
    if version is None:
        remedy = "export it again as FMI 2.0 or 3.0 for co-simulation" if stated == "1.0" else "2.0 and 3.x can be run"
        raise FmuError(f"FMU {path} is of FMI version {stated}; version 2.0 or 3.0 is needed: {remedy}")
    mend_head(root, version, path.stem, notes)
    stated_variables = len(root.findall("ModelVariables/*"))
    places = mend_variables(root, version, notes)
    if stated_variables and not places:
        raise FmuError(
            f"FMU {path}: none of its {stated_variables} variables can be understood as FMI {version}.0 writes them; "
            f"export it again, or correct fmiVersion"
        )
    mend_structure(root, version, places, notes)
    schema = _schema(version)
    if not schema.validate(root):
        for error in schema.error_log:
            notes.add(SCHEMA, f"line {error.line}: {error.message}")
    try:
        description = fmpy.read_model_description(_packed(path, folder, root, version, notes), validate=False)
    except FmuError:
        raise
    except Exception as error:
        raise FmuError(f"FMU {path}: its modelDescription.xml cannot be understood: {_reason(error)}") from error
    if description.coSimulation is None:
        there = " and ".join(kind for name, kind in KINDS.items() if getattr(description, name) is not None)
        what = f"is for {there} only" if there else "has no interface at all"
        raise FmuError(f"FMU {path} {what}; export it for co-simulation")
    resolve(description, root)
    texts = {
        e.get("name"): [start.get("value") for start in e.iterfind("Start")]
        for e in root.iterfind("ModelVariables/String")
    }
    return Described(description, texts, definitions_of(root), notes.all())


@cache
def _schema(version: int) -> Any:
    from lxml import etree

    return etree.XMLSchema(file=str(Path(fmpy.__file__).parent / "schema" / SCHEMAS[version]))


def _packed(path: Path, folder: Path, root: Any, version: int, notes: Notes) -> io.BytesIO:
    """The mended description and the one of the sources as fmpy reads them, which would open others by itself."""
    from lxml import etree

    content, build = io.BytesIO(), folder / "sources" / "buildDescription.xml"
    with zipfile.ZipFile(content, "w") as archive:
        archive.writestr("modelDescription.xml", etree.tostring(root, encoding="UTF-8"))
        if build.is_file() and version == 3:
            archive.writestr("sources/buildDescription.xml", etree.tostring(safe_xml(path, build), encoding="UTF-8"))
    if build.is_file() and version == 3:
        try:
            read_build_description(content, validate=False)
        except Exception as error:
            notes.add(BUILD, _reason(error))
            content = io.BytesIO()
            with zipfile.ZipFile(content, "w") as archive:
                archive.writestr("modelDescription.xml", etree.tostring(root, encoding="UTF-8"))
    elif build.is_file():
        safe_xml(path, build)
    return content


def _reason(error: Exception) -> str:
    """The text of an error about a description; some only name what is missing."""
    if isinstance(error, (KeyError, IndexError, AttributeError, TypeError)):
        return f"it refers to something that it does not define ({error})"
    return str(error).strip()
