"""A value with its unit, as people write it: `5 mm`, `95.5 rpm`; in the unit of the variable that takes it."""

from __future__ import annotations

import re

from ..errors import InputError
from ..fmu.attributes import is_number
from ..fmu.fmu import Fmu
from ..units import conversion

QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d].*|[%°].*|1/.*)")


def in_own_unit(fmu: Fmu, scalar: str, value: object, label: str, difference: bool = False) -> object:
    """A text of number and unit as a number in the unit of a variable; whatever else it is stays as it is.

    `difference`: of two values, which is converted by the factor alone.

    Raises InputError for a unit that cannot become the variable's, or where that has none.
    """
    if not isinstance(value, str) or not fmu.is_real(scalar):
        return value
    match = None if is_number(value) else QUANTITY.fullmatch(value)
    if match is None:
        return value
    number, unit = float(match[1]), match[2].strip()
    own = fmu.unit(scalar)
    if own is None:
        raise InputError(
            f"{label} = {value}: {fmu.path.name} states no unit for it; give the number alone, or state its unit with "
            f'units = {{ "{scalar}" = "{unit}" }} under [components.NAME]'
        )
    gain, offset = conversion(fmu.unit_called(unit, scalar), own, f"{label} = {value}")
    return gain * number + (0.0 if difference else offset)
