"""The loop's library that came with the package: the same function that Numba compiles, for processors of x86-64.

`make wheel` makes one for each system (release/loop.py). Its name holds the hash of the loop's sources: one of another
version of them is not taken. ROVBRUSH_LOOP names another folder with libraries; with ROVBRUSH_LOOP=compile none is
taken, and Numba compiles for the processor that is here.
"""

from __future__ import annotations

import ctypes
import os
import platform
import sys
from functools import cache
from pathlib import Path

from ...errors import InputError
from .wrapped import ENTRY

FOLDER = Path(__file__).with_name("libraries")
ENDS = {"linux64": ".so", "win64": ".dll"}


class Library:
    """A loaded library; its functions are there as long as the process."""

    def __init__(self, path: Path) -> None:
        self._loaded = ctypes.CDLL(str(path))
        self.address = self.address_of(ENTRY)

    def address_of(self, name: str) -> int:
        """The address of a function or of data."""
        return ctypes.cast(getattr(self._loaded, name), ctypes.c_void_p).value or 0

    def has(self, name: str) -> bool:
        """Whether there is a function or datum of a name."""
        return hasattr(self._loaded, name)

    def number(self, name: str) -> ctypes.c_int64:
        """The whole number of a name, which can be set."""
        return ctypes.c_int64.in_dll(self._loaded, name)


def target() -> str:
    """`linux64`, `win64`, or nothing where no library is made for what runs here."""
    if platform.machine().lower() not in ("x86_64", "amd64") or sys.maxsize < 1 << 32:
        return ""
    return {"linux": "linux64", "win32": "win64"}.get(sys.platform, "")


def switched_off() -> bool:
    """Whether all is to be plain Python: Numba's switch for debugging holds for what it has compiled before, too."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0")


def file_name(digest: str, of: str) -> str:
    """Of the library for a system, below `libraries`."""
    return f"{of}/loop_{digest}{ENDS[of]}"


@cache
def library(digest: str) -> Library | None:
    """The one of the sources with a hash; None where there is none, or where it is not to be used."""
    here, chosen = target(), os.environ.get("ROVBRUSH_LOOP", "")
    path = Path(chosen or FOLDER) / file_name(digest, here) if here and chosen != "compile" else None
    if path is None or not path.is_file():
        return None
    try:
        return Library(path)
    except OSError:
        return None  # of a system that is older than the one that it was linked on; Numba compiles as anywhere


def nothing_compiles() -> InputError:
    """What is said where there is neither a library nor a compiler."""
    return InputError(
        "the loop is not compiled for this machine, and what compiles it is not installed; "
        "type: python -m pip install 'rovbrush[compile]'"
    )
