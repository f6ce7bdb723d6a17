"""How many threads step the FMUs of a system, as it is written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from ..errors import InputError
from .model import System

AUTO, MOST = "auto", 256


def number_of_workers(value: object, fail: Callable[[str, str], InputError]) -> str:
    """A number from 1, or "auto". Raises what `fail` makes of a message and the key that it is about."""
    text = str(value).strip()
    if text == AUTO or (text.isascii() and text.isdigit() and 1 <= int(text) <= MOST):
        return text if text == AUTO else str(int(text))
    raise fail(f'workers = {value}: write a number of threads, 1 to {MOST}, or "auto" for as many as pay', "workers")


def with_workers(system: System, text: str) -> System:
    """A copy with what an option says. Raises InputError."""
    found = number_of_workers(text, lambda message, _key: InputError(message.replace("workers =", "--workers", 1)))
    return replace(system, workers=found)
