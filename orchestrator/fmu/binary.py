"""Where an FMU keeps its library: what the folder and the file are called, and what to ask for if it is not there."""

from __future__ import annotations

import re
from pathlib import Path

import fmpy
from fmpy.model_description import ModelDescription

from ..errors import FmuError

IDENTIFIER = r"[A-Za-z_][A-Za-z0-9_]*"  # a name in C
LONGEST = 200  # characters of an identifier: it becomes a file name


def check_identifiers(path: Path, description: ModelDescription) -> None:
    """Raises FmuError if a modelIdentifier is no C identifier: it becomes a path, and could name any library."""
    parts = (description.coSimulation, description.modelExchange, description.scheduledExecution)
    named = [part.modelIdentifier for part in (*parts, *description.buildConfigurations) if part is not None]
    for identifier in named:
        if not is_identifier(identifier):
            shown = identifier if len(str(identifier)) < 100 else f"{identifier[:100]}..."
            raise FmuError(
                f"FMU {path}: its modelIdentifier '{shown}' is no C identifier of at most {LONGEST} characters; refused"
            )


def is_identifier(name: str | None) -> bool:
    """May a name from a description be part of a path?"""
    return name is not None and len(name) <= LONGEST and re.fullmatch(IDENTIFIER, name) is not None


def platform_folder(version: int) -> str:
    """Name of the folder with the binary for this machine; empty where FMI 2.0 has none for it."""
    if version == 3:
        return str(fmpy.platform_tuple)
    return "" if fmpy.platform_tuple in ("aarch64-linux", "aarch64-windows") else str(fmpy.platform)


def check_binary(path: Path, folder: Path, description: ModelDescription) -> None:
    """Raises FmuError if an unpacked FMU has no library for this machine; the text says what it has."""
    assert description.coSimulation is not None
    version = int(description.fmiMajorVersion)
    platform = platform_folder(version)
    if not platform:
        raise FmuError(
            f"FMU {path}: FMI 2.0 has no name for binaries of {fmpy.platform_tuple}, so none can be found; "
            f"export it as FMI 3.0"
        )
    library = f"{description.coSimulation.modelIdentifier}{fmpy.sharedLibraryExtension}"
    if (folder / "binaries" / platform / library).is_file():
        return
    there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
    sources = any((folder / "sources").glob("**/*.c*"))
    remedy = (
        f"; it carries its sources, which can be compiled: `fmpy compile {path}`"
        if sources
        else "; ask for a binary of this platform, or for the sources"
    )
    raise FmuError(f"FMU {path} has no binary for {platform}; it has {', '.join(there)}{remedy}")
