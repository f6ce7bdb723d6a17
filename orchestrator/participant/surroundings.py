"""What foreign code in this process can change for all of it: the working directory, how numbers are rounded, and what
becomes of signals.
"""

from __future__ import annotations

import ctypes
import os
import signal
import threading
from functools import cache
from typing import Any

ONE, LITTLE, MUCH, DENORMAL = 1.0, 2.0**-54, 1.5 * 2.0**-53, 2.0**-1074
ENVIRONMENT = 256  # bytes, more than a C library needs to keep its floating-point environment (fenv_t)
ACTION = 256  # and to say what becomes of a signal (struct sigaction), which begins with the address of the handler
# Signals that end a run, and those of broken pipes and of processes that have ended. Others stay what an FMU's runtime
# has made of them: that of Java needs SIGSEGV.
WATCHED = tuple(
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGPIPE", "SIGCHLD") if hasattr(signal, name)
)


@cache
def _library() -> Any:
    """The C library's functions of <fenv.h>; None where this process does not have them."""
    for name in (None, "libm.so.6", "libm.dylib"):
        try:
            library = ctypes.CDLL(name)
        except (OSError, TypeError):
            continue
        if hasattr(library, "fegetenv"):
            return library
    return None


class Surroundings:
    """As they are now, to be looked after and restored; of signals that is what Python knows of them at any time."""

    def __init__(self) -> None:
        self.folder, self.exact, self.handlers = _folder(), exact(), _handlers()
        self.environment = ctypes.create_string_buffer(ENVIRONMENT)
        if _library():
            _library().fegetenv(self.environment)

    @property
    def disturbed(self) -> bool:
        """Whether numbers are no longer rounded as they were."""
        return self.exact and not exact()

    def restore(self, folder: bool = True) -> list[str]:
        """Restore what was changed; each as words to go behind a name.

        `folder`: whether to look at that, and at signals, too (25 us).
        """
        found = []
        if self.disturbed and _library():
            _library().fesetenv(self.environment)
            found.append("changed how floating-point numbers are rounded")
        if folder and self.folder and (now := _folder()) != self.folder:
            found.append(f"changed the working directory to {now or 'a folder that is gone'}")
            try:
                os.chdir(self.folder)
            except OSError as error:
                found[-1] += f", and the one before, {self.folder}, cannot be entered again ({error.strerror})"
        taken = self._taken() if folder else []
        for number in taken:
            signal.signal(number, signal.getsignal(number))
        if taken:
            found.append(f"changed what becomes of the signals {', '.join(number.name for number in taken)}")
        return found

    def _taken(self) -> list[signal.Signals]:
        """Signals of which Python says one thing and the system another; only the main thread can give them back."""
        if not self.handlers or threading.current_thread() is not threading.main_thread():
            return []
        here = [number for number in self.handlers if signal.getsignal(number) is not None]
        return [number for number in here if handler_of(number) != _expected(number)]


def exact() -> bool:
    """Whether numbers are rounded to the nearest, and denormal ones are numbers."""
    return ONE + LITTLE == ONE and ONE + MUCH != ONE and DENORMAL * ONE != 0.0


@cache
def _process() -> Any:
    return ctypes.CDLL(None)


def _handlers() -> tuple[signal.Signals, ...]:
    """The watched signals that are as Python says: what others took before is theirs."""
    if threading.current_thread() is not threading.main_thread():
        return ()
    try:
        return tuple(number for number in WATCHED if handler_of(number) == _expected(number))
    except (OSError, AttributeError):  # Windows
        return ()


def handler_of(number: int) -> int:
    """The address of what the system calls at a signal; 0: the default, 1: nothing."""
    action = ctypes.create_string_buffer(ACTION)
    if _process().sigaction(int(number), None, action):
        raise OSError(f"signal {number}")
    return int.from_bytes(action.raw[: ctypes.sizeof(ctypes.c_void_p)], "little")


def _expected(number: int) -> int:
    """What that address is where Python decides."""
    known = signal.getsignal(number)
    return _own_handler() if callable(known) else int(known or 0)


@cache
def _own_handler() -> int:
    """The address of the function by which Python hears of all signals that it handles."""
    spare = signal.SIGXFSZ
    before = signal.signal(spare, lambda _number, _frame: None)
    try:
        return handler_of(spare)
    finally:
        signal.signal(spare, before)


def _folder() -> str:
    try:
        return os.getcwd()
    except OSError:
        return ""
