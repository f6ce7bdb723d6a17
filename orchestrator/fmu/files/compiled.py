"""The library of an FMU made of its sources, where its user asks for that; kept beside what was unpacked.

    HASH/.rovbrush/compiled/PLATFORM/IDENTIFIER.so

The compiler is called without a shell, on files inside the FMU's sources only.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from pathlib import Path

import fmpy

from ...cache import cache
from ...errors import FmuError
from .archive import OURS
from .sources import Build, FileSet, build_of

ASKED = "ROVBRUSH_COMPILE"  # set to 1 in the environment, it is asked for wherever an FMU is opened
HEADERS = Path(fmpy.__file__).parent / "c-code"  # of the standards, for sources that come without them
PATIENCE = 600.0  # s for all files of an FMU
WORDS = 3000  # characters of what a compiler says
OPTIONS = ("-O2", "-fPIC", "-ffp-contract=off", "-fno-strict-aliasing")
# Sources that define a prefix for their functions do so for static linking, where many are in one program.
FIRST = {2: HEADERS / "fmi2Functions.h", 3: HEADERS / "fmi3Functions.h"}
EXPORTED = {2: b"\0fmi2Instantiate\0", 3: b"\0fmi3GetVersion\0"}  # what a library of any kind exports


def compiler(plus_plus: bool = False) -> str | None:
    """The path of the C or C++ compiler: $CC or $CXX, else the system's; None where there is none."""
    stated = os.environ.get("CXX" if plus_plus else "CC")
    usual = ("c++", "g++", "clang++") if plus_plus else ("cc", "gcc", "clang")
    return next((found for name in (*filter(None, [stated]), *usual) if (found := shutil.which(name))), None)


def compiled_library(path: Path, folder: Path, version: int, identifier: str) -> Path | None:
    """The library of an unpacked FMU, compiled unless it has been before; None where nothing says how.

    Raises FmuError with the compiler's words.
    """
    library = folder / OURS / "compiled" / str(fmpy.platform_tuple) / f"{identifier}{fmpy.sharedLibraryExtension}"
    if library.is_file():
        return library
    build = build_of(path, folder, version, identifier) if version > 1 else None
    if build is None:
        return None
    with cache.workspace() as work:
        made = _made(path, folder, build, work, ())
        if EXPORTED[version] not in made.read_bytes():  # under a prefix
            made = _made(path, folder, build, work, ("-include", str(FIRST[version])))
        if EXPORTED[version] not in made.read_bytes():
            raise FmuError(
                f"FMU {path}: what its sources were compiled to has no function "
                f"{EXPORTED[version].decode().strip(chr(0))}; its description names the wrong files"
            )
        try:
            library.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            made.replace(library)
        except OSError as error:
            raise FmuError(f"FMU {path}: its library cannot be kept in {library.parent}: {error.strerror}") from error
        cache.grew(library.stat().st_size)
    return library


def _made(path: Path, folder: Path, build: Build, work: Path, first: tuple[str, ...]) -> Path:
    """The library, in the folder `work`."""
    end, plus = time.monotonic() + PATIENCE, any(group.plus_plus for group in build.sets)
    objects: list[str] = []
    for group in build.sets:
        for file in group.files:
            made = work / f"{len(objects)}.o"
            _call(
                path, file.name, [*_command(path, folder, group), *first, "-c", str(file), "-o", str(made)], work, end
            )
            objects.append(str(made))
    library = work / f"library{fmpy.sharedLibraryExtension}"
    complete = ["-Wl,-z,defs"] if fmpy.sharedLibraryExtension == ".so" else []
    linked = [f"-l{name}" for name in dict.fromkeys((*build.libraries, "m"))]
    _call(path, "", [_compiler(path, plus), "-shared", *objects, *complete, *linked, "-o", str(library)], work, end)
    return library


def _command(path: Path, folder: Path, group: FileSet) -> list[str]:
    sources = folder / "sources"
    folders = [f"-I{place}" for place in (*group.folders, sources, HEADERS)]
    return [_compiler(path, group.plus_plus), *OPTIONS, *group.options, *folders]


def _compiler(path: Path, plus_plus: bool) -> str:
    found = compiler(plus_plus)
    if found is None:
        name, package = ("C++", "g++") if plus_plus else ("C", "gcc")
        raise FmuError(f"FMU {path}: its sources need a {name} compiler; install one (Debian: `apt install {package}`)")
    return found


def _call(path: Path, file: str, command: list[str], work: Path, end: float) -> None:
    """Raises FmuError where a compiler refuses, or where it is still busy at `end` (of time.monotonic)."""
    what = f"its source {file} cannot be compiled" if file else "its compiled sources cannot be linked"
    try:
        done = subprocess.run(
            command, cwd=work, stdin=subprocess.DEVNULL, capture_output=True, check=False,
            timeout=max(end - time.monotonic(), 1.0), env=os.environ | {"LC_ALL": "C"},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise FmuError(f"FMU {path}: {what} within {PATIENCE:g} s") from None
    except OSError as error:
        raise FmuError(f"FMU {path}: {what}: {command[0]} cannot be started ({error.strerror})") from error
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip()
        more = " ..." if len(said) > WORDS else ""
        raise FmuError(f"FMU {path}: {what} ({Path(command[0]).name}):\n{said[:WORDS]}{more}")
