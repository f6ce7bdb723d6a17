"""FMUs without C sources: their libraries carried inside of an exported FMU, and loaded from there."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path

from ..errors import InputError
from ..fmu.fmu import Fmu
from .compiling import Target
from .units import SOURCES, Unit

PLACES = "{prefix}/binaries/{platform}/{file}"


@dataclass(frozen=True)
class Places:
    """Where the libraries of a unit are in the folder of resources; empty where there is none for a platform."""

    linux: str
    windows: str


def members(version: int) -> list[str]:
    """The functions of FMI that a system calls, without their prefix."""
    return re.findall(r"\*(\w+);", (SOURCES / f"functions{version}.h").read_text(encoding="utf-8"))


def as_library(unit: Unit, name: str, system: str) -> Unit:
    """A unit whose library is loaded. Raises InputError where it brings none for this machine."""
    fmu = unit.fmu
    if fmu.compiled or fmu.windows or not fmu.library.is_relative_to(fmu.folder / "binaries"):
        raise InputError(
            f"component {name}: {fmu.path.name} brings no library for this machine that could be carried, and "
            f"{unit.why_not}; take --container, or an SSP (--ssp)"
        )
    places = places_of(unit)
    text = (SOURCES / "loading.c").read_text(encoding="utf-8")
    full = f"fmi{unit.version}"
    pointers = [f"{full}{m}TYPE *{unit.prefix}_{full}{m};" for m in members(unit.version)]
    found = [f"    FIND({m});" for m in members(unit.version)]
    for key, value in {
        "@PREFIX@": unit.prefix, "@SYSTEM@": system, "@VERSION@": str(unit.version), "@WINDOWS@": places.windows,
        "@LINUX@": places.linux, "@POINTERS@": "\n".join(pointers), "@FOUND@": "\n".join(found),
    }.items():  # fmt: skip
        text = text.replace(key, value)
    file = f"{system}_{unit.prefix}_load.c"
    functions = frozenset(f"{full}{m}" for m in members(unit.version))
    return replace(unit, loader=file, texts={file: text.encode()}, functions=functions)


def places_of(unit: Unit) -> Places:
    """Where its libraries go."""
    own, windows = unit.fmu.library, _for_windows(unit.fmu)
    linux = PLACES.format(prefix=unit.prefix, platform=own.parent.name, file=own.name)
    there = PLACES.format(prefix=unit.prefix, platform=windows.parent.name, file=windows.name) if windows else ""
    return Places(linux, there)


def _for_windows(fmu: Fmu) -> Path | None:
    identifier = fmu.interface.modelIdentifier
    places = (fmu.folder / "binaries" / folder / f"{identifier}.dll" for folder in ("win64", "x86_64-windows"))
    return next((path for path in places if path.is_file()), None)


def resources_of(unit: Unit) -> dict[str, bytes]:
    """The files of a unit in the folder of resources, by path: its own resources, and the libraries that are loaded,
    with what lies beside them."""
    folder = unit.fmu.folder
    found = _files(folder / "resources", f"{unit.prefix}/resources")
    if unit.loader:
        windows = _for_windows(unit.fmu)
        for library in filter(None, (unit.fmu.library, windows)):
            found |= _files(library.parent, f"{unit.prefix}/binaries/{library.parent.name}")
    return found


def _files(folder: Path, to: str) -> dict[str, bytes]:
    paths = sorted(path for path in folder.rglob("*") if path.is_file()) if folder.is_dir() else []
    return {f"{to}/{path.relative_to(folder).as_posix()}": path.read_bytes() for path in paths}


def runs_on(unit: Unit, target: Target) -> bool:
    """Whether there is a library, or C, of a unit for a platform."""
    return unit.in_c or target.ending == ".so" or bool(places_of(unit).windows)
