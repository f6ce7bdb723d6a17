"""Units that an FMU leaves out, stated in the system file or in a file beside it.

[components.pump]
fmu = "pump.fmu"
units = { torque = "N.m", speed = "rad/s" }      # or: units = "pump_units.toml", a file with such lines
"""

from __future__ import annotations

from typing import Any

from ..errors import InputError, nearest
from ..fmu.crossing import REALS
from ..fmu.fmu import Fmu
from ..toml_file import TomlFile
from ..units import parse_unit


def stated_units(file: TomlFile, component: str, entry: object, fmu: Fmu, heading: str) -> dict[str, str]:
    """The unit of every scalar that the entry `units` speaks of. Raises InputError for a name that the FMU does not
    have or that is no real number, a unit that is not understood, and one that contradicts the FMU."""
    if isinstance(entry, str):
        file, heading = TomlFile(file.path.parent / entry), ""
        entry = file.data
    if not isinstance(entry, dict):
        raise file.fail(f"component {component}: units must be a table, or the name of a file", "units", heading)
    found: dict[str, str] = {}
    for name, unit in entry.items():
        scalars = fmu.expand(name)
        label = f"component {component}: unit of {name}"
        if not scalars:
            raise file.fail(
                f"{label}: {fmu.path.name} has no such variable{nearest(name, fmu.variables)}", name, heading
            )
        found |= {scalar: _checked(file, label, name, unit, fmu, scalar, heading) for scalar in scalars}
    return found


def _checked(file: TomlFile, label: str, name: str, unit: Any, fmu: Fmu, scalar: str, heading: str) -> str:
    variable = fmu.variables[scalar]
    if variable.type not in REALS:
        raise file.fail(f"{label}: it is of type {variable.type}, which has no unit", name, heading)
    if variable.unit and variable.unit != unit:
        raise file.fail(f"{label}: {fmu.path.name} states {variable.unit} itself; remove {unit!r}", name, heading)
    try:
        parse_unit(str(unit))
    except InputError as error:
        raise file.fail(f"{label}: {error}", name, heading) from None
    return str(unit)
