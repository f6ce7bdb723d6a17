"""The FMUs of a system as parts of one program: their C sources under names of their own, or their libraries.

Two components' sources define functions of the same names. Every C file is included by one of a few lines, behind a
header that gives each function and variable that others could see a name with the FMU's own prefix; no compiler needs
an option for that. Which names there are the compiler's own table says.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import FmuError, InputError
from ..fmu.files.compiled import HEADERS
from ..fmu.files.sources import FileSet, build_of
from ..fmu.fmu import Fmu
from ..system.component import Component
from .code.names import comment, identifiers
from .compiling import OPTIONS, Target, call

SOURCES = Path(__file__).parent / "sources"
STANDARD = {
    2: ("fmi2TypesPlatform.h", "fmi2FunctionTypes.h", "fmi2Functions.h"),
    3: ("fmi3PlatformTypes.h", "fmi3FunctionTypes.h", "fmi3Functions.h"),
}
# Contraction of a*b + c would round once where a run rounds twice, whatever options a host's tool compiles with.
# GCC (12) does it for several at once even where -ffp-contract=off forbids it.
EXACT = """#if !defined(__GNUC__) || defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize")
#endif"""


@dataclass(frozen=True)
class Unit:
    """One FMU in a program: the prefix of its names, and whether its C is part of it."""

    prefix: str
    fmu: Fmu
    files: tuple[str, ...] = ()  # of the program, that are compiled; empty where its library is carried
    options: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # of the compiler, by file
    texts: Mapping[str, bytes] = field(default_factory=dict)  # all files of it, by path in the program's folder
    functions: frozenset[str] = frozenset()  # of FMI, that its sources define
    why_not: str = ""  # why its C is not
    loader: str = ""  # the file that loads its library then

    @property
    def version(self) -> int:
        return self.fmu.version

    def function(self, name: str) -> str:
        """The name of an FMI function of it in the program."""
        return f"{self.prefix}_fmi{self.version}{name}"

    @property
    def compiled(self) -> tuple[str, ...]:
        """The files of it that are compiled."""
        return (*self.files, *([self.loader] if self.loader else []))

    @property
    def in_c(self) -> bool:
        """Whether its C sources are part of the program."""
        return bool(self.files)


def units_of(
    components: Mapping[str, Component], prefixes: Mapping[str, str], work: Path, target: Target
) -> dict[str, Unit]:
    """The unit of every component, by its name; each FMU once. `prefixes`: by the digests of FMUs.

    `work`: an empty folder. Raises InputError where the compiler cannot be asked.
    """
    made: dict[str, Unit] = {}
    for component in components.values():
        fmu = component.fmu.own
        if fmu.digest not in made:
            made[fmu.digest] = _unit(fmu, prefixes[fmu.digest], work / prefixes[fmu.digest], target)
    return {name: made[component.fmu.own.digest] for name, component in components.items()}


def _unit(fmu: Fmu, prefix: str, work: Path, target: Target) -> Unit:
    try:
        build = build_of(fmu.path, fmu.folder, fmu.version, fmu.interface.modelIdentifier)
    except FmuError as error:
        return Unit(prefix, fmu, why_not=str(error))
    if build is None:
        return Unit(prefix, fmu, why_not=f"{fmu.path.name} has no C sources")
    if any(group.plus_plus for group in build.sets):
        return Unit(prefix, fmu, why_not=f"the sources of {fmu.path.name} are in C++")
    if build.libraries and set(build.libraries) - {"m"}:
        return Unit(prefix, fmu, why_not=f"the sources of {fmu.path.name} need libraries: {', '.join(build.libraries)}")
    texts = _sources(fmu, prefix)
    try:
        return _named(fmu, prefix, build.sets, texts, work, target)
    except FmuError as error:
        return Unit(prefix, fmu, why_not=str(error))


def _sources(fmu: Fmu, prefix: str) -> dict[str, bytes]:
    """All files of an FMU's sources, in a folder of its prefix."""
    top = fmu.folder / "sources"
    files = sorted(path for path in top.rglob("*") if path.is_file())
    return {f"components/{prefix}/{path.relative_to(top).as_posix()}": path.read_bytes() for path in files}


