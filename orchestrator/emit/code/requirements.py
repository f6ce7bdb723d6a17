"""What a system requires of the start as C: an error, or a warning, in its own words."""

from __future__ import annotations

from math import inf

from ...plan.plan import Plan
from ...system.model import Requirement
from ...units import conversion
from .exposed import Exposed
from .names import number, text


def requirements(plan: Plan, shown: list[Exposed], system: str) -> str:
    """The function that looks at them, behind the initialization."""
    places = {e.name: k for k, e in enumerate(shown)}
    lines = [f"/* What is required of the start. */\nint {system}_requirements({system} *s) {{"]
    lines += ["    double value, low, high;", "    (void)s, (void)value, (void)low, (void)high;"]
    for requirement in plan.system.requirements:
        names = {".".join(key) for key in requirement.names}
        if not names <= places.keys():
            continue  # it looks at what the system does not show, a local variable
        value = places[".".join(requirement.value)]
        lines.append(f"    if ({system}_number(s, {value}, &value)) return 1;")
        for which, bound, none in (("low", requirement.minimum, -inf), ("high", requirement.maximum, inf)):
            lines += _limit(plan, requirement, which, bound, none, places, system)
        said = f"{requirement.message}: {'.'.join(requirement.value)}".replace("%", "%%")
        words = text(f"{said} = %.9g at the start, allowed are %.9g to %.9g")
        status = 1 if requirement.otherwise == "warning" else 3
        lines.append("    if (!(low <= value && value <= high) &&")
        lines.append(f"        {system}_required(s, {status}, {words}, value, low, high)) return 1;")
    return "\n".join([*lines, "    return 0;", "}"])


def _limit(
    plan: Plan, requirement: Requirement, which: str, bound: float | tuple[str, str], none: float,
    places: dict[str, int], system: str,
) -> list[str]:  # fmt: skip
    """Lines that give a bound its value, in the unit of what it bounds."""
    if not isinstance(bound, tuple):
        return [f"    {which} = {number(none if bound is None else float(bound))};"]
    components = plan.system.components
    own, wanted = (components[name].fmu.unit(variable) for name, variable in (bound, requirement.value))
    gain, offset = conversion(own, wanted, "require")
    return [
        f"    if ({system}_number(s, {places['.'.join(bound)]}, &{which})) return 1;",
        f"    {which} = {number(gain)} * {which} + {number(offset)};",
    ]
