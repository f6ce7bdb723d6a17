"""FMI functions called by address, in machine code: what stands there for the functions of `loop/calls.py`."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, overload

from ..calls import (
    ABSOLUTE,
    MONOTONIC,
    byte_at,
    call_segment,
    call_state,
    do_step,
    do_step3,
    exchange2,
    exchange3,
    exchange_bytes,
    read_clock,
    sleep_until,
)

_INT64 = ir.IntType(64)
_INT32 = ir.IntType(32)


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
def _call_segment_native(
    typing: Any, function: Any, pointers: Any, base: Any, varying: Any, numerator: Any, denominator: Any, stop: Any
) -> Any:
    signature = types.int64(*(types.int64,) * 6, types.float64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(_INT64, [cgutils.voidptr_t, *(_INT64,) * 4, ir.DoubleType()])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(target, [_pointer(builder, args[1]), *args[2:]])

    return signature, codegen


@intrinsic
def _read_clock_native(typing: Any, function: Any, at: Any) -> Any:
    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(_INT32, [_INT32, cgutils.voidptr_t])
        target = builder.inttoptr(args[0], kind.as_pointer())
        return builder.call(target, [ir.Constant(_INT32, MONOTONIC), _pointer(builder, args[1])])

    return types.int32(types.int64, types.int64), codegen


@intrinsic
def _sleep_until_native(typing: Any, function: Any, at: Any) -> Any:
    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = cgutils.voidptr_t
        kind = ir.FunctionType(_INT32, [_INT32, _INT32, pointer, pointer])
        target = builder.inttoptr(args[0], kind.as_pointer())
        clock, how = ir.Constant(_INT32, MONOTONIC), ir.Constant(_INT32, ABSOLUTE)
        return builder.call(target, [clock, how, _pointer(builder, args[1]), ir.Constant(pointer, None)])

    return types.int32(types.int64, types.int64), codegen


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


@overload(call_segment)
def _call_segment_overload(function, pointers, base, varying, numerator, denominator, stop):  # type: ignore[no-untyped-def]
    return lambda function, pointers, base, varying, numerator, denominator, stop: _call_segment_native(
        function, pointers, base, varying, numerator, denominator, stop
    )  # type: ignore[call-arg]


@overload(read_clock)
def _read_clock_overload(function, at):  # type: ignore[no-untyped-def]
    return lambda function, at: _read_clock_native(function, at)  # type: ignore[call-arg]


@overload(sleep_until)
def _sleep_until_overload(function, at):  # type: ignore[no-untyped-def]
    return lambda function, at: _sleep_until_native(function, at)  # type: ignore[call-arg]
