"""The clock on the wall as the loop reads it and sleeps by it: two functions of POSIX, by address.

Where there is no clock_nanosleep (Windows, macOS) Python's own clock and sleep stand in their place; a call of them
costs about a microsecond, and they sleep as finely as the system does.
"""

from __future__ import annotations

import ctypes
import sys
import time
from functools import cache
from typing import Any

SECOND = 1_000_000_000  # ns
_READ = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_void_p)
_SLEEP = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)


@cache
def clock_functions() -> tuple[int, int]:
    """The addresses of what reads the clock and of what sleeps; see `loop.calls`."""
    if sys.platform == "linux" and sys.maxsize > 1 << 32:
        library = ctypes.CDLL(None)
        return _address(library.clock_gettime), _address(library.clock_nanosleep)
    return _address(PYTHON[0]), _address(PYTHON[1])


def _address(function: Any) -> int:
    return ctypes.cast(function, ctypes.c_void_p).value or 0


def _read(_clock: int, at: int) -> int:
    seconds, parts = divmod(time.monotonic_ns(), SECOND)
    ctypes.c_int64.from_address(at).value, ctypes.c_int64.from_address(at + 8).value = seconds, parts
    return 0


def _sleep(_clock: int, _how: int, at: int, _left: int) -> int:
    due = ctypes.c_int64.from_address(at).value * SECOND + ctypes.c_int64.from_address(at + 8).value
    time.sleep(max(due - time.monotonic_ns(), 0) / SECOND)
    return 0


PYTHON = _READ(_read), _SLEEP(_sleep)  # they live as long as the process


def now() -> int:
    """The same clock [ns], from Python."""
    return time.monotonic_ns()
