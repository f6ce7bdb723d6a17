"""A library under wine as those see it who pass calls on to it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from ..memory import ServerMemory

Passed = Callable[..., Any]


class Remote(Protocol):
    """See `library.WindowsLibrary`."""

    version: int
    memory: ServerMemory
    kept: list[Any]
    ask: Callable[[int], int]

    def call(self, name: str, references: int = 0, values: int = 0) -> int: ...

    def refuse(self, what: str) -> int: ...
