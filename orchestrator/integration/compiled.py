"""The functions of a group that others call: compiled, and kept by Numba under names that hold a hash of their sources.

They hold no address, so that one compilation serves every group. With NUMBA_DISABLE_JIT they are plain Python.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from ..loop.lives import told_to_compiler
from ..loop.machine.compiled import Kept, loop_hash, numba_compiles
from . import connections, members, one_step, saved
from . import step as steps
from .events import rounds, shared
from .stiff import cvode, jacobian

# What C passes: w a whole number or pointer, d a double, b a truth value.
FUNCTIONS: dict[str, tuple[Callable[..., int], str]] = {
    "evaluate": (members.evaluate_all, "wdww"),
    "exchange": (connections.exchange_all, "w"),
    "indicate": (members.indicate_all, "ww"),
    "trial": (one_step.try_step, "wdd"),
    "settle": (rounds.settle_all, "w"),
    "enter": (shared.enter, "w"),
    "round": (shared.go_round, "w"),
    "leave": (shared.leave, "w"),
    "step": (steps.step, "wddwwwww"),
    "step2": (steps.step2, "wddw"),
    "begin": (steps.start, "w"),
    "save": (saved.save, "ww"),
    "restore": (saved.restore, "ww"),
    "forget": (saved.forget, "ww"),
    "right_hand_side": (cvode.right_hand_side, "dwww"),
    "roots": (cvode.roots, "dwww"),
    "jacobian": (jacobian.jacobian, "dwwwwwww"),
}


@cache
def address_of(name: str) -> int:
    """The address of one of FUNCTIONS."""
    function, kinds = FUNCTIONS[name]
    return _address(function, kinds, _hash(function.__module__))[0]


@cache
def _hash(module: str) -> str:
    """Of all sources that a function of a module is compiled from."""
    return loop_hash(Path(sys.modules[module].__file__ or ""))


def is_compiled() -> bool:
    """Whether little is left to compile: a step was, on this machine, or nothing is to be."""
    if not numba_compiles():
        return True
    digest = _hash(steps.__name__)
    return any(Kept(FUNCTIONS[name][0], digest).is_there for name in ("step", "step2"))  # by the members' version


@cache
def _address(function: Callable[..., int], kinds: str, digest: str) -> tuple[int, Any]:
    """The address, and what must live as long as it is used."""
    if not numba_compiles():
        types: dict[str, Any] = {"w": ctypes.c_int64, "d": ctypes.c_double, "b": ctypes.c_bool}
        made = ctypes.CFUNCTYPE(ctypes.c_int, *(types[kind] for kind in kinds))(function)
        return ctypes.cast(made, ctypes.c_void_p).value or 0, made
    import numba

    told_to_compiler()
    known = {"w": numba.int64, "d": numba.float64, "b": numba.uint8}
    signature = numba.int32(*(known[kind] for kind in kinds))
    compiled = Kept(function, digest, forceinline=True).compiled(signature)
    return int(compiled.address), compiled
