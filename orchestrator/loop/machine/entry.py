"""`run.run` as a function of C that Numba compiles: its arrays are read off the table of `frame.py`."""

from __future__ import annotations

# mypy: disable-error-code="no-untyped-call,no-untyped-def"
# What the compiler reads has no types of Python.
from typing import Any

from numba import carray, types  # type: ignore[attr-defined]
from numba.extending import intrinsic, register_jitable

from ..lives import UNCOUNTED, told_to_compiler
from ..run import run
from . import calls as calls  # what FMI functions are in machine code
from .frame import ARRAYS, WHOLE_NUMBERS, WORDS

told_to_compiler()
ARGUMENTS = len(ARRAYS)
_run = register_jitable(**UNCOUNTED)(run)
SIGNATURE = types.int64(*(types.int64,) * (1 + WHOLE_NUMBERS))


def _pointer_to(kind: Any) -> Any:
    """A pointer to an array of numbers, from an address."""

    @intrinsic
    def pointer(typing: Any, address: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, given: Any) -> Any:
            return builder.inttoptr(given[0], context.get_value_type(types.CPointer(kind)))

        return types.CPointer(kind)(types.int64), codegen

    return pointer


_words, _doubles = _pointer_to(types.int64), _pointer_to(types.float64)
_floats, _bytes = _pointer_to(types.float32), _pointer_to(types.uint8)


@register_jitable
def _table(frame, k):
    at = WORDS * k
    return carray(_words(frame[at]), (frame[at + 1], frame[at + 2]))


@register_jitable
def _cells(frame, k):
    return carray(_words(frame[WORDS * k]), (frame[WORDS * k + 1],))


@register_jitable
def _numbers(frame, k):
    return carray(_doubles(frame[WORDS * k]), (frame[WORDS * k + 1],))


@register_jitable
def _floats_at(frame, k):
    return carray(_floats(frame[WORDS * k]), (frame[WORDS * k + 1],))


@register_jitable
def _bytes_at(frame, k):
    return carray(_bytes(frame[WORDS * k]), (frame[WORDS * k + 1],))


def entry(address, first_cycle, cycles, cycle_ticks, numerator, denominator):
    """The kinds stand in `frame.ARRAYS`, in the same order."""
    f = carray(_words(address), (WORDS * ARGUMENTS,))
    return run(
        _table(f, 0), _numbers(f, 1), _table(f, 2), _table(f, 3),
        _numbers(f, 4), _cells(f, 5), _bytes_at(f, 6), _floats_at(f, 7), _bytes_at(f, 8), _cells(f, 9),
        _cells(f, 10), _table(f, 11), _numbers(f, 12), _cells(f, 13),
        _cells(f, 14),
        _cells(f, 15), _numbers(f, 16), _numbers(f, 17), _numbers(f, 18),
        _cells(f, 19), _table(f, 20),
        _table(f, 21), _table(f, 22),
        first_cycle, cycles, cycle_ticks, numerator, denominator,
    )  # fmt: skip
