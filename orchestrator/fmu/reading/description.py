"""Reading a model description from a stranger: what a run needs must be right, all else is mended and noted."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import fmpy
from fmpy.model_description import ModelDescription, read_build_description

from ...errors import FmuError
from ...units import Definition
from ..attributes import resolve
from ..files.binary import check_identifiers, find_library
from ..fmi1.translate import as_fmi2, negated_names
from ..kinds import interface_of, kinds_of, require_kind, usual_kind
from ..tolerant.head import mend_head, mend_version, version_of
from ..tolerant.literals import mend_number
from ..tolerant.rules import BUILD, SCHEMA, SET_TWICE, START_MISSING, UNIT, UNITS_DIFFER, Note, Notes
from ..tolerant.structure import mend_structure
from ..tolerant.variables import mend_variables
from ..tolerant.xml import safe_xml
from .definitions import definitions_of
from .details import Details, details_of, leave_to_fmpy
from .terminals import Terminal, terminals_of

SCHEMAS = {1: "fmi1/fmiModelDescription.xsd", 2: "fmi2/fmi2ModelDescription.xsd", 3: "fmi3/fmi3ModelDescription.xsd"}


class Described(NamedTuple):
    """What a description says."""

    description: ModelDescription  # attributes of variables resolved: see `attributes.resolve`
    texts: dict[str, list[str]]  # start values of FMI 3 texts and bytes, which can be arrays
    definitions: Mapping[str, Definition]  # of its units, by name
    notes: tuple[Note, ...] = ()  # where it breaks the standard, and how that was taken
    negated: frozenset[str] = frozenset()  # variables that are another one with the other sign (FMI 1.0)
    details: Details = MappingProxyType({})  # what else is said of variables (FMI 3.0)
    terminals: Mapping[str, Terminal] = MappingProxyType({})  # by name, with those inside of others


def read_description(path: Path, folder: Path, compiled: bool = False, elsewhere: bool = False) -> Described:
    """The description of an unpacked FMU that can be run here, be it `compiled`, or `elsewhere`. Raises FmuError for
    what cannot."""
    found = described(path, folder)
    notes = Notes()
    check_identifiers(path, found.description, notes)
    require_kind(path, found.description)
    interface = interface_of(found.description, usual_kind(found.description))
    if not elsewhere:
        find_library(path, folder, found.description, interface, notes, compiled)
    return found._replace(notes=(*found.notes, *notes.all()))


def _instead(folder: Path) -> str:
    """What an archive without a description has, and how it becomes an FMU."""
    for place in (*folder.glob("*"), *folder.glob("*/*")):
        if place.name.lower() == "modeldescription.xml":
            found = place.relative_to(folder).as_posix()
            pack = "" if place.parent == folder else f": pack what is in the folder {place.parent.name}, not the folder"
            return f"it has {found}{pack or ', and capital letters matter: rename it'}"
    return "it is not an FMU, or not a complete one"


def described(path: Path, folder: Path) -> Described:
    """The description of an unpacked FMU of FMI 1.0, 2.0 or 3.0, of any kind. Raises FmuError."""
    xml = folder / "modelDescription.xml"
    if not xml.is_file():
        raise FmuError(f"FMU {path} has no modelDescription.xml; {_instead(folder)}")
    notes = Notes()
    root = safe_xml(path, xml, notes)
    if root.tag != "fmiModelDescription":
        raise FmuError(f"FMU {path}: its modelDescription.xml begins with <{root.tag}>; it describes no FMU")
    stated = root.get("fmiVersion")
    stated_version = version_of(stated)
    if stated_version is None:
        raise FmuError(
            f"FMU {path} is of FMI version {stated}; version 1.0, 2.0 or 3.0 is needed: these and 3.x can be run"
        )
    mend_version(root, stated_version, notes)
    version = max(stated_version, 2)  # in which it is written from here on
    if stated_version == 1:
        if root.find("CoSimulation") is not None or root.find("ModelStructure") is not None:
            raise FmuError(
                f"FMU {path} is of FMI version 1.0 and written as a later one; correct fmiVersion, or export it again"
            )
        _compare(root, 1, notes)
        as_fmi2(path, root, notes)
    details = details_of(root) if version == 3 else {}
    mend_head(root, version, path.stem, notes)
    if stated_version == 1:
        mend_number(root, "numberOfContinuousStates", notes, integer=True)
    stated_variables = len(root.findall("ModelVariables/*"))
    places = mend_variables(root, version, notes)
    if stated_variables and not places:
        raise FmuError(
            f"FMU {path}: none of its {stated_variables} variables can be understood as FMI {stated_version}.0 writes "
            f"them; export it again, or correct fmiVersion"
        )
    mend_structure(root, version, places, notes)
    if stated_version == 1:
        notes.leave_out(START_MISSING, UNIT, SET_TWICE, UNITS_DIFFER)  # FMI 1.0 does not ask for them
    else:
        _compare(root, version, notes)
    leave_to_fmpy(root)
    try:
        description = fmpy.read_model_description(_packed(path, folder, root, version, notes), validate=False)
    except FmuError:
        raise
    except Exception as error:
        raise FmuError(f"FMU {path}: its modelDescription.xml cannot be understood: {_reason(error)}") from error
    if not kinds_of(description):
        raise FmuError(f"FMU {path} has no interface at all; export it for co-simulation")
    description.fmiVersion = f"{stated_version}.0"
    if stated_version == 1:
        description.numberOfContinuousStates = max(int(root.get("numberOfContinuousStates", "0")), 0)
    if version == 3:
        _directional(description, root)
    resolve(description, root)
    texts = {
        e.get("name"): [start.get("value") for start in e.iterfind("Start")]
        for kind in ("String", "Binary")
        for e in root.iterfind(f"ModelVariables/{kind}")
    }
    terminals = terminals_of(path, folder, {v.name for v in description.modelVariables}, notes)
    negated = negated_names(root) if stated_version == 1 else frozenset[str]()
    return Described(description, texts, definitions_of(root), notes.all(), negated, details, terminals)


def _directional(description: ModelDescription, root: Any) -> None:
    """Whether kinds give directional derivatives: FMI 3.0 has another name for it, which fmpy does not read."""
    for element in root:
        if isinstance(element.tag, str) and element.get("providesDirectionalDerivatives") in ("true", "1"):
            name = f"{element.tag[:1].lower()}{element.tag[1:]}"
            if (interface := getattr(description, name, None)) is not None:
                interface.providesDirectionalDerivative = True


def _compare(root: Any, version: int, notes: Notes) -> None:
    """Note what is not as the schema of a version wants it."""
    schema = _schema(version)
    if not schema.validate(root):
        for error in schema.error_log:
            notes.add(SCHEMA, f"line {error.line}: {error.message}")


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
