"""CVODE of SUNDIALS: made here by ctypes, called in steps by address."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from ..cells import (
    ABSOLUTE,
    CV_ABSOLUTE,
    CV_BAND,
    CV_COLUMN,
    CV_DATA,
    CV_FOUND,
    CV_LOWER,
    CV_POINTER,
    CV_REACHED,
    CV_REINIT,
    CV_ROOTS,
    CV_STATES,
    CV_STEP,
    CV_STOP_TIME,
    CV_TOLERANCES,
    CV_UPPER,
    CVODE,
    INDICATORS,
    RELATIVE,
    STATES,
    TIME,
    X,
)
from ..compiled import address_of
from ..memory import number, put_whole, whole
from ..settings import SolverSettings
from .libraries import libraries

BDF = 2
MOST_STEPS = 100_000  # between two returns


def _function(name: str) -> Any:
    for library in libraries():
        with suppress(AttributeError):
            return library[name]  # one of our own: fmpy states types of those that it uses
    raise AttributeError(f"SUNDIALS has no function {name}")


def address(name: str) -> int:
    """The address of a function of SUNDIALS."""
    return ctypes.cast(_function(name), ctypes.c_void_p).value or 0


def _made(name: str, *arguments: Any) -> int:
    """What a function that makes something gives: its address."""
    function = _function(name)
    function.restype = ctypes.c_void_p
    return int(function(*arguments) or 0)


def _done(name: str, *arguments: Any) -> None:
    function = _function(name)
    function.restype = ctypes.c_int
    if flag := function(*arguments):
        raise RuntimeError(f"{name} answered {flag}")


def _pointer(address: int) -> Any:
    return ctypes.c_void_p(address)


class Cvode:
    """An integrator of a group, with its context, vectors, matrix and linear solver, until `free`.

    `bands`: the widths below and above the diagonal where the Jacobian is a band; None where it is dense. `exact`: it
    is made of directional derivatives, otherwise of differences.
    """

    def __init__(
        self, g: int, settings: SolverSettings, bands: tuple[int, int] | None, exact: bool,
        functions: Mapping[str, int] | None = None, data: int = 0,
    ) -> None:  # fmt: skip
        functions = functions or {name: address_of(name) for name in ("right_hand_side", "jacobian", "roots")}
        n, indicators = max(whole(g + STATES), 1), whole(g + INDICATORS)
        self._reached, self._found = (ctypes.c_double * 1)(), (ctypes.c_int32 * max(indicators, 1))()
        context = ctypes.c_void_p()
        _done("SUNContext_Create", ctypes.c_int(0), ctypes.byref(context))
        self._context = context
        _done("SUNContext_ClearErrHandlers", context)  # it would write to stderr; messages are made of its flags
        vectors = (_made("N_VMake_Serial", ctypes.c_int64(n), _pointer(whole(g + a)), context) for a in (X, ABSOLUTE))
        self._x, self._absolute = map(_pointer, vectors)
        self._memory = memory = _pointer(_made("CVodeCreate", ctypes.c_int(BDF), context))
        begin = ctypes.c_double(number(g + TIME))
        _done("CVodeInit", memory, _pointer(functions["right_hand_side"]), begin, self._x)
        _done("CVodeSVtolerances", memory, ctypes.c_double(number(g + RELATIVE)), self._absolute)
        _done("CVodeSetUserData", memory, _pointer(data or g))
        if bands:
            lower, upper = map(ctypes.c_int64, bands)
            self._matrix = _pointer(_made("SUNBandMatrix", ctypes.c_int64(n), upper, lower, context))
            self._solver = _pointer(_made("SUNLinSol_Band", self._x, self._matrix, context))
        else:
            self._matrix = _pointer(_made("SUNDenseMatrix", ctypes.c_int64(n), ctypes.c_int64(n), context))
            self._solver = _pointer(_made("SUNLinSol_Dense", self._x, self._matrix, context))
        _done("CVodeSetLinearSolver", memory, self._solver, self._matrix)
        if exact:
            _done("CVodeSetJacFn", memory, _pointer(functions["jacobian"]))
        if indicators:
            _done("CVodeRootInit", memory, ctypes.c_int(indicators), _pointer(functions["roots"]))
            _done("CVodeSetNoInactiveRootWarn", memory)
        _done("CVodeSetMaxNumSteps", memory, ctypes.c_long(MOST_STEPS))
        _done("CVodeSetMaxOrd", memory, ctypes.c_int(settings.max_order))
        if settings.max_step:
            _done("CVodeSetMaxStep", memory, ctypes.c_double(settings.max_step))
        self._into(g, bands)

    def _into(self, g: int, bands: tuple[int, int] | None) -> None:
        """What the steps of a group call, into its table."""
        column = address("SUNBandMatrix_Column" if bands else "SUNDenseMatrix_Column")
        for cell, value in (
            (CVODE, self._memory.value), (CV_STATES, self._x.value), (CV_ABSOLUTE, self._absolute.value),
            (CV_STEP, address("CVode")), (CV_REINIT, address("CVodeReInit")),
            (CV_STOP_TIME, address("CVodeSetStopTime")), (CV_ROOTS, address("CVodeGetRootInfo")),
            (CV_TOLERANCES, address("CVodeSVtolerances")), (CV_POINTER, address("N_VGetArrayPointer")),
            (CV_REACHED, ctypes.addressof(self._reached)), (CV_FOUND, ctypes.addressof(self._found)),
            (CV_DATA, self._behind(whole(g + X))),
            (CV_COLUMN, column), (CV_BAND, int(bands is not None)), (CV_LOWER, bands[0] if bands else 0),
            (CV_UPPER, bands[1] if bands else 0),
        ):  # fmt: skip
            put_whole(g + cell, value or 0)

    def _behind(self, values: int) -> int:
        """How far behind the first pointer of a vector that of its values is [bytes], by the size of its indices; 0
        where it is elsewhere."""
        content = whole(self._x.value or 0)
        return next((place for place in (16, 8) if whole(content + place) == values), 0)

    def free(self) -> None:
        """Give all of it back, once."""
        if self._memory.value:
            for name, what in (("CVodeFree", self._memory), ("SUNContext_Free", self._context)):
                if name == "SUNContext_Free":
                    for free, part in (("SUNLinSolFree", self._solver), ("SUNMatDestroy", self._matrix)):
                        _function(free)(part)
                    for vector in (self._x, self._absolute):
                        _function("N_VDestroy")(vector)
                _function(name)(ctypes.byref(what))
            self._memory.value = None
