"""Libraries for Windows on Linux: wine runs them, in a process each (`participant/windows/`)."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import fmpy

from ...errors import FmuError

# The folders of libraries for Windows, by the platform's name in FMI 1.0 and 2.0; the first that is there counts.
FOLDERS = {"win64": ("win64", "x86_64-windows"), "win32": ("win32", "x86-windows")}
# Where Debian keeps the loaders; of other systems `wine` runs both.
LOADERS = {"win64": ("wine64", "/usr/lib/wine/wine64"), "win32": ("/usr/lib/wine/wine",)}
ONLY_64 = "/usr/lib/wine/wine64"  # Debian's `wine` runs win32 only where its package for that is there too
PACKAGES = {
    "win64": "apt install wine64 mingw-w64",
    "win32": "dpkg --add-architecture i386 && apt update && apt install wine32:i386 gcc-mingw-w64-i686",
}


def runs_windows() -> bool:
    """Whether libraries for Windows can be run on this machine at all: wine is no emulator of processors."""
    return sys.platform == "linux" and str(fmpy.platform_tuple) == "x86_64-linux"


def platform_of(library: Path) -> str:
    """win64 or win32 of a library that wine is to run; empty for one of this machine's own."""
    if os.name == "nt" or library.suffix.lower() != ".dll":
        return ""
    return next((name for name, folders in FOLDERS.items() if library.parent.name in folders), "win64")


def wine(platform: str) -> str | None:
    """The program that runs win64 or win32; None where there is none."""
    usual = () if platform == "win32" and os.path.exists(ONLY_64) else ("wine",)
    return next((found for name in (*LOADERS[platform], *usual) if (found := shutil.which(name))), None)


def how_to_install(platform: str) -> str:
    """What makes a machine run FMUs for win64 or win32, to go behind a semicolon."""
    return f"wine runs it where that and mingw-w64 are installed (Debian: `{PACKAGES[platform]}`)"


def require_wine(path: Path, platform: str) -> str:
    """The program that runs the library of an FMU. Raises FmuError naming the packages."""
    found = wine(platform)
    if found is None:
        raise FmuError(f"FMU {path} has a library for {platform} only; {how_to_install(platform)}")
    return found
