"""Numbers at addresses, and functions at addresses: what compiled callbacks work with.

Every function has two lives, as in `loop/calls.py`: ctypes in plain Python, machine code under Numba. Addresses are
whole numbers; C takes doubles where a float is given, and whole numbers or pointers of 64 bits otherwise.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, overload, register_jitable

from ..loop.machine import calls as calls  # the loop's functions at addresses, which the group's functions call too

into_caller = register_jitable(forceinline=True)  # what is compiled as a part of its caller
_INT64, _INT32, _DOUBLE = ir.IntType(64), ir.IntType(32), ir.DoubleType()


@cache
def _prototype(kinds: tuple[bool, ...], answer: Any) -> Any:
    return ctypes.CFUNCTYPE(answer, *(ctypes.c_double if real else ctypes.c_int64 for real in kinds))


def _called(function: int, answer: Any, arguments: tuple[Any, ...]) -> int:
    kinds = tuple(isinstance(a, float) for a in arguments)
    given = (float(a) if real else int(a) for a, real in zip(arguments, kinds, strict=True))
    return int(_prototype(kinds, answer)(int(function))(*given))


def call(function: int, *arguments: Any) -> int:
    """What the function at an address, which gives an int, answers to floats and whole numbers."""
    return _called(function, ctypes.c_int, arguments)


def call_whole(function: int, *arguments: Any) -> int:
    """The same of a function that gives a pointer or another whole number of 64 bits."""
    return _called(function, ctypes.c_int64, arguments)


def number(address: int) -> float:
    """The double at an address."""
    return ctypes.c_double.from_address(int(address)).value


def put(address: int, value: float) -> None:
    """A double to an address."""
    ctypes.c_double.from_address(int(address)).value = value


def whole(address: int) -> int:
    """The whole number of 64 bits at an address."""
    return ctypes.c_int64.from_address(int(address)).value


def put_whole(address: int, value: int) -> None:
    """A whole number of 64 bits to an address."""
    ctypes.c_int64.from_address(int(address)).value = int(value)


def half(address: int) -> int:
    """The whole number of 32 bits at an address."""
    return ctypes.c_int32.from_address(int(address)).value


def put_byte(address: int, value: int) -> None:
    """A byte to an address."""
    ctypes.c_ubyte.from_address(int(address)).value = int(value)


def _native(answer: Any, result: Any) -> Any:
    @intrinsic
    def called(typing: Any, function: Any, arguments: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, given: Any) -> Any:
            values, kinds = [], []
            for k, kind in enumerate(signature.args[1].types):
                value = builder.extract_value(given[1], k)
                real = isinstance(kind, types.Float)
                values.append(value if real else context.cast(builder, value, kind, types.int64))
                kinds.append(_DOUBLE if real else _INT64)
            target = builder.inttoptr(given[0], ir.FunctionType(result, kinds).as_pointer())
            return builder.call(target, values)

        return answer(types.int64, arguments), codegen

    return called


def _load(kind: Any, answer: Any) -> Any:
    @intrinsic
    def load(typing: Any, address: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, given: Any) -> Any:
            return builder.load(builder.inttoptr(given[0], kind.as_pointer()))

        return answer(types.int64), codegen

    return load


def _store(kind: Any, taken: Any) -> Any:
    @intrinsic
    def store(typing: Any, address: Any, value: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, given: Any) -> Any:
            value = builder.trunc(given[1], kind) if kind == cgutils.int8_t else given[1]
            builder.store(value, builder.inttoptr(given[0], kind.as_pointer()))
            return context.get_dummy_value()

        return types.void(types.int64, taken), codegen

    return store


_call_native, _call_whole_native = _native(types.int32, _INT32), _native(types.int64, _INT64)
_number_native, _whole_native, _half_native = (
    _load(_DOUBLE, types.float64), _load(_INT64, types.int64), _load(_INT32, types.int32),
)  # fmt: skip
_put_native, _put_whole_native = _store(_DOUBLE, types.float64), _store(_INT64, types.int64)
_put_byte_native = _store(cgutils.int8_t, types.int64)


# Numba compares the argument names and annotations of an overload with those of its implementation: neither has any.
@overload(call)
def _call(function, *arguments):  # type: ignore[no-untyped-def]
    return lambda function, *arguments: _call_native(function, arguments)


@overload(call_whole)
def _call_whole(function, *arguments):  # type: ignore[no-untyped-def]
    return lambda function, *arguments: _call_whole_native(function, arguments)


@overload(number)
def _number(address):  # type: ignore[no-untyped-def]
    return lambda address: _number_native(address)


@overload(put)
def _put(address, value):  # type: ignore[no-untyped-def]
    return lambda address, value: _put_native(address, value)


@overload(whole)
def _whole(address):  # type: ignore[no-untyped-def]
    return lambda address: _whole_native(address)


@overload(put_whole)
def _put_whole(address, value):  # type: ignore[no-untyped-def]
    return lambda address, value: _put_whole_native(address, value)


@overload(half)
def _half(address):  # type: ignore[no-untyped-def]
    return lambda address: _half_native(address)


@overload(put_byte)
def _put_byte(address, value):  # type: ignore[no-untyped-def]
    return lambda address, value: _put_byte_native(address, value)
