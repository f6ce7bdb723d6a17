"""How it is run: a multirate co-simulation master for FMUs whose loop has no Python in it.

from rovbrush.orchestrator import load

result = load("nominal").run(stop="2 s")
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .api import Model, load
    from .errors import FmuError, InputError, RovbrushError, RunError
    from .results.pictures.comparison import compare
    from .results.result import Result
    from .run.pacing.pace import Pace
    from .run.stepping.stepping import Stepping

__all__ = [
    "FmuError", "InputError", "Model", "Pace", "Result", "RovbrushError", "RunError", "Stepping", "compare", "load",
]  # fmt: skip
_PLACES = {
    "load": "api",
    "compare": "results.pictures.comparison",
    "Model": "api",
    "Pace": "run.pacing.pace",
    "Result": "results.result",
    "Stepping": "run.stepping.stepping",
}


def __dir__() -> list[str]:
    return __all__


def __getattr__(name: str) -> Any:
    """What is imported when it is asked for, so that a command loads no more than it needs."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_PLACES.get(name, 'errors')}", __name__), name)
