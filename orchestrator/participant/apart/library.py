"""Fresh static data for every use of an FMU: where its library was loaded before, a private copy of it is loaded.

The copy has the same bytes and lies in the same folder for as long as it takes to load it, so that it finds what lies
beside it. Unloading is tried at the end of an instance, and nothing relies on it: many libraries stay.
"""

from __future__ import annotations

import itertools
import os
import shutil
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from fmpy import freeLibrary

from ...fmu.fmu import Fmu
from ...fmu.sharing import made_by_pythonfmu, made_here
from .meeting import may_meet

_used: set[Path] = set()  # libraries that this process has loaded
_numbers = itertools.count(1)
_lock = threading.Lock()


def used_before(fmu: Fmu) -> bool:
    """Whether this process has loaded an FMU's library, whatever became of it."""
    return fmu.library in _used


def keeps_nothing(fmu: Fmu) -> bool:
    """Whether a library can be used again as it is: ours, and pythonfmu's, whose state is Python's (`modules.py`)."""
    return made_here(fmu) or made_by_pythonfmu(fmu)


@contextmanager
def fresh_library(fmu: Fmu) -> Iterator[Path]:
    """The path from which to load the library of one more instance."""
    original = fmu.library
    with _lock:
        copied = original in _used and not keeps_nothing(fmu) and not may_meet()
        _used.add(original)
    if not copied:
        yield original
        return
    path = _copied(original)
    try:
        yield path
    finally:
        with suppress(OSError):  # Windows keeps a library that is loaded; it is swept up with the cache
            path.unlink()


def _copied(original: Path) -> Path:
    name = f".{original.stem}.{os.getpid()}.{next(_numbers)}{original.suffix}"
    try:
        return Path(shutil.copyfile(original, original.with_name(name)))
    except OSError:  # a cache that is not ours to write to
        return Path(shutil.copyfile(original, Path(tempfile.mkdtemp(prefix="rovbrush-")) / name))


def unload(fmu: Fmu, library: Any) -> None:
    """Try to unload the library of an instance that has been freed."""
    if not keeps_nothing(fmu):
        with suppress(Exception):
            freeLibrary(library._handle)
