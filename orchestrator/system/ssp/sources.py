"""What stands behind a component of an SSD: an FMU, another SSD or SSP, or a system of the same file once more."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...errors import FmuError, InputError, shown
from ...fmu.fmu import Fmu
from ...fmu.kinds import CO_SIMULATION, MODEL_EXCHANGE, SCHEDULED_EXECUTION, WORDS, Kind
from .files.archive import Archive
from .files.document import Document, find
from .files.rules import KIND_OF_SOURCE

FMU, DEFINITION, PACKAGE = (
    "application/x-fmu-sharedlibrary",
    "application/x-ssp-definition",
    "application/x-ssp-package",
)
IMPLEMENTATIONS: dict[str, Kind] = {  # an FMU of several kinds is taken for the first of its own, whatever is wanted
    "CoSimulation": CO_SIMULATION, "ModelExchange": MODEL_EXCHANGE, "ScheduledExecution": SCHEDULED_EXECUTION,
}  # fmt: skip


@dataclass(frozen=True)
class Open:
    """What is being read: the structure files and parts of them, from the outermost on."""

    places: tuple[object, ...]

    def deeper(self, place: object, label: str) -> Open:
        """Raises InputError for what would hold itself."""
        if place in self.places:
            raise InputError(f"{label}: it holds itself; take that source out")
        return Open((*self.places, place))


@dataclass(frozen=True)
class Nested:
    """A system from elsewhere in a component's place."""

    system: Any
    document: Document
    archive: Archive
    open_: Open


def source_of(document: Document, archive: Archive, xml: Any, open_: Open) -> Fmu | Nested:
    """Raises InputError or FmuError for what cannot be part of a run."""
    label = f"component '{shown(xml.get('name'))}'"
    try:
        return _source_of(document, archive, xml, open_, label)
    except InputError as error:
        where = document.at(xml)
        raise InputError(str(error) if where in str(error) else f"{error} {where}") from None


def _source_of(document: Document, archive: Archive, xml: Any, open_: Open, label: str) -> Fmu | Nested:
    type_, source = xml.get("type") or FMU, (xml.get("source") or "").strip()
    if not source:
        raise InputError(f"{label} has no source: nobody has built it yet; name its FMU in source")
    if type_ not in (FMU, DEFINITION, PACKAGE):
        raise InputError(f"{label} is of type {shown(type_)}; FMUs, SSDs and SSPs can be run")
    if source.startswith("#"):
        return _same_file(document, archive, source[1:], open_, label)
    address, _, fragment = source.partition("#")
    nested = [end for end in (".ssp", ".ssd") if address.lower().endswith(end)]
    file = archive.resolve(address if nested else source, label, document.notes)
    nested = nested or [".ssp"] * (type_ != FMU and file.is_dir())
    if bool(nested) != (type_ != FMU):
        document.notes.add(KIND_OF_SOURCE, f"{type_} for {source} {document.at(xml)}")
    if not nested:
        return _fmu(archive, file, xml, label)
    inner = archive.nested(file, fragment, document.notes)
    open_ = open_.deeper(inner.structure, label)
    read = Document(inner.structure, inner.shown(inner.structure), "SystemStructureDescription", document.notes)
    return Nested(find(read.root, "System")[0], read, inner, open_)


def _same_file(document: Document, archive: Archive, id_: str, open_: Open, label: str) -> Nested:
    """A system of the same file, by its id."""
    for system in document.root.iter("{*}System"):
        if system.get("id") == id_:
            return Nested(system, document, archive, open_.deeper((document.path, id_), label))
    raise InputError(f"{label}: the file has no system with id '{shown(id_)}'")


def _fmu(archive: Archive, file: Path, xml: Any, label: str) -> Fmu:
    wanted = xml.get("implementation") or "any"
    if wanted != "any" and wanted not in IMPLEMENTATIONS:
        raise InputError(f"{label}: {shown(wanted)} is not supported; CoSimulation is needed")
    try:
        return Fmu.open(file)
    except FmuError as error:
        raise FmuError(f"{label}: {error}".replace(str(file), archive.shown(file))) from None


def implementation_note(name: str, xml: Any, fmu: Fmu) -> str:
    """What the user must know of a component that is run otherwise than the file says."""
    wanted = xml.get("implementation") or "any"
    otherwise = IMPLEMENTATIONS.get(wanted, fmu.kind) != fmu.kind
    return f"{name}: the SSP wants {wanted}; the FMU is run in {WORDS[fmu.kind]}" if otherwise else ""
