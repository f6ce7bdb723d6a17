"""What a result depends on besides its inputs: the versions that compute it, and the processor they compile for."""

from __future__ import annotations

import platform
import re
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

PACKAGES = ("rovbrush", "numba", "llvmlite", "numpy")


def versions() -> dict[str, str]:
    """Of the packages that compute, by name."""
    return {name: _version(name) for name in PACKAGES}


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


def environment() -> dict[str, str]:
    """The versions, the system, and the processor as the compiler knows it; another one may round otherwise."""
    return {**versions(), "system": platform.system(), "processor": _processor()}


def _processor() -> str:
    try:
        from llvmlite.binding import get_host_cpu_name
    except ModuleNotFoundError:  # nothing compiles here: the name that the system has for it
        known = Path("/proc/cpuinfo").read_text(encoding="utf-8") if platform.system() == "Linux" else ""
        found = re.search(r"model name\s*:\s*(.+)", known)
        return found[1] if found else platform.processor() or platform.machine()
    return str(get_host_cpu_name())


def changes(then: Mapping[str, str], now: Mapping[str, str]) -> str:
    """`numba 0.60.0, now 0.61.0; ...`; empty where the two are the same."""
    differing = [key for key in {**then, **now} if then.get(key) != now.get(key)]
    return "; ".join(f"{key} {then.get(key, 'not known')}, now {now.get(key, 'not known')}" for key in differing)
