"""`rovbrush export SYSTEM --fmu`: a system as one native FMU, with its sources."""

from __future__ import annotations

import hashlib
import os
import tempfile
import zipfile
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from ..errors import InputError, listed
from ..files import prepare_folder, write_file
from ..system.model import System
from .carried import resources_of, runs_on
from .code.text import filled
from .compiling import OPTIONS, Target, call, for_windows, here
from .description2 import description2, variables2
from .description3 import build_description, description3, unsupported
from .documentation import pages
from .folder import files_of
from .prepared import Prepared, prepared
from .units import SOURCES, headers, write_files

DATE = (2000, 1, 1, 0, 0, 0)  # of every entry: the same content is the same file
GUID = "@GUID@"


def write_fmu(system: System, path: Path, fmi: str = "2.0") -> list[str]:
    """Write a system as an FMU for this machine, and for Windows where mingw-w64 is installed; notes for the user.

    Raises InputError for what is not written as C, RunError where it cannot be compiled.
    """
    if path.suffix != ".fmu":
        raise InputError(f"--out {path}: the name must end in .fmu")
    with prepared(system) as found:
        prepare_folder(path.parent)
        entries, notes = _entries(found, fmi)
    content = _zipped(entries)
    write_file(path, lambda temporary: temporary.write_bytes(content))
    return notes


def _entries(found: Prepared, fmi: str) -> tuple[dict[str, bytes], list[str]]:
    """The files of the FMU by path, and what its user must know."""
    version, code = int(fmi[0]), found.code
    layer = f"{code.name}_fmi{version}.c"
    sources = files_of(found)
    text = (SOURCES / f"fmi{version}.c").read_text(encoding="utf-8")
    more = {"@UNSUPPORTED@": unsupported(text)} if version == 3 else {}
    sources |= headers((version,)) | {layer: filled(f"fmi{version}.c", code.name, more)}
    compiled = [*code.compiled, layer, *(file for unit in code.units for file in unit.compiled)]
    targets = [here()]
    windows = for_windows()
    notes = []
    without = [unit.fmu.path.name for unit in code.units if windows and not runs_on(unit, windows)]
    if windows is None:
        notes.append("for Linux only: mingw-w64 is not installed, which makes its library for Windows")
    elif without:
        notes.append(f"for Linux only: {listed(without)} brought neither C sources nor a library for Windows")
    else:
        targets.append(windows)
    notes += [f"{unit.fmu.path.name} is carried as a library: {unit.why_not}" for unit in code.units if unit.loader]
    digest = hashlib.sha256(b"".join(name.encode() + content for name, content in sorted(sources.items())))
    guid = f"{{{digest.hexdigest()}}}"
    sources[layer] = sources[layer].replace(GUID.encode(), guid.encode())
    entries = {f"sources/{name}": content for name, content in sources.items()}
    entries |= pages(found)
    for unit in code.units:
        entries |= {f"resources/{path}": content for path, content in resources_of(unit).items()}
    if version == 2:
        entries["modelDescription.xml"] = description2(found, guid, compiled)
    else:
        entries["modelDescription.xml"] = description3(found, guid)
        entries["sources/buildDescription.xml"] = build_description(found, compiled)
    for target in targets:
        place = target.fmi2 if version == 2 else target.fmi3
        entries[f"binaries/{place}/{code.name}{target.ending}"] = library(found, sources, compiled, target)
    left = len([e for e in code.shown if e.causality != "hidden"]) - len(variables2(code.shown))
    if version == 2 and left:
        notes.append(f"{left} variables of types that FMI 2.0 does not have are not shown; --fmi 3.0 has them")
    return entries, notes


def library(found: Prepared, sources: Mapping[str, bytes], compiled: list[str], target: Target) -> bytes:
    """The shared library of a system for a platform. Raises RunError with the compiler's words."""
    options = {file: own for unit in found.code.units for file, own in unit.options.items()}
    with tempfile.TemporaryDirectory(prefix="rovbrush_library_") as folder:
        work = Path(folder)
        write_files(work, sources)
        pic = ("-fPIC",) if target.ending == ".so" else ("-D__USE_MINGW_ANSI_STDIO=1",)

        def compiled_to(k: int, file: str) -> str:
            own = options.get(file, ())
            # Relative names only: no path of the machine gets into the library.
            call([target.compiler, *OPTIONS, "-w", *pic, "-I.", *own, "-c", file, "-o", f"{k}.o"], work)
            return f"{k}.o"

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compiled_to, range(len(compiled)), compiled))
        name = f"{found.code.name}{target.ending}"
        call([target.compiler, *target.shared, "-s", *objects, *target.libraries, "-o", name], work)
        return (work / name).read_bytes()


def _zipped(entries: Mapping[str, bytes]) -> bytes:
    with tempfile.TemporaryFile() as file:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in sorted(entries):
                info = zipfile.ZipInfo(name, DATE)
                info.compress_type = zipfile.ZIP_DEFLATED
                info.external_attr = 0o644 << 16
                archive.writestr(info, entries[name])
        file.seek(0)
        return file.read()
