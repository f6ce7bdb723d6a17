"""FMI functions called by address: through ctypes in plain Python, as direct machine calls under Numba.

Every function here has both lives, so that `run.run` is one source for the interpreter and the compiled loop.
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
_INT32 = ir.IntType(32)
STEP_FLAGS = 16  # bytes that a step of FMI 3.0 writes
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
def _state(address: int) -> Any:
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(address)


def call_state(function: int, component: int, state: int) -> int:
    """Set an FMU's state (FMI 2 or 3) to the one given, or get or free one at the address given; the status."""
    return int(_state(int(function))(int(component), int(state)))


def byte_at(address: int) -> int:
    """The byte at an address, 0 to 255."""
    return ctypes.c_ubyte.from_address(int(address)).value


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
def _exchange3_native(
    typing: Any, function: Any, component: Any, references: Any, count: Any, values: Any, size: Any
) -> Any:
    signature = types.int32(*(types.int64,) * 6)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = cgutils.voidptr_t
        kind = ir.FunctionType(_INT32, [pointer, pointer, _INT64, pointer, _INT64])
        target = builder.inttoptr(args[0], kind.as_pointer())
        component, references, values = (_pointer(builder, args[k]) for k in (1, 2, 4))
        return builder.call(target, [component, references, args[3], values, args[5]])

    return signature, codegen


@intrinsic
def _exchange_bytes_native(
    typing: Any, function: Any, component: Any, references: Any, count: Any, sizes: Any, values: Any, size: Any
) -> Any:
    signature = types.int32(*(types.int64,) * 7)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = cgutils.voidptr_t
        kind = ir.FunctionType(_INT32, [pointer, pointer, _INT64, pointer, pointer, _INT64])
        target = builder.inttoptr(args[0], kind.as_pointer())
        component, references, sizes, values = (_pointer(builder, args[k]) for k in (1, 2, 4, 5))
        return builder.call(target, [component, references, args[3], sizes, values, args[6]])

    return signature, codegen


@intrinsic
def _do_step3_native(typing: Any, function: Any, component: Any, time: Any, step: Any, final: Any, flags: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.float64, types.float64, types.int64, types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer, double = cgutils.voidptr_t, ir.DoubleType()
        kind = ir.FunctionType(_INT32, [pointer, double, double, _INT32, *(pointer,) * 4])
        target = builder.inttoptr(args[0], kind.as_pointer())
        ends = [_pointer(builder, builder.add(args[5], ir.Constant(_INT64, k))) for k in (0, 1, 2, 8)]
        for flag in ends[:3]:
            builder.store(ir.Constant(ir.IntType(8), 0), flag)
        final = builder.trunc(args[4], _INT32)
        return builder.call(target, [_pointer(builder, args[1]), args[2], args[3], final, *ends])

    return signature, codegen


@intrinsic
def _call_state_native(typing: Any, function: Any, component: Any, state: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(_INT32, [cgutils.voidptr_t, cgutils.voidptr_t])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(target, [_pointer(builder, args[1]), _pointer(builder, args[2])])

    return signature, codegen


@intrinsic
def _byte_at_native(typing: Any, address: Any) -> Any:
    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.zext(builder.load(_pointer(builder, args[0])), _INT64)

    return types.int64(types.int64), codegen


@intrinsic
def _do_step_native(typing: Any, function: Any, component: Any, time: Any, step: Any, final: Any) -> Any:
    signature = types.int32(types.int64, types.int64, types.float64, types.float64, types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(ir.IntType(32), [cgutils.voidptr_t, ir.DoubleType(), ir.DoubleType(), ir.IntType(32)])
        target = builder.inttoptr(args[0], kind.as_pointer())
        final = builder.trunc(args[4], _INT32)
        return builder.call(target, [_pointer(builder, args[1]), args[2], args[3], final])

    return signature, codegen


# Numba compares the argument names and annotations of an overload with those of its implementation: neither has any.
@overload(exchange2)
def _exchange_overload(function, component, references, count, values):  # type: ignore[no-untyped-def]
    return lambda function, component, references, count, values: _exchange_native(
        function, component, references, count, values
    )  # type: ignore[call-arg]


@overload(do_step)
def _do_step_overload(function, component, time, step, final):  # type: ignore[no-untyped-def]
    return lambda function, component, time, step, final: _do_step_native(function, component, time, step, final)  # type: ignore[call-arg]


@overload(exchange3)
def _exchange3_overload(function, component, references, count, values, size):  # type: ignore[no-untyped-def]
    return lambda function, component, references, count, values, size: _exchange3_native(
        function, component, references, count, values, size
    )  # type: ignore[call-arg]


@overload(exchange_bytes)
def _exchange_bytes_overload(function, component, references, count, sizes, values, size):  # type: ignore[no-untyped-def]
    return lambda function, component, references, count, sizes, values, size: _exchange_bytes_native(
        function, component, references, count, sizes, values, size
    )  # type: ignore[call-arg]


@overload(do_step3)
def _do_step3_overload(function, component, time, step, final, flags):  # type: ignore[no-untyped-def]
    return lambda function, component, time, step, final, flags: _do_step3_native(
        function, component, time, step, final, flags
    )  # type: ignore[call-arg]


@overload(byte_at)
def _byte_at_overload(address):  # type: ignore[no-untyped-def]
    return lambda address: _byte_at_native(address)  # type: ignore[call-arg]


@overload(call_state)
def _call_state_overload(function, component, state):  # type: ignore[no-untyped-def]
    return lambda function, component, state: _call_state_native(function, component, state)  # type: ignore[call-arg]
