"""Ctrl-C during a run."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

import numpy as np

from ..loop import cells


@contextmanager
def stop_on_interrupt(control: np.ndarray) -> Iterator[None]:
    """Ctrl-C stops the loop at the next instant instead of raising inside an FMU's Python code; twice insists."""
    ignored = signal.getsignal(signal.SIGINT) is signal.SIG_IGN  # nohup, and the processes of a sweep
    if ignored or threading.current_thread() is not threading.main_thread():
        yield
        return

    def request(_signal: int, _frame: Any) -> None:
        if control[cells.STOP_REQUEST]:
            raise KeyboardInterrupt
        control[cells.STOP_REQUEST] = 1

    before = signal.signal(signal.SIGINT, request)
    try:
        yield
    finally:
        with suppress(TypeError, ValueError):
            signal.signal(signal.SIGINT, before)
