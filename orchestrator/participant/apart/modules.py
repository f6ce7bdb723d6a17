"""Python modules of an FMU from elsewhere: each FMU and each run gets its own, whatever they are called.

While an instance is made, modules of the same names that others brought are out of sight; then its own leave
`sys.modules`, and its folder `sys.path`. Its classes keep what they need.
"""

from __future__ import annotations

import ctypes
import importlib
import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

from ...fmu.fmu import Fmu
from ...fmu.sharing import HOSTS, bundled, imports_late, made_by_pythonfmu, made_here
from .meeting import may_meet

_lock = threading.RLock()


@contextmanager
def own_modules(fmu: Fmu) -> Iterator[None]:
    """Import what an instance needs, for it alone; nothing where the FMU is ours, or needs its modules later."""
    if made_here(fmu) or not made_by_pythonfmu(fmu) or imports_late(fmu) or may_meet():
        yield
        return
    folder = fmu.folder / "resources"
    with _lock:
        names = {name for name in bundled(folder) if name not in HOSTS or not _same_version(name, folder)}
        hidden = _taken(lambda name, _: name.split(".")[0] in names)
        path = list(sys.path)
        importlib.invalidate_caches()
        try:
            yield
        finally:
            for module in _taken(lambda name, module: name.split(".")[0] in names and _inside(module, folder)).values():
                ctypes.pythonapi.Py_IncRef(ctypes.py_object(vars(module)))  # pythonfmu gives back what it does not own
            sys.modules.update(hidden)
            sys.path[:] = path


def _taken(wanted: object) -> dict[str, ModuleType]:
    """Modules that leave `sys.modules`."""
    assert callable(wanted)
    found = {name: module for name, module in sys.modules.items() if wanted(name, module)}
    for name in found:
        del sys.modules[name]
    return found


def _inside(module: ModuleType, folder: Path) -> bool:
    """Whether a module was imported from a folder."""
    places = [getattr(module, "__file__", None), *getattr(module, "__path__", ())]
    return any(str(place).startswith(f"{folder}{os.sep}") for place in places if place)


def _same_version(host: str, folder: Path) -> bool:
    """Whether the pythonfmu that is loaded is the one that an FMU brings: it serves all."""
    loaded = sys.modules.get(host)
    file = getattr(loaded, "__file__", None)
    if not file:
        return False
    return _contents(Path(file).parent) == _contents(folder / host)


def _contents(package: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(package.glob("*.py"))}
