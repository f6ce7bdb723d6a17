"""From the end of a run to initialization mode again, and out of it: an instance that stays loaded.

Of FMI 2.0 by addresses, without asking before whether its mode allows it: a run of 20 steps takes no longer than the
checks of its start would. For FMUs of which it is known what a reset brings back, our own.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np

from ...errors import RunError
from ...fmu.types import Value, function_type
from ...participant.here.loaded import LoadedInstance
from ...participant.lifecycle import good

_FLAG, _REAL, _POINTER = ctypes.c_int, ctypes.c_double, ctypes.c_void_p


class Restart(Protocol):
    """Of one instance, with values that it always gets."""

    def enter(self, changed: Mapping[str, Value]) -> None:
        """Reset, set up, set its values with those that are other ones now, enter initialization mode."""

    def leave(self) -> None:
        """Leave initialization mode."""


def restart_of(instance: LoadedInstance, known: Mapping[str, Value], stop: float, start: float) -> Restart:
    """For a run between two times [s]."""
    return (ByAddress if instance.fmu.version == 2 else Checked)(instance, known, stop, start)


class Checked:
    """As the start of any run does it."""

    def __init__(self, instance: LoadedInstance, known: Mapping[str, Value], stop: float, start: float) -> None:
        self._instance, self._known, self._limits = instance, known, (stop, start)

    def enter(self, changed: Mapping[str, Value]) -> None:
        """Raises FmuError if the FMU refuses."""
        self._instance.reset()
        self._instance.arrays.clear()
        self._instance.set_up(*self._limits)
        self._instance.set_all({**self._known, **changed})
        self._instance.enter_initialization()

    def leave(self) -> None:
        """Raises FmuError if the FMU refuses."""
        self._instance.exit_initialization()


class ByAddress:
    """The functions of FMI 2.0 bound once; floating-point values are set by one call."""

    def __init__(self, instance: LoadedInstance, known: Mapping[str, Value], stop: float, start: float) -> None:
        fmu = self._fmu = instance.fmu
        self._instance = instance
        reals = [name for name in fmu.variables if function_type(2, fmu.variables[name].type) == "Real"]
        self._first = [name for name in reals if name in known]
        self._others = {name: value for name, value in known.items() if name not in reals}
        self._reals = frozenset(reals)
        self._base = np.array([known[name] for name in self._first], dtype=float)
        tolerance = instance.tolerance
        limits = (tolerance is not None, tolerance or 0.0, start, True, stop)
        self._reset = _bound(instance, "fmi2Reset", action="reset")
        self._set_up = _bound(
            instance, "fmi2SetupExperiment", _FLAG, _REAL, _REAL, _FLAG, _REAL, action="set up", arguments=limits
        )
        self._set = _bound(instance, "fmi2SetReal", _POINTER, ctypes.c_size_t, _POINTER, action="set")
        self._enter = _bound(instance, "fmi2EnterInitializationMode", action="enter")
        self.leave = _bound(instance, "fmi2ExitInitializationMode", action="exit")
        self._sets = dict[tuple[str, ...], tuple[np.ndarray, tuple[int, int, int]]]()
        self._references = list[np.ndarray]()  # to which addresses lead

    def enter(self, changed: Mapping[str, Value]) -> None:
        """Raises RunError if the FMU refuses."""
        self._reset()
        self._set_up()
        names = tuple(name for name in changed if name in self._reals)
        values, addresses = self._sets.get(names) or self._made(names)
        values[: len(self._base)] = self._base
        values[len(self._base) :] = [changed[name] for name in names]  # last, so that they are what is
        if addresses[1]:
            self._set(*addresses)
        if self._others or len(names) < len(changed):
            whole = {name: value for name, value in changed.items() if name not in self._reals}
            self._instance.set_all({**self._others, **whole})
        self._enter()

    def _made(self, names: tuple[str, ...]) -> tuple[np.ndarray, tuple[int, int, int]]:
        """Room for the values of what is always set and of what is other now, and what sets them."""
        references = [self._fmu.places[name].reference for name in (*self._first, *names)]
        values = np.zeros(len(references))
        self._references.append(np.array(references, dtype=np.uint32))
        made = values, (self._references[-1].ctypes.data, len(references), values.ctypes.data)
        return self._sets.setdefault(names, made)


def _bound(
    instance: LoadedInstance, name: str, *types: Any, action: str, arguments: tuple[Any, ...] = ()
) -> Callable[..., None]:
    """A function of an FMU for its instance, with arguments that are always the same; it raises RunError.

    `action`: as `LoadedInstance` calls it, which knows in which mode the instance is.
    """
    function = ctypes.CFUNCTYPE(ctypes.c_int, _POINTER, *types)(instance.address(name))
    pointer, noted = instance.pointer, instance.noted

    def call(*more: Any) -> None:
        status = function(pointer, *arguments, *more)
        noted(action, status)
        if not good(status):
            raise RunError(f"component {instance.name}: {name} gives {status}")

    return call
