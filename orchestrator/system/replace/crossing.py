"""How one of our variables appears in somebody else's FMU: another name, unit and direction.

theirs = gain * ours + offset         ours = back_gain * theirs + back_offset
"""

from __future__ import annotations

from dataclasses import dataclass

from ...errors import InputError
from ...units import Unit, conversion


@dataclass(frozen=True)
class Crossing:
    """One variable at the boundary between this system and a foreign FMU."""

    name: str  # theirs
    unit: str | None = None  # theirs
    gain: float = 1.0
    offset: float = 0.0
    back_gain: float = 1.0
    back_offset: float = 0.0

    @property
    def exact(self) -> bool:
        """Does a value cross as it is?"""
        return (self.gain, self.offset, self.back_gain, self.back_offset) == (1.0, 0.0, 1.0, 0.0)

    def there(self, value: float) -> float:
        """Our value as theirs."""
        return self.gain * value + self.offset

    def back(self, value: float) -> float:
        """Their value as ours."""
        return self.back_gain * value + self.back_offset

    def __str__(self) -> str:
        shift = f" plus {self.offset:g}" if self.offset else ""
        unit = f" [{self.unit}]" if self.unit and self.unit != "1" else ""
        return f"{self.name}{unit}" + ("" if self.exact else f", times {self.gain:.9g}{shift}")


def crossing(name: str, ours: Unit | str | None, theirs: Unit | str | None, sign: float, label: str) -> Crossing:
    """The crossing to their variable `name`, between two units. Raises InputError where the units do not fit."""
    try:
        gain, offset = conversion(ours, theirs, label)
        back_gain, back_offset = conversion(theirs, ours, label)
    except InputError as error:
        raise InputError(
            f"{error}; if their FMU is wrong about it, correct it there: a mapping file adds units and signs, "
            "it overrules none"
        ) from None
    return Crossing(
        name, None if theirs is None else str(theirs), sign * gain, offset, sign * back_gain, sign * back_offset
    )
