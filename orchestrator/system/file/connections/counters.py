"""`a.output -> b.input (mean of a.counter)`: the counter that gives the mean of an output exactly.

It is an output of the same component which rises by the time integral of the other, as an impulse does by that of a
force: the mean over a step is then what it rose by, over the length of the step.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ....errors import InputError, nearest
from ....units import integral_gain
from ...component import Component
from .link import Link


def counters_of(
    components: Mapping[str, Component], link: Link, outputs: Sequence[str], where: str
) -> list[tuple[str, float]]:
    """For each scalar output of a link its counter, and what the output is where that rises by 1 in a second; empty
    names where none is stated. Raises InputError for what does not count it."""
    if not link.counter:
        return [("", 1.0)] * len(outputs)
    label, (owner, _, variable) = f"connection {link}: mean of {link.counter}", link.counter.partition(".")
    if link.transfer != "mean":
        raise InputError(
            f"connection {link}: '{link.transfer}' takes no counter, and {link.counter} is stated; "
            f"write (mean of {link.counter}) {where}"
        )
    if owner != link.source:
        there = "is of another component" if owner in components else "has no component"
        raise InputError(
            f"{label}: the counter {there}; name an output of {link.source} that counts the time integral of "
            f"{link.source}.{link.output} {where}"
        )
    fmu = components[owner].fmu
    found = [name for name in fmu.expand(variable) if fmu.variables[name].causality == "output"]
    if not found:
        other = fmu.expand(variable)
        why = f"; its '{variable}' is declared with causality {fmu.variables[other[0]].causality}" if other else ""
        why = why or nearest(variable, fmu.base_names("output"))
        raise InputError(f"{label}: {fmu.description.modelName} has no output '{variable}'{why} {where}")
    if len(found) != len(outputs):
        raise InputError(f"{label}: {len(found)} elements cannot count {len(outputs)} {where}")
    pairs = list(zip(found, outputs, strict=True))
    for names in pairs:
        for name in names:
            if not fmu.is_real(name):
                raise InputError(
                    f"{label}: {owner}.{name} is of type {fmu.variables[name].type}; an integral and what it counts "
                    f"are floating-point signals {where}"
                )
    try:
        return [(count, integral_gain(fmu.unit(count), fmu.unit(output), label)) for count, output in pairs]
    except InputError as error:
        raise InputError(f"{error} {where}") from None