def _named(fmu: Fmu, prefix: str, sets: Sequence[FileSet], texts: dict[str, bytes], work: Path, target: Target) -> Unit:
    """The unit of C sources, compiled once with no more than the names of FMI changed, to see what others there are."""
    header = f"components/{prefix}_names.h"
    texts[header] = _header(prefix, fmu.version, ())
    options: dict[str, tuple[str, ...]] = {}
    top = (fmu.folder / "sources").resolve()
    listed = [file.resolve().relative_to(top).as_posix() for group in sets for file in group.files]
    # The dash keeps the file `b_c` of an FMU `a` apart from the file `c` of an FMU `a_b`.
    names = dict(zip(listed, identifiers(inside.rpartition(".")[0] for inside in listed), strict=True))
    for group in sets:
        for file in group.files:
            inside = file.resolve().relative_to(top).as_posix()
            name = f"components/{prefix}-{names[inside]}.c"
            folders = [f"-Icomponents/{prefix}/{f.resolve().relative_to(top).as_posix()}" for f in group.folders]
            defined = [option[2:].partition("=") for option in group.options if option.startswith("-D")]
            undefined = [option[2:] for option in group.options if option.startswith("-U")]
            changes = [f"#define {key} {value if equal else 1}" for key, equal, value in defined]
            changes += [f"#undef {key}" for key in undefined]
            inner = [f"-Icomponents/{prefix}"] if "/" in inside else []
            texts[name] = (
                f"/* {comment(f'{inside} of {fmu.path.name}')}, under names of its own. */\n"
                + "".join(f"{line}\n" for line in changes)
                + f'#include "{prefix}_names.h"\n#include "{prefix}/{inside}"\n'
            ).encode()
            options[name] = (*inner, *folders)
    write_files(work, {**texts, **headers((fmu.version,))})
    found: set[str] = set()
    for k, (name, own) in enumerate(options.items()):
        made = work / f"{k}.o"
        call([target.compiler, *OPTIONS, "-O0", "-w", "-I.", *own, "-c", name, "-o", str(made)], work, fmu, name)
        found |= _global_names(made, target)
    start = f"{prefix}_fmi{fmu.version}"
    functions = frozenset(name[len(prefix) + 1 :] for name in found if name.startswith(start))
    needed = f"fmi{fmu.version}{'DoStep'}"
    if needed not in functions:
        raise FmuError(f"the sources of {fmu.path.name} define no function {needed}")
    texts[header] = _header(prefix, fmu.version, sorted(name for name in found if not name.startswith(f"{prefix}_")))
    return Unit(prefix, fmu, tuple(options), options, texts, functions)


def _header(prefix: str, version: int, more: Iterable[str]) -> bytes:
    """The header that comes before every source of a unit."""
    lines = [
        f"/* The names of {prefix} that others could see, so that none of them meets another component's. */",
        EXACT,
        f'#include "fmi{version}Functions.h"',
        f"#undef FMI{version}_Export",
        f"#define FMI{version}_Export /* nothing of it is seen outside of the program */",
    ]
    for name in fmi_functions(version):
        lines += [f"#undef {name}", f"#define {name} {prefix}_{name}"]
    lines += [f"#define {name} {prefix}_{name}" for name in more]
    return "\n".join([*lines, ""]).encode()


def fmi_functions(version: int) -> list[str]:
    """All functions of a version of FMI."""
    text = (HEADERS / STANDARD[version][2]).read_text(encoding="utf-8")
    return list(
        dict.fromkeys(re.findall(rf"^#define\s+(fmi{version}\w+)\s+fmi{version}FullName\(", text, re.MULTILINE))
    )


def headers(versions: Iterable[int]) -> dict[str, bytes]:
    """The standard's own headers, with their licence in each."""
    return {name: (HEADERS / name).read_bytes() for version in sorted(set(versions)) for name in STANDARD[version]}


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Files by their paths in a folder."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def _global_names(made: Path, target: Target) -> set[str]:
    """The functions and variables of an object file that other files see."""
    try:
        done = subprocess.run(
            [target.nm, "-g", "--defined-only", str(made)], capture_output=True, text=True, check=True, timeout=60
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise InputError(
            f"the names in compiled sources cannot be read: {target.nm}: {error}; install binutils"
        ) from None
    return {line.split()[-1] for line in done.stdout.splitlines() if len(line.split()) == 3}
