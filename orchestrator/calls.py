"""FMI 2.0 functions called by address: through ctypes in plain Python, as direct machine calls under Numba.

Every function here has both lives, so that `execute.run` is one source for the interpreter and the compiled loop.
All addresses are data; one cached compilation serves every system.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, overload

_INT64 = ir.IntType(64)


@cache
def _set_or_get(address: int) -> Any:
    kind = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p)
    return kind(address)


@cache
def _do_step(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int)(address)


def exchange(function: int, component: int, references: int, count: int, values: int) -> int:
    """fmi2SetReal or fmi2GetReal: `count` values at address `values`, value references at `references`; the status."""
    return int(_set_or_get(int(function))(int(component), int(references), int(count), int(values)))


def do_step(function: int, component: int, time: float, step: float) -> int:
    """fmi2DoStep from `time` over `step` seconds; the status."""
    return int(_do_step(int(function))(int(component), time, step, 1))


@cache
def _state(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(address)


def call_state(function: int, component: int, state: int) -> int:
    """fmi2SetFMUstate with a state, fmi2GetFMUstate or fmi2FreeFMUstate with the address of one; the status."""
    return int(_state(int(function))(int(component), int(state)))


def _pointer(builder: Any, value: Any) -> Any:
    return builder.inttoptr(value, cgutils.voidptr_t)


@intrinsic
def _exchange_native(typing: Any, function: Any, component: Any, references: Any, count: Any, values: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.int64, types.int64, types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(ir.IntType(32), [cgutils.voidptr_t, cgutils.voidptr_t, _INT64, cgutils.voidptr_t])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(
            target, [_pointer(builder, args[1]), _pointer(builder, args[2]), args[3], _pointer(builder, args[4])]
        )

    return signature, codegen


@intrinsic
def _do_step_native(typing: Any, function: Any, component: Any, time: Any, step: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.float64, types.float64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(ir.IntType(32), [cgutils.voidptr_t, ir.DoubleType(), ir.DoubleType(), ir.IntType(32)])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(target, [_pointer(builder, args[1]), args[2], args[3], ir.Constant(ir.IntType(32), 1)])

    return signature, codegen


@intrinsic
def _call_state_native(typing: Any, function: Any, component: Any, state: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(ir.IntType(32), [cgutils.voidptr_t, cgutils.voidptr_t])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(target, [_pointer(builder, args[1]), _pointer(builder, args[2])])

    return signature, codegen


# Numba compares the argument names and annotations of an overload with those of its implementation: neither has any.
@overload(exchange)
def _exchange_overload(function, component, references, count, values):  # type: ignore[no-untyped-def]
    return lambda function, component, references, count, values: _exchange_native(
        function, component, references, count, values
    )  # type: ignore[call-arg]


@overload(do_step)
def _do_step_overload(function, component, time, step):  # type: ignore[no-untyped-def]
    return lambda function, component, time, step: _do_step_native(function, component, time, step)  # type: ignore[call-arg]


@overload(call_state)
def _call_state_overload(function, component, state):  # type: ignore[no-untyped-def]
    return lambda function, component, state: _call_state_native(function, component, state)  # type: ignore[call-arg]
