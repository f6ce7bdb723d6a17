"""What one call of an FMI function exchanges: values of one type, in cells one behind the other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import groupby

from ...fmu.types import FmiType
from ..design import Design
from ..exchange import at_events

Key = tuple[str, str]


def kind_of(plan: Design, key: Key) -> FmiType:
    """The type of a signal that has a cell."""
    kind = plan.system.components[key[0]].fmu.type_of(key[1])
    assert kind is not None
    return kind


def internal(plan: Design) -> set[Key]:
    """Inputs that FMUs for Model Exchange give each other: the loop sets none but those in arrays whose other elements
    come from outside."""
    inside = {c.target for c in plan.inside}
    arrays = {name: component.fmu.arrays for name, component in plan.system.components.items()}
    sampled = {c.target for c in plan.inside if at_events(plan.system, c)}
    whole = {key for key in inside if inside.issuperset((key[0], e) for e in arrays[key[0]][key[1]])}
    return sampled | whole


def together(plan: Design, name: str, table: Mapping[str, int]) -> Iterator[tuple[FmiType, list[tuple[int, Key]]]]:
    """The calls that exchange some variables of a component, each with its type and its cells."""
    places = plan.system.components[name].fmu.places
    numbered = [(slot - k, slot, (name, variable)) for k, (variable, slot) in enumerate(table.items())]
    alike = groupby(numbered, key=lambda e: (kind_of(plan, e[2]), e[0], places[e[2][1]].negated))
    for (kind, *_), found in alike:
        yield kind, [(slot, key) for _, slot, key in found]


def in_place(plan: Design, kind: FmiType, key: Key) -> bool:
    """Whether an FMU takes a value out of its cell, or puts it there: doubles but for those of negated aliases."""
    return kind.real and kind.size == 8 and not plan.system.components[key[0]].fmu.places[key[1]].negated


def given(plan: Design, name: str, inside: set[Key]) -> dict[str, int]:
    """The inputs of a component that the loop sets, with their cells; `inside`: those of `internal`."""
    return {
        variable: slot for variable, slot in plan.layout.exchanged(name)[0].items() if (name, variable) not in inside
    }


def take_turns(plan: Design) -> frozenset[str]:
    """Components that need one call for all inputs and one for all outputs, straight from the run's cells."""
    inside = internal(plan)
    found = set()
    for name in plan.system.components:
        sides = given(plan, name, inside), plan.layout.exchanged(name)[1]
        calls = [list(together(plan, name, side)) for side in sides]
        if all(len(side) <= 1 and all(in_place(plan, kind, cells[0][1]) for kind, cells in side) for side in calls):
            found.add(name)
    return frozenset(found)
