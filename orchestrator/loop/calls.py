"""FMI functions called by address: through ctypes in plain Python, as direct machine calls under Numba.

Every function here has both lives, so that `run.run` is one source for the interpreter and the compiled loop; the
other one stands in `machine/calls.py`. All addresses are data; one compilation serves every system.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

STEP_FLAGS = 16  # bytes that a step of FMI 3.0 writes
MONOTONIC, ABSOLUTE = 1, 1  # CLOCK_MONOTONIC and TIMER_ABSTIME of Linux
EVENT_NEEDED, TERMINATES, EARLY_RETURN, LAST_TIME = 0, 1, 2, 8  # where: three flags, and the last time that it reached


@cache
def _set_or_get(address: int) -> Any:
    kind = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p)
    return kind(address)


@cache
def _set_or_get3(address: int) -> Any:
    kind = ctypes.CFUNCTYPE(
        ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t
    )
    return kind(address)


@cache
def _set_or_get_bytes(address: int) -> Any:
    kind = ctypes.CFUNCTYPE(
        ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p,
        ctypes.c_size_t,
    )  # fmt: skip
    return kind(address)


@cache
def _do_step(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int)(address)


@cache
def _do_step3(address: int) -> Any:
    return ctypes.CFUNCTYPE(
        ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_bool, *(ctypes.c_void_p,) * 4
    )(address)


def exchange2(function: int, component: int, references: int, count: int, values: int) -> int:
    """fmi2SetReal, fmi2GetInteger...: `count` values at address `values`, for those at `references`; the status."""
    return int(_set_or_get(int(function))(int(component), int(references), int(count), int(values)))


def exchange3(function: int, component: int, references: int, count: int, values: int, size: int) -> int:
    """fmi3SetFloat64, fmi3GetInt32...: `size` values at address `values` for `count` references; the status."""
    return int(_set_or_get3(int(function))(int(component), int(references), int(count), int(values), int(size)))


def exchange_bytes(
    function: int, component: int, references: int, count: int, sizes: int, values: int, size: int
) -> int:
    """fmi3SetBinary, fmi3GetBinary: `size` addresses at `values`, of so many bytes each as at `sizes`; the status."""
    call = _set_or_get_bytes(int(function))
    return int(call(int(component), int(references), int(count), int(sizes), int(values), int(size)))


def do_step(function: int, component: int, time: float, step: float, final: int) -> int:
    """fmi2DoStep from `time` over `step` seconds; the status. `final`: 1 if no state before `time` will be restored."""
    return int(_do_step(int(function))(int(component), time, step, int(final)))


def do_step3(function: int, component: int, time: float, step: float, final: int, flags: int) -> int:
    """fmi3DoStep; the FMU writes its three flags and its last time to the address `flags` (see STEP_FLAGS)."""
    ends = (int(flags), int(flags) + 1, int(flags) + 2, int(flags) + 8)
    ctypes.memset(int(flags), 0, 3)
    return int(_do_step3(int(function))(int(component), time, step, bool(final), *ends))


@cache
def _read_clock(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_void_p)(address)


@cache
def _sleep_until(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(address)


def read_clock(function: int, at: int) -> int:
    """clock_gettime of POSIX: seconds and nanoseconds of a clock that nobody sets, to an address; 0 if all is well."""
    return int(_read_clock(int(function))(MONOTONIC, int(at)))


def sleep_until(function: int, at: int) -> int:
    """clock_nanosleep of POSIX, to the time of that clock at an address; not 0 where a signal came before it."""
    return int(_sleep_until(int(function))(MONOTONIC, ABSOLUTE, int(at), None))


@cache
def _state(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(address)


def call_state(function: int, component: int, state: int) -> int:
    """Set an FMU's state (FMI 2 or 3) to the one given, or get or free one at the address given; the status."""
    return int(_state(int(function))(int(component), int(state)))


@cache
def _segment(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p, *(ctypes.c_int64,) * 4, ctypes.c_double)(address)


def call_segment(
    function: int, pointers: int, base: int, varying: int, numerator: int, denominator: int, stop: float
) -> int:
    """Operations that have machine code of their own (`straight/functions.py`): DONE, or what the loop ends with."""
    return int(_segment(int(function))(int(pointers), int(base), int(varying), int(numerator), int(denominator), stop))


def byte_at(address: int) -> int:
    """The byte at an address, 0 to 255."""
    return ctypes.c_ubyte.from_address(int(address)).value
