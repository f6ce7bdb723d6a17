"""Waits for what is outside of the program: a signal that asks the run to stop ends them at once.

Elsewhere such a signal lets the step that is under way come to its end, which here would be a timeout away.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager


class _Now:
    waits = 0  # blocks that are under way
    came = False  # a signal that nobody waited for yet


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """In the block, and before it, the first signal raises KeyboardInterrupt, where it would be noted elsewhere."""
    if _Now.came:
        raise KeyboardInterrupt
    _Now.waits += 1
    try:
        yield
    finally:
        _Now.waits -= 1


def signal_came() -> None:
    """Of the handler of a signal. Raises KeyboardInterrupt where a wait is under way."""
    _Now.came = True
    if _Now.waits:
        raise KeyboardInterrupt


def none_came() -> None:
    """Signals are heard from now on, or no longer."""
    _Now.came = False
