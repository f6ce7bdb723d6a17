"""Functions with two lives: as they stand, in plain Python, and as machine code.

The compiler is told of them when it is needed, not before: a run whose loop is compiled already does without it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

# Numba would count the users of each array at every call of a function; nobody makes or frees one here.
UNCOUNTED: Any = {"_nrt": False}
F = TypeVar("F", bound=Callable[..., Any])
_WAITING: list[tuple[Callable[..., Any], Callable[..., Any]]] = []


def compilable(function: F) -> F:
    """A function that may be called from compiled ones."""
    return compilable_for(function)(function)


def compilable_for(function: Callable[..., Any]) -> Callable[[F], F]:
    """What stands for a function in compiled ones, where its own text cannot be compiled."""

    def noted(other: F) -> F:
        _WAITING.append((function, other))
        return other

    return noted


def told_to_compiler() -> None:
    """Let Numba know all of them."""
    from numba.extending import overload

    while _WAITING:
        function, compiled = _WAITING.pop(0)
        overload(function, jit_options=UNCOUNTED, strict=False)(_always(compiled))


def _always(function: Callable[..., Any]) -> Callable[..., Callable[..., Any]]:
    """The same for arguments of all types."""
    return lambda *_, **__: function
