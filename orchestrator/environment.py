"""What a result depends on besides its inputs: the versions that compute it, and the processor they compile for."""

from __future__ import annotations

import platform
from collections.abc import Mapping
from importlib.metadata import version

PACKAGES = ("rovbrush", "numba", "llvmlite", "numpy")


def versions() -> dict[str, str]:
    """Of the packages that compute, by name."""
    return {name: version(name) for name in PACKAGES}


def environment() -> dict[str, str]:
    """The versions, the system, and the processor as the compiler knows it; another one may round otherwise."""
    from llvmlite.binding import get_host_cpu_name

    return {**versions(), "system": platform.system(), "processor": get_host_cpu_name()}


def changes(then: Mapping[str, str], now: Mapping[str, str]) -> str:
    """`numba 0.60.0, now 0.61.0; ...`; empty where the two are the same."""
    differing = [key for key in {**then, **now} if then.get(key) != now.get(key)]
    return "; ".join(f"{key} {then.get(key, 'not known')}, now {now.get(key, 'not known')}" for key in differing)
