"""C compilers for exported systems: for this machine and, where mingw-w64 is installed, for Windows."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from ..errors import FmuError, InputError, RunError
from ..fmu.fmu import Fmu

# No contraction to fused multiply-add and no reordering: the results are those of the equations as written, bitwise.
OPTIONS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-strict-aliasing", "-fvisibility=hidden")
WORDS = 1200  # characters of what a compiler says
PATIENCE = 900.0  # s


@dataclass(frozen=True)
class Target:
    """A platform: its folders in FMI 2.0 and 3.0, the ending of its libraries, and its tools."""

    fmi2: str
    fmi3: str
    ending: str
    compiler: str
    nm: str
    shared: tuple[str, ...]
    libraries: tuple[str, ...]


LINUX = ("linux64", "x86_64-linux", ".so", "-shared -fPIC -Wl,--build-id=none,-Bsymbolic,-z,defs", "-lm -ldl")
WINDOWS = (
    "win64", "x86_64-windows", ".dll",
    "-shared -static-libgcc -D__USE_MINGW_ANSI_STDIO=1 -Wl,--no-insert-timestamp", "-lm",
)  # fmt: skip


def here() -> Target:
    """The compiler for this machine. Raises InputError where there is none."""
    stated = os.environ.get("CC")
    found = next(
        (path for name in (*filter(None, [stated]), "gcc", "cc", "clang") if (path := shutil.which(name))), None
    )
    if found is None:
        raise InputError("no C compiler: an exported system needs one; install gcc (Debian, Ubuntu: `apt install gcc`)")
    return _target(LINUX, found, shutil.which("nm") or "nm")


def for_windows() -> Target | None:
    """The compiler for 64-bit Windows, if it is installed."""
    found = shutil.which("x86_64-w64-mingw32-gcc")
    return _target(WINDOWS, found, shutil.which("x86_64-w64-mingw32-nm") or "nm") if found else None


def _target(words: tuple[str, str, str, str, str], compiler: str, nm: str) -> Target:
    fmi2, fmi3, ending, shared, libraries = words
    return Target(fmi2, fmi3, ending, compiler, nm, tuple(shared.split()), tuple(libraries.split()))


def call(command: list[str], work: Path, fmu: Fmu | None = None, name: str = "") -> None:
    """Compile or link in a folder. Raises FmuError of an FMU's sources, else RunError, with the compiler's words."""
    try:
        done = subprocess.run(
            command, cwd=work, stdin=subprocess.DEVNULL, capture_output=True, check=False, timeout=PATIENCE,
            env=os.environ | {"LC_ALL": "C"},
        )  # fmt: skip
        said = done.stderr.decode("utf-8", "replace").strip()[:WORDS] if done.returncode else ""
        failed = done.returncode != 0
    except (OSError, subprocess.SubprocessError) as error:
        failed, said = True, str(error)
    if failed and fmu is not None:
        raise FmuError(f"the source {Path(name).name} of {fmu.path.name} cannot be compiled:\n{said}")
    if failed:
        raise RunError(f"the exported system cannot be compiled ({Path(command[0]).name}):\n{said}")
