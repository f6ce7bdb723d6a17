"""What foreign code leaves running behind its end: threads of its own, and handlers of signals.

A library that is unloaded under them ends the process, some time later.
"""

from __future__ import annotations

import os
import threading

from ..surroundings import WATCHED, handler_of

TASKS = "/proc/self/task"  # of Linux: a folder for each thread
SIGNALS = tuple(number for number in range(1, 32) if number not in WATCHED)  # those are given back in any case


class Leftovers:
    """What there was before an FMU was loaded."""

    def __init__(self) -> None:
        self._threads, self._handlers = _threads(), _handlers()

    def any(self) -> bool:
        """Whether there is more now, or the system does not say."""
        return not self._threads or not _threads() <= self._threads or _handlers() != self._handlers


def _threads() -> frozenset[int]:
    """The numbers of all threads but Python's; none where the system does not say."""
    if not os.path.isdir(TASKS):
        return frozenset()
    python = {thread.native_id for thread in threading.enumerate()} - {threading.main_thread().native_id}
    return frozenset(set(map(int, os.listdir(TASKS))) - python)


def _handlers() -> tuple[int, ...]:
    """What the system calls at each signal."""
    return tuple(map(handler_of, SIGNALS)) if os.path.isdir(TASKS) else ()
