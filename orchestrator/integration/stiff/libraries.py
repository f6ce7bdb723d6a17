"""The shared libraries of SUNDIALS 7, of which CVODE is one.

fmpy brings them for x86-64 and for macOS. Elsewhere, ARM with Linux for one, those of scikit-sundae are taken, or those
of the environment (conda) or of the system.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import platform
import sys
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

OLDEST = 7  # the first whose functions are as they are called here
# In an order in which each finds those that it needs. Some lie in the library of CVODE.
PARTS = ("core", "nvecserial", "sunmatrixdense", "sunlinsoldense", "sunmatrixband", "sunlinsolband", "cvode")
NEEDED = ("SUNContext_Create", "SUNContext_ClearErrHandlers", "N_VMake_Serial", "SUNDenseMatrix", "SUNLinSol_Dense",
          "SUNBandMatrix", "SUNLinSol_Band", "CVode")  # fmt: skip
INSTALL = (
    f"install the shared libraries of SUNDIALS {OLDEST} (`sundials` of conda-forge, `libsundials-cvode7` of Debian 13, "
    "or `pip install scikit-sundae` where it has wheels)"
)


@cache
def libraries() -> tuple[Any, ...]:
    """The libraries; none where there are none on this machine."""
    for found in (_of_fmpy, _of_folders, _of_system):
        with suppress(ImportError, OSError, AttributeError):
            loaded = tuple(found())
            if _good(loaded):
                return loaded
    return ()


def is_there() -> bool:
    """Whether CVODE can be used on this machine."""
    return bool(libraries())


def why_missing() -> str:
    """That it cannot, and what to do."""
    return f"there is no CVODE on this machine ({sys.platform}, {platform.machine()}), fmpy brings none: {INSTALL}"


def _of_fmpy() -> Iterator[Any]:
    from fmpy.sundials import libraries as shipped

    for part in PARTS:
        if hasattr(shipped, f"sundials_{part}"):
            yield getattr(shipped, f"sundials_{part}")


def folders() -> Iterator[Path]:
    """Where libraries may lie: beside scikit-sundae, as its wheels bring them, and in the environment."""
    spec = find_spec("sksundae")
    if spec is not None and spec.origin:
        place = Path(spec.origin).parent
        yield from (place.parent / "scikit_sundae.libs", place / ".dylibs")
    yield Path(sys.prefix) / "lib"
    yield Path(sys.prefix) / "Library" / "bin"


def _of_folders() -> Iterator[Any]:
    """Of the first folder that has CVODE; names may have a hash and a version, libsundials_cvode-cf29dc23.so.7.9.0."""
    for folder in folders():
        files = {part: sorted(p for mark in "-." for p in folder.glob(f"*sundials_{part}{mark}*")) for part in PARTS}
        shared = {part: [p for p in found if p.suffix != ".a"] for part, found in files.items()}
        if shared["cvode"]:
            for found in filter(None, shared.values()):
                yield ctypes.CDLL(str(found[0]))
            return


def _of_system() -> Iterator[Any]:
    for part in PARTS:
        if name := ctypes.util.find_library(f"sundials_{part}"):
            yield ctypes.CDLL(name)


def _good(loaded: tuple[Any, ...]) -> bool:
    """Whether they have what is called, and count in doubles."""
    if any(not any(hasattr(library, name) for library in loaded) for name in NEEDED):
        return False
    core = next(library for library in loaded if hasattr(library, "SUNDIALSGetVersionNumber"))
    numbers, label = [ctypes.c_int() for _ in range(3)], ctypes.create_string_buffer(32)
    core["SUNDIALSGetVersionNumber"](*map(ctypes.byref, numbers), label, ctypes.c_int(len(label)))
    return numbers[0].value >= OLDEST and _of_doubles(loaded)


def _of_doubles(loaded: tuple[Any, ...]) -> bool:
    """Whether the largest of one number, 3, is 3."""

    def function(name: str, answer: Any) -> Any:
        found = next(library for library in loaded if hasattr(library, name))[name]
        found.restype = answer
        return found

    context = ctypes.c_void_p()
    if function("SUNContext_Create", ctypes.c_int)(ctypes.c_int(0), ctypes.byref(context)):
        return False
    numbers = (ctypes.c_double * 1)(3.0)
    vector = ctypes.c_void_p(function("N_VMake_Serial", ctypes.c_void_p)(ctypes.c_int64(1), numbers, context))
    largest = float(function("N_VMaxNorm", ctypes.c_double)(vector))
    function("N_VDestroy", None)(vector)
    function("SUNContext_Free", ctypes.c_int)(ctypes.byref(context))
    return largest == 3.0
