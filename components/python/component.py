"""The class that declares a component, found by the component's name or in its module `fmu`."""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

from .slave import ComponentSlave


def component_class(name: str) -> type[ComponentSlave]:
    """The class that declares the component of this name."""
    package = __package__.rpartition(".")[0]
    found: type[ComponentSlave] = class_in(importlib.import_module(f"{package}.{name}.fmu"))
    return found


def class_in(fmu: ModuleType) -> type[Any]:
    """The one class that a component's module `fmu` defines."""
    return next(x for x in vars(fmu).values() if isinstance(x, type) and x.__module__ == fmu.__name__)
