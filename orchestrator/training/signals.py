"""The signals that an agent sets and sees: checked, with their units and bounds."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from ..errors import InputError, nearest
from ..fmu.types import BINARY, TEXT
from ..plan.plan import Plan
from ..system.values import follows_tables

Bounds = tuple[float, float]
Named = Mapping[str, Bounds | None] | Iterable[str]


class Signal(NamedTuple):
    """A signal by its full name, its unit and the bounds of its values."""

    name: str
    unit: str
    low: float
    high: float


def actions_of(plan: Plan, named: Named) -> list[Signal]:
    """What an agent sets: inputs that nothing drives, with finite bounds. Raises InputError."""
    found = [_signal(plan, name, bounds, "action") for name, bounds in _pairs(named)]
    driven = {".".join(c.target): c.label for c in plan.system.connections}
    for signal in found:
        component, _, variable = signal.name.partition(".")
        owner = plan.system.components[component]
        if signal.name in driven:
            raise InputError(
                f"action {signal.name}: it is driven by the connection {driven[signal.name]}; remove that first"
            )
        if variable in owner.series:
            raise InputError(f"action {signal.name}: it follows {owner.series[variable]}; remove that first")
        if not follows_tables(owner.fmu.variables[variable]):
            raise InputError(
                f"action {signal.name}: it is of causality {owner.fmu.variables[variable].causality}; an action is an "
                f"input that nothing drives, or a tunable parameter"
            )
        kind = owner.fmu.type_of(variable)
        if kind is None or not kind.real:
            raise InputError(f"action {signal.name}: it is of type {owner.fmu.variables[variable].type}, not Real")
        if not (math.isfinite(signal.low) and math.isfinite(signal.high)):
            raise InputError(f"action {signal.name}: its bounds must be finite, not {signal.low} to {signal.high}")
    return _some(found, "actions")


def observations_of(plan: Plan, named: Named) -> list[Signal]:
    """What an agent sees: numbers that are exchanged or recorded. Raises InputError."""
    found = [_signal(plan, name, bounds, "observation") for name, bounds in _pairs(named)]
    return _some(found, "observations")


def _some(found: list[Signal], what: str) -> list[Signal]:
    if not found:
        raise InputError(f"{what}: there are none; name at least one")
    names = [signal.name for signal in found]
    if len(set(names)) < len(names):
        raise InputError(f"{what}: {next(n for n in names if names.count(n) > 1)} is there twice")
    return found


def _pairs(named: Named) -> list[tuple[str, Bounds | None]]:
    if isinstance(named, str):
        return [(named, None)]
    return list(named.items()) if isinstance(named, Mapping) else [(name, None) for name in named]


def _signal(plan: Plan, name: str, bounds: Bounds | None, what: str) -> Signal:
    full = plan.system.full_name(name)
    component, _, variable = full.partition(".")
    if component not in plan.system.components:
        raise InputError(f"{what} {name}: no component '{component}'{nearest(component, plan.system.components)}")
    fmu = plan.system.components[component].fmu
    if variable not in fmu.variables:
        array = f"; it is an array: name an element, such as {fmu.expand(variable)[0]}" if fmu.expand(variable) else ""
        raise InputError(
            f"{what} {name}: {component} has no variable '{variable}'{array or nearest(variable, fmu.variables)}"
        )
    kind, described = fmu.type_of(variable), fmu.variables[variable]
    if kind is None or kind.code in (TEXT, BINARY):
        raise InputError(f"{what} {name}: it is of type {described.type}, which is no number")
    if bounds is None:
        if described.min is None or described.max is None:
            raise InputError(
                f"{what} {name}: {fmu.path.name} declares no {'min' if described.min is None else 'max'} of it; give "
                f'its bounds: {{"{name}": (low, high)}}'
            )
        bounds = float(described.min), float(described.max)
    try:
        low, high = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        raise InputError(f"{what} {name}: its bounds are two numbers (low, high), not {bounds!r}") from None
    if not low < high:
        raise InputError(f"{what} {name}: its bounds need a low below high, not {low} to {high}")
    return Signal(full, described.unit or "1", low, high)
