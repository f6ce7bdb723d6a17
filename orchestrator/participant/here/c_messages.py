"""The messages of FMUs in C, FMI 1.0 and 2.0: formatted as printf does it, then given to the instance they are from.

What formats them (fmpy's proxy) keeps one logger for the whole process, the last one given to it: all instances give it
the same, which lives as long as the process and finds whose message it is.
"""

from __future__ import annotations

import ctypes
from typing import Any
from weakref import WeakValueDictionary

import fmpy
from fmpy import fmi2

from ..lifecycle import State
from .loaded import LoadedInstance

# By what the FMU is told of its environment (FMI 2.0), or by its own address, which it gives instead (FMI 1.0).
_known: WeakValueDictionary[int, LoadedInstance] = WeakValueDictionary()


def _log_of_any(environment: Any, name: bytes, status: int, category: bytes, message: bytes) -> None:
    instance = _known.get(environment)
    if instance is None or instance.state is State.FREED:  # the address of one that is gone can be given again
        # One that keeps its environment to itself, or an FMU of FMI 1.0 that is being made.
        instance = next((i for i in reversed(list(_known.values())) if i.name.encode() == name), None)
    if instance is not None:
        words = ((part or b"").decode("utf-8", "replace").strip() for part in (category, message))
        instance.log.add(status, *words)


_logger = fmi2.fmi2CallbackLoggerTYPE(_log_of_any)  # FMI 1.0 has the same signature


def format_messages(instance: LoadedInstance, environment: int, callbacks: Any) -> None:
    """Fill in the `logger` of an instance's callbacks: messages that come with `environment` are its own."""
    known_as(instance, environment)
    callbacks.logger = ctypes.cast(_logger, type(callbacks.logger))
    fmpy.logging.addLoggerProxy(ctypes.byref(callbacks))


def known_as(instance: LoadedInstance, environment: int) -> None:
    """Messages that come with `environment` are this instance's from now on."""
    _known.pop(environment, None)  # the last one of a name comes last
    _known[environment] = instance
