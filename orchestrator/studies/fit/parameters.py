"""Which parameters a fit may vary, and the scales that are stated; checked before the first run."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ...errors import InputError
from ...system.model import System
from ..sweep.design.axis import range_of
from ..sweep.design.design import vary_entries
from ..sweep.design.replanned import needs_plan
from .data import Match
from .experiment import Experiment, Recipe
from .solver import Free


def unit_of(system: System, name: str) -> str:
    """The unit of a parameter; "1" for none."""
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu
    return fmu.variables[fmu.expand(variable)[0]].unit or "1"


def free_parameters(system: System, vary: Sequence[str], tell: Callable[[str], None]) -> list[Free]:
    """What is fitted, from the values that the system has. Raises InputError."""
    entries = vary_entries(vary)
    if not entries:
        raise InputError("--vary says what is fitted and in which range, for instance --vary drive.R=0.05:0.2")
    found = []
    for given, text in entries.items():
        name = system.full_name(given)
        form = f"{given}=low:high or {given}=low:high:log"
        if ":" not in str(text) or isinstance(text, list):
            raise InputError(f"--vary {given}={text}: write {form}")
        ends = range_of(system, name, text, form, grid=False)
        if needs_plan(system, name):
            raise InputError(f"--vary {name}: it decides what the run is made of, and is swept rather than fitted")
        system.with_values({name: ends.low}, "--vary")  # unknown names, driven inputs
        system.with_values({name: ends.high}, "--vary")
        component, _, variable = name.partition(".")
        owner = system.components[component]
        scalars = owner.fmu.expand(variable)
        if len(scalars) > 1 or not owner.fmu.is_real(scalars[0]):
            raise InputError(f"--vary {name}: one real number is fitted; name an element, such as {name}[1]")
        start = float({**owner.parameters, **owner.inputs}.get(scalars[0], owner.fmu.start(scalars[0])))
        low, high = float(ends.low), float(ends.high)
        if not low <= start <= high:
            middle = float(np.sqrt(low * high)) if ends.log else 0.5 * (low + high)
            tell(f"{name} is {start:g} in the system, outside of {low:g} to {high:g}; the fit begins at {middle:g}")
            start = middle
        found.append(Free(name, low, high, start, ends.log))
    return found


def require_apart(experiments: Sequence[Experiment], free: Sequence[Free], recipes: Sequence[Recipe]) -> None:
    """Raise InputError for a parameter that one of the experiments sets itself."""
    for experiment, recipe in zip(experiments, recipes, strict=True):
        own = {experiment.plan.system.full_name(name) for name in recipe.values}
        for entry in free:
            if entry.name in own:
                raise InputError(f"--vary {entry.name}: the experiment with {recipe.data.name} sets it; leave one out")


def sigma_of(system: System, given: Mapping[str, float], matches: Sequence[Match]) -> dict[str, float]:
    """Stated scales by full name. Raises InputError."""
    names = {system.full_name(match.name) for match in matches}
    found = {system.full_name(name): value for name, value in given.items()}
    for name, value in found.items():
        if name not in names:
            raise InputError(f"--sigma {name}: it is not among the signals of --match, {', '.join(sorted(names))}")
        if not (np.isfinite(value) and value > 0.0):
            raise InputError(f"--sigma {name}={value}: the standard deviation of a signal is above 0")
    return found
