"""Any system as an environment of Gymnasium.

import rovbrush.gym

env = rovbrush.gym.Environment("plant.toml", {"drive.u": (0.0, 12.0)}, {"drive.w": (0.0, 100.0)},
                               "-abs(drive.w - 30)", episode="5 s")
envs = rovbrush.gym.make_vec("plant.toml", 4, ...)             # four of it, each in a process of its own
rovbrush.gym.register("Drive-v0", system="plant.toml", ...)   # then gymnasium.make("Drive-v0"), gymnasium.make_vec
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

__all__ = ["Environment", "make_vec", "register"]  # noqa: F822 (loaded when it is asked for)


LOADED = {"Environment": "environment", "make_vec": "many"}  # when they are asked for: where they are


def register(name: str, **keywords: Any) -> None:
    """Let `gymnasium.make(name)` and `make_vec` make an `Environment` with these keywords."""
    if find_spec("gymnasium") is None:
        raise _missing()
    import_module("gymnasium").register(name, entry_point="rovbrush.gym:Environment", kwargs=keywords)


def __getattr__(name: str) -> Any:
    if name not in LOADED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if find_spec("gymnasium") is None:
        raise _missing()
    return getattr(import_module(f"rovbrush.orchestrator.training.{LOADED[name]}"), name)


def _missing() -> Exception:
    errors = import_module("rovbrush.orchestrator.errors")
    error: Exception = errors.InputError("environments need Gymnasium: pip install 'rovbrush[gym]'")
    return error
