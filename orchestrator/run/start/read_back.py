"""What was set counts: parameters are read back once the FMUs are initialized.

Some exporters put parameters back to their defaults, clip them or never take them; a run would go on with other values
than were asked for.
"""

from __future__ import annotations

from ...errors import FmuError
from ...fmu.binary import as_text
from ...fmu.reading.structure import STRUCTURAL
from ...fmu.types import FmiType, Value
from ...participant.base import CallError, Participant
from ...system.component import Component

ROUNDING = 8  # units in the last place, of conversions on the way there and back


def read_back(instance: Participant, component: Component) -> list[str]:
    """Raise FmuError for a parameter that is not what was set; notes on those that cannot be read."""
    notes, fmu = [], component.fmu
    for name, value in {**fmu.structure, **component.parameters}.items():
        if fmu.variables[name].causality not in ("parameter", STRUCTURAL):
            continue
        before = instance.state
        try:
            found = instance.get(name)
        except CallError as error:
            if instance.dead:
                raise
            instance.state = before  # the FMU does not answer this one call; nothing is known to be wrong
            notes.append(f"component {component.name}: parameter {name} cannot be read back: {error}")
            continue
        kind = fmu.type_of(name)
        assert kind is not None
        if not same(kind, value, found):
            kept = as_text(found)
            raise FmuError(
                f"component {component.name}: parameter {name} was set to {as_text(value)} and is {kept} after "
                f"initialization: {fmu.path.name} does not keep it; remove it from the values that are set, or set it "
                f"to {kept}{instance.log_text()}"
            )
    return notes


def same(kind: FmiType, value: Value, found: Value) -> bool:
    """Whether two values are one but for the rounding of their type."""
    if not kind.real:
        return value == found
    a, b = float(value), float(found)
    if a == b:
        return True
    precision = 2.0**-23 if kind.size == 4 else 2.0**-52
    return abs(a - b) <= ROUNDING * precision * max(abs(a), abs(b))
