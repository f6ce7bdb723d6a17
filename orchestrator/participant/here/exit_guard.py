"""Keeps the exit code of a process that has loaded a pythonfmu FMU.

The library that pythonfmu 0.7.0 puts into its FMUs destroys a static object twice when the process ends, which aborts
the process now and then, long after all results are written. On Linux the C library can be told to end the process
just before that, with the exit code it already has. Python's own exit handlers and the C streams are done by then.
"""

from __future__ import annotations

import ctypes
import sys
from functools import cache


@cache
def end_before_library_destructors() -> None:
    """Register, once: flush the C streams, then `_exit` with the code of the process (handlers run last to first)."""
    if sys.platform != "linux":
        return
    libc = ctypes.CDLL(None)
    if not hasattr(libc, "on_exit"):  # not glibc
        return
    libc.on_exit(ctypes.cast(libc._exit, ctypes.c_void_p), None)
    libc.__getattr__("__cxa_atexit")(ctypes.cast(libc.fflush, ctypes.c_void_p), None, None)
