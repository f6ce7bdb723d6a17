"""C sources -> shared libraries for linux64 and win64, the same bytes from the same sources."""

from __future__ import annotations

import platform
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..errors import BuildError

# No contraction to fused multiply-add and no reordering: the results are those of the equations as written, bitwise.
OPTIONS = "-std=c11 -O3 -ffp-contract=off -fno-math-errno"


@dataclass(frozen=True)
class Platform:
    """A target: its folder names in FMI 2.0 and 3.0, library ending, compilers to try, and how to get one."""

    fmi2: str
    fmi3: str
    ending: str
    compilers: tuple[str, ...]
    package: str
    options: tuple[str, ...]

    def compiler(self) -> str:
        """The compiler's path. Raises BuildError saying which package to install."""
        own = platform.system() == "Linux" and platform.machine() == "x86_64"
        names = [name for name in self.compilers if name != "gcc" or own]
        found = next((path for path in map(shutil.which, names) if path), None)
        if found is None:
            raise BuildError(
                f"no compiler for {self.fmi2} ({' or '.join(names)}); install it (Debian, Ubuntu: `apt install "
                f"{self.package}`) or leave {self.fmi2} out with --platform"
            )
        return found


PLATFORMS = {
    "linux64": Platform(
        "linux64", "x86_64-linux", ".so", ("x86_64-linux-gnu-gcc", "gcc"), "gcc",
        ("-fPIC", "-Wl,--build-id=none,-Bsymbolic,--no-undefined"),
    ),
    "win64": Platform(
        "win64", "x86_64-windows", ".dll", ("x86_64-w64-mingw32-gcc",), "gcc-mingw-w64-x86-64",
        ("-static-libgcc", "-D__USE_MINGW_ANSI_STDIO=1", "-Wl,--no-insert-timestamp"),
    ),
}  # fmt: skip


def available(names: tuple[str, ...], missing: Callable[[str], None]) -> tuple[str, ...]:
    """Those of the platforms that there is a compiler for; `missing` hears of the others.

    Raises BuildError for an unknown platform, and if there is a compiler for none.
    """
    found: list[str] = []
    errors: list[BuildError] = []
    for name in names:
        if name not in PLATFORMS:
            raise BuildError(f"no platform '{name}'; there are {', '.join(PLATFORMS)}")
        try:
            PLATFORMS[name].compiler()
        except BuildError as error:
            errors.append(error)
        else:
            found.append(name)
    if not found:
        raise errors[0]
    for why in errors:
        missing(str(why))
    return tuple(found)


def compile_objects(sources: Path, files: tuple[str, ...], target: Platform) -> tuple[str, ...]:
    """The names of the object files, in the folder `sources`, of the C `files` in it. Raises BuildError as below."""
    _compiler(sources, target, ("-c", *files))
    return tuple(f"{Path(file).stem}.o" for file in files)


def compile_library(sources: Path, files: tuple[str, ...], target: Platform) -> bytes:
    """The shared library made of the C and object `files` in the folder `sources`.

    Raises BuildError with the compiler's words.
    """
    library = f"library{target.ending}"
    _compiler(sources, target, ("-shared", "-s", "-o", library, *files))
    made = sources / library
    content = made.read_bytes()
    made.unlink()
    return content


def _compiler(sources: Path, target: Platform, words: tuple[str, ...]) -> None:
    command = [target.compiler(), *OPTIONS.split(), "-Wall", "-fvisibility=hidden", *words, *target.options]
    # Relative names only: no path of the machine gets into the library.
    run = subprocess.run([*command, "-lm"], cwd=sources, capture_output=True, text=True, check=False)
    if run.returncode:
        raise BuildError(f"compiling for {target.fmi2} failed:\n{run.stderr.strip()}")
