"""Where an FMU keeps its library: what the folder and the file are called, and what to ask for if it is not there."""

from __future__ import annotations

import os
import re
from pathlib import Path

import fmpy
from fmpy.model_description import InterfaceType, ModelDescription

from ...errors import FmuError, listed
from ..tolerant.rules import IDENTIFIER, LIBRARY, PLATFORM, Notes
from .compiled import ASKED, compiled_library
from .places import not_for_here
from .sources import build_of
from .windows import FOLDERS, how_to_install, runs_windows, wine

C_NAME = r"[A-Za-z_][A-Za-z0-9_]*"
FILE_NAME = r"[^./\\\0-\x1f\x7f][^/\\\0-\x1f\x7f]*"  # stays in its folder
LONGEST = 200  # characters of an identifier: it becomes a file name


def check_identifiers(path: Path, description: ModelDescription, notes: Notes) -> None:
    """Notes a modelIdentifier that is no C identifier but can be a file's name.

    Raises FmuError for any other: it becomes a path, and could name any library. Of FMI 1.0 functions begin with it.
    """
    parts = (description.coSimulation, description.modelExchange, description.scheduledExecution)
    named = [part.modelIdentifier for part in (*parts, *description.buildConfigurations) if part is not None]
    for identifier in named:
        if is_identifier(identifier):
            continue
        if description.fmiVersion != "1.0" and is_file_name(identifier):
            notes.add(IDENTIFIER, repr(identifier))
        else:
            shown = identifier if len(str(identifier)) < 100 else f"{identifier[:100]}..."
            raise FmuError(
                f"FMU {path}: its modelIdentifier '{shown}' is no C identifier of at most {LONGEST} characters, and "
                f"libraries are found by it; name it, and the libraries in binaries/, with letters, digits and _"
            )


def is_identifier(name: str | None) -> bool:
    """Is a name from a description what the standard wants it to be?"""
    return name is not None and len(name) <= LONGEST and re.fullmatch(C_NAME, name) is not None


def is_file_name(name: str | None) -> bool:
    """May a name from a description be part of a path?"""
    return name is not None and len(name) <= LONGEST and re.fullmatch(FILE_NAME, name) is not None


def platform_folder(version: int) -> str:
    """Name of the folder with the binary for this machine; empty where FMI 1.0 and 2.0 have none for it."""
    if version == 3:
        return str(fmpy.platform_tuple)
    return "" if fmpy.platform_tuple in ("aarch64-linux", "aarch64-windows") else str(fmpy.platform)


def find_library(
    path: Path, folder: Path, description: ModelDescription, interface: InterfaceType, notes: Notes | None = None,
    compiled: bool = False,
) -> Path:  # fmt: skip
    """The library of an unpacked FMU for this machine and one of its interfaces, inside its `binaries`.

    One in the folder of another FMI version's name, or of another name where it is the only one, is taken and noted.
    `compiled`, or $ROVBRUSH_COMPILE: where there is none, it is made of the FMU's sources. Raises FmuError if there is
    none; the text says what there is, and what can be done.
    """
    notes, version = notes or Notes(), int(description.fmiMajorVersion)
    identifier, suffix = str(interface.modelIdentifier), fmpy.sharedLibraryExtension
    own, ambiguous = platform_folder(version), ""
    for platform in dict.fromkeys(filter(None, (own, str(fmpy.platform_tuple), platform_folder(2)))):
        place = folder / "binaries" / platform
        libraries = sorted(p for p in place.glob("*") if p.suffix == suffix and p.name[0] != "." and p.is_file())
        found = _called(identifier, libraries)
        if found is None and len(libraries) > 1:
            ambiguous = f"; of {listed(p.name for p in libraries)} in binaries/{platform} call one {identifier}{suffix}"
        if found is None:
            continue
        if found.stem != identifier:
            notes.add(LIBRARY, f"binaries/{platform}/{found.name} instead of {identifier}{suffix}")
        if platform != own:
            notes.add(PLATFORM, f"{platform} instead of {own}" if own else platform)
        return found
    if (compiled or os.environ.get(ASKED)) and (made := compiled_library(path, folder, version, identifier)):
        return made
    platform, found = _for_windows(folder, identifier)
    if found is not None and wine(platform):
        return found
    if shipped := not_for_here(path):
        raise FmuError(f"FMU {path}: {shipped}")
    if not own:
        raise FmuError(
            f"FMU {path}: FMI {version}.0 has no name for binaries of {fmpy.platform_tuple}, so none can be found; "
            f"export it as FMI 3.0"
        )
    raise FmuError(
        f"FMU {path} has no binary for {own}; it has {_there(path, folder, description, interface, ambiguous)}"
    )


def _for_windows(folder: Path, identifier: str) -> tuple[str, Path | None]:
    """The library that wine could run on this machine, behind its platform; nothing where there is none."""
    for platform, folders in FOLDERS.items() if runs_windows() else ():
        for name in folders:
            libraries = sorted(p for p in (folder / "binaries" / name).glob("*.dll") if p.is_file())
            if found := _called(identifier, libraries):
                return platform, found
    return "", None


def _called(identifier: str, libraries: list[Path]) -> Path | None:
    """The library of that name, or nearly so, or the only one."""
    for wanted in (identifier, identifier.casefold(), f"lib{identifier}".casefold()):
        for library in libraries:
            if wanted in (library.stem, library.stem.casefold()):
                return library
    return libraries[0] if len(libraries) == 1 else None


def _there(path: Path, folder: Path, description: ModelDescription, interface: InterfaceType, ambiguous: str) -> str:
    """What binaries there are, and what can be done."""
    there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
    if ambiguous:
        return ", ".join(there) + ambiguous
    return f"{', '.join(there)}; {remedy(path, folder, description, interface)}"


def remedy(path: Path, folder: Path, description: ModelDescription, interface: InterfaceType) -> str:
    """What helps where an FMU has no library for this machine."""
    try:
        version, identifier = int(description.fmiMajorVersion), str(interface.modelIdentifier)
        build = build_of(path, folder, version, identifier) if version > 1 and is_identifier(identifier) else None
    except FmuError as error:
        return f"ask for a binary of this platform: {str(error).removeprefix(f'FMU {path}: ')}"
    wine_helps = f"; {how_to_install(there)}" if (there := _for_windows(folder, identifier)[0]) else ""
    if build:
        compiling = "--compile makes a library of them, or `compile = true` under its component"
        return f"it carries its sources: {compiling}{wine_helps}"
    if wine_helps:
        return wine_helps.removeprefix("; ")
    if any((folder / "sources").glob("**/*.c*")):
        return "ask for a binary of this platform: its sources are not complete, or nothing says how to compile them"
    return "ask for a binary of this platform, or for the sources"
