"""Multirate FMI co-simulation.

import rovbrush

result = rovbrush.load("nominal").run(stop="2 s")
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
    "FmuError", "InputError", "Model", "Pace", "Result", "RovbrushError", "RunError", "Session", "__version__",
    "compare", "load",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    """What is imported when it is asked for, so that a command loads no more than it needs."""
    if name == "__version__":
        from importlib.metadata import version

        return version("rovbrush")
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f"{__name__}.orchestrator"), {"Session": "Stepping"}.get(name, name))
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return __all__
