"""What of an FMU's sources is compiled, and how: SourceFiles of FMI 2.0, the build description of FMI 3.0."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import fmpy

from ...errors import FmuError, listed
from ..tolerant.xml import safe_xml

LANGUAGES = {"c": "gnu", "c++": "gnu++"}  # how the standards of a language are called by `-std`
STANDARDS = ("89", "90", "99", "11", "17", "18", "23", "98", "03", "14", "20")
PLUS_PLUS = (".cpp", ".cc", ".cxx", ".c++")
# Options that may be passed on: none of them opens a file or runs a program.
OPTION = re.compile(
    r"-(O[0-3sg]?|g|pthread|std=[\w+]+|[DU]\w+(=[\w.+-]*)?|W[a-z][a-z0-9+-]*(=\d+)?|f[a-z0-9-]+|m[a-z0-9.=-]+)"
)
DEFINITION = re.compile(r"[A-Za-z_]\w*")
LIBRARY = re.compile(r"[\w.+-]+")
COMPILERS = ("gcc", "clang")  # whose options are known


@dataclass(frozen=True)
class FileSet:
    """Files that are compiled alike; `plus_plus`: those in C++. Paths are absolute, inside the folder `sources`."""

    files: tuple[Path, ...]
    options: tuple[str, ...] = ()
    folders: tuple[Path, ...] = ()  # of headers
    plus_plus: bool = False


@dataclass(frozen=True)
class Build:
    """All that becomes one library; `libraries` of the system that it is linked with."""

    sets: tuple[FileSet, ...]
    libraries: tuple[str, ...] = ()


def build_of(path: Path, folder: Path, version: int, identifier: str) -> Build | None:
    """How the library of an unpacked FMU is made of its sources; None where nothing says so.

    Raises FmuError for what is missing, leads out of the sources, or is not understood.
    """
    sources = folder / "sources"
    if version == 3:
        xml = sources / "buildDescription.xml"
        return _of_description(path, sources, safe_xml(path, xml), identifier) if xml.is_file() else None
    root = safe_xml(path, folder / "modelDescription.xml")
    for kind in ("CoSimulation", "ModelExchange"):
        interface = root.find(kind)
        if interface is not None and interface.get("modelIdentifier") == identifier:
            names = [str(file.get("name")) for file in interface.findall("SourceFiles/File")]
            if names:
                files = tuple(_inside(path, sources, name) for name in names)
                plus = tuple(file for file in files if _is_plus_plus(file))
                plain = tuple(file for file in files if file not in plus)
                return Build(tuple(FileSet(group, plus_plus=group is plus) for group in (plain, plus) if group))
    return None


def _of_description(path: Path, sources: Path, root: Any, identifier: str) -> Build | None:
    here = [c for c in root.findall("BuildConfiguration") if c.get("modelIdentifier") == identifier]
    platforms = fmpy.platform_tuple, None
    chosen = next((c for platform in platforms for c in here if c.get("platform") == platform), None)
    if chosen is None:
        return None
    sets = tuple(_set(path, sources, element) for element in chosen.findall("SourceFileSet"))
    libraries = []
    for library in chosen.findall("Library"):
        name = str(library.get("name"))
        if library.get("external") not in ("true", "1") or not LIBRARY.fullmatch(name) or name.startswith("-"):
            raise FmuError(
                f"FMU {path} is to be linked with {name}, which is no library of the system "
                f"(buildDescription.xml); ask for a binary of this platform"
            )
        libraries.append(name.removeprefix("lib").split(".")[0])
    return Build(sets, tuple(libraries)) if any(group.files for group in sets) else None


def _set(path: Path, sources: Path, element: Any) -> FileSet:
    files = tuple(_inside(path, sources, str(f.get("name"))) for f in element.findall("SourceFile"))
    standard, plus = _language(path, element.get("language"), files)
    options = [standard] if standard else []
    compiler = (element.get("compiler") or "").lower()
    if any(name in compiler for name in COMPILERS):  # those of another compiler mean nothing here
        options += (element.get("compilerOptions") or "").split()
    for option in options:
        if not OPTION.fullmatch(option):
            raise FmuError(
                f"FMU {path}: its build description asks for the compiler's option '{option[:80]}', which is not "
                f"passed on; ask for a binary of this platform"
            )
    for definition in element.findall("PreprocessorDefinition"):
        name, value = str(definition.get("name")), definition.get("value")
        if not DEFINITION.fullmatch(name):
            raise FmuError(f"FMU {path}: its build description defines '{name[:80]}', which is no name in C")
        if definition.get("optional") not in ("true", "1"):
            options.append(f"-D{name}" if value is None else f"-D{name}={value}")
    folders = tuple(
        _inside(path, sources, str(d.get("name")), folder=True) for d in element.findall("IncludeDirectory")
    )
    return FileSet(files, tuple(options), folders, plus)


def _language(path: Path, stated: str | None, files: tuple[Path, ...]) -> tuple[str, bool]:
    """The compiler's word for a standard, empty where none is stated, and whether it is C++."""
    if not stated:
        return "", any(map(_is_plus_plus, files))
    found = re.fullmatch(r"(c\+\+|c)[ -]?(\d\d)?", stated.strip().lower())
    if not found or (found[2] and found[2] not in STANDARDS):
        raise FmuError(f"FMU {path}: its sources are in {stated[:80]}; only C and C++ are compiled here")
    return f"-std={LANGUAGES[found[1]]}{found[2]}" if found[2] else "", found[1] == "c++"


def _is_plus_plus(file: Path) -> bool:
    return file.suffix.lower() in PLUS_PLUS


def _inside(path: Path, sources: Path, name: str, folder: bool = False) -> Path:
    """A file, or a folder, of the sources. Raises FmuError where it is not there, or elsewhere."""
    parts = [part for part in name.replace("\\", "/").split("/") if part not in ("", ".")]
    found = sources.joinpath(*parts)
    if ".." in parts or name.startswith(("/", "\\")) or ":" in name:
        raise FmuError(f"FMU {path}: its sources are to hold '{name[:200]}', which leads out of them")
    if not (found.is_dir() if folder else found.is_file()):
        there = sorted(p.relative_to(sources).as_posix() for p in sources.rglob("*") if p.is_file())
        raise FmuError(f"FMU {path}: '{name[:200]}' is not among its sources; there is {listed(there) or 'nothing'}")
    return found
