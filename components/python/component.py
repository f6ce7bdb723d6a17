"""The class that declares a component, found by the component's name or folder, or in its module `fmu`."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

from ..declare.interface import parameter_variables
from ..errors import BuildError
from .slave import ComponentSlave

TOP = Path(__file__).parents[1]


def component_class(name: str) -> type[ComponentSlave]:
    """The class that declares a component: one of the package by its name, another by its folder.

    Raises BuildError where its module cannot be meant.
    """
    shipped = name.isidentifier() and (TOP / name / "fmu.py").is_file()
    folder = TOP / name if shipped else Path(name).resolve()
    if folder.parent == TOP:
        module = importlib.import_module(f"{__package__.rpartition('.')[0]}.{folder.name}.fmu")
    else:
        module = _module_in(folder)
    found: type[ComponentSlave] = class_in(module)
    return found


def _module_in(folder: Path) -> ModuleType:
    """The module `fmu` of a component in a folder of its own, or in the package around that folder."""
    top, names = folder.parent, [folder.name]
    while (top / "__init__.py").is_file():
        top, names = top.parent, [top.name, *names]
    if str(top) not in sys.path:
        sys.path.insert(0, str(top))
    module = importlib.import_module(".".join([*names, "fmu"]))
    if Path(str(module.__file__)).resolve().parent != folder:
        raise BuildError(f"{folder}: Python has another module {names[0]}: {module.__file__}; rename the folder")
    return module


def class_in(fmu: ModuleType) -> type[Any]:
    """The one class that a component's module `fmu` defines. Raises BuildError where it is not one."""
    found = [x for x in vars(fmu).values() if isinstance(x, type) and x.__module__ == fmu.__name__]
    if len(found) != 1:
        raise BuildError(f"{fmu.__file__}: there is one class, the component, and here are {len(found)}")
    _require_names(found[0], str(fmu.__file__))
    return found[0]


def _require_names(declared: type[Any], file: str) -> None:
    """Raise BuildError for a variable that a kernel, or a host, could not tell from something else."""
    taken = {"t": "the time", "h": "the step size", "y": "the outputs"}
    taken |= {array.name: "an array of state or scratch" for array in declared.arrays}
    arguments = (*parameter_variables(declared.parameters), *declared.inputs)
    for variable in (*arguments, *declared.outputs):
        if variable in declared.outputs:  # no argument of its own
            taken = {a.name: f"the {a.causality} before it" for a in arguments}
        if variable.name in taken:
            raise BuildError(
                f"{file}: the {variable.causality} '{variable.name}' has the name of {taken[variable.name]}; rename it"
            )
        taken[variable.name] = f"the {variable.causality} before it"
