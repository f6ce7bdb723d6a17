"""What foreign code in this process can change for all of it: the working directory, and how numbers are rounded."""

from __future__ import annotations

import ctypes
import os
from functools import cache
from typing import Any

ONE, LITTLE, MUCH, DENORMAL = 1.0, 2.0**-54, 1.5 * 2.0**-53, 2.0**-1074
ENVIRONMENT = 256  # bytes, more than a C library needs to keep its floating-point environment (fenv_t)


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
    """As they are now, to be looked after and restored."""

    def __init__(self) -> None:
        self.folder, self.exact = _folder(), exact()
        self.environment = ctypes.create_string_buffer(ENVIRONMENT)
        if _library():
            _library().fegetenv(self.environment)

    def restore(self, folder: bool = True) -> list[str]:
        """Restore what was changed; each as words to go behind a name. `folder`: whether to look at that too (1 us)."""
        found = []
        if self.exact and not exact() and _library():
            _library().fesetenv(self.environment)
            found.append("changed how floating-point numbers are rounded")
        if folder and self.folder and (now := _folder()) != self.folder:
            found.append(f"changed the working directory to {now or 'a folder that is gone'}")
            try:
                os.chdir(self.folder)
            except OSError as error:
                found[-1] += f", and the one before, {self.folder}, cannot be entered again ({error.strerror})"
        return found


def exact() -> bool:
    """Whether numbers are rounded to the nearest, and denormal ones are numbers."""
    return ONE + LITTLE == ONE and ONE + MUCH != ONE and DENORMAL * ONE != 0.0


def _folder() -> str:
    try:
        return os.getcwd()
    except OSError:
        return ""
