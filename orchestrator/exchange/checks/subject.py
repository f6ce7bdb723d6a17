"""The FMU under check: what its files say, of FMI 1.0, 2.0 or 3.0, before anything of it is run."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from math import prod
from pathlib import Path
from typing import Any

import fmpy
from fmpy.model_description import ModelDescription, ModelVariable

from ...errors import FmuError
from ...fmu.files.archive import opened
from ...fmu.files.binary import check_identifiers, find_library, platform_folder
from ...fmu.files.unpacked import archive_of, unpack
from ...fmu.kinds import interface_of, require_kind, usual_kind
from ...fmu.reading.description import described
from ...fmu.reading.details import Details
from ...fmu.tolerant.rules import Note, Notes

STEP = 1e-3  # s, where the FMU suggests none
# folder names of binaries, by FMI version: the one of this machine's and all that the standards name
EARLY = ("darwin64", "linux32", "linux64", "win32", "win64")
PLATFORMS = {
    1: EARLY,
    2: EARLY,
    3: ("aarch64-darwin", "aarch64-linux", "aarch64-windows", "x86-linux", "x86-windows", "x86_64-darwin",
        "x86_64-linux", "x86_64-windows"),
}  # fmt: skip
SUFFIXES = {"darwin": ".dylib", "linux": ".so", "win": ".dll"}


@dataclass(frozen=True)
class Subject:
    """An unpacked FMU of FMI 1.0, 2.0 or 3.0 that can be run."""

    path: Path
    folder: Path
    version: int
    description: ModelDescription
    notes: tuple[Note, ...] = ()  # where it breaks the standard, and how that was taken
    negated: frozenset[str] = frozenset()  # variables that are another one with the other sign (FMI 1.0)
    details: Details = field(default_factory=dict)  # what else is said of variables (FMI 3.0)

    @property
    def archive(self) -> Path:
        """The archive as a file."""
        return archive_of(self.path, self.folder)

    @cached_property
    def variables(self) -> list[ModelVariable]:
        """All variables but FMI 3.0's time and clocks."""
        return [v for v in self.description.modelVariables if v.causality != "independent" and v.type != "Clock"]

    def of(self, *causalities: str) -> list[ModelVariable]:
        """The variables with one of the causalities."""
        return [v for v in self.variables if v.causality in causalities]

    @property
    def interface(self) -> Any:
        """The element of the kind that it is run as; its flags have the same names for all versions."""
        return interface_of(self.description, usual_kind(self.description))

    @cached_property
    def step(self) -> float:
        """The communication step that the FMU suggests [s]; 1 ms where it suggests none."""
        experiment = self.description.defaultExperiment
        suggested = experiment.stepSize if experiment else None
        return float(suggested or getattr(self.interface, "fixedInternalStepSize", None) or STEP)

    @cached_property
    def start_time(self) -> float:
        """Start of the default experiment [s]."""
        experiment = self.description.defaultExperiment
        return float((experiment.startTime if experiment else None) or 0.0)

    @cached_property
    def binaries(self) -> dict[str, list[str]]:
        """File names by platform folder."""
        folders = sorted(p for p in (self.folder / "binaries").glob("*") if p.is_dir())
        return {p.name: sorted(f.name for f in p.iterdir() if f.is_file()) for p in folders}

    @property
    def platform(self) -> str:
        """This machine's folder name in the FMU's version of the standard."""
        return platform_folder(self.version) or str(fmpy.platform_tuple)  # FMI 1.0 and 2.0 have none for Linux on ARM


def suffix(platform: str) -> str:
    """The shared library suffix of a platform folder."""
    return next((s for part, s in SUFFIXES.items() if platform.split("-")[-1].startswith(part)), "")


def size(variable: ModelVariable) -> int:
    """Number of elements; 1 for a scalar."""
    return prod(variable.shape or ())


def numbers(text: str | None) -> list[float]:
    """The numbers in an XML attribute: none, one, or one per element of an array."""
    return [float({"true": 1, "false": 0}.get(word, word)) for word in text.split()] if text else []


def bounds(variable: ModelVariable) -> tuple[float | None, float | None]:
    """min and max."""
    low, high = variable.min, variable.max
    return (None if low is None else float(low)), (None if high is None else float(high))


def open_subject(path: Path) -> Subject:
    """Unpack and read. Raises FmuError: not readable, no co-simulation; the text says how to go on."""
    folder, _ = unpack(path)
    notes = Notes()
    with opened(archive_of(path, folder), notes=notes):
        found = described(path, folder)
    require_kind(path, found.description)
    interface = interface_of(found.description, usual_kind(found.description))
    with suppress(FmuError):  # none for this machine is a row of its own
        check_identifiers(path, found.description, notes)
        find_library(path, folder, found.description, interface, notes)
    version = int(found.description.fmiMajorVersion)
    notes_of_it = (*found.notes, *notes.all())
    return Subject(path, folder, version, found.description, notes_of_it, found.negated, found.details)
