"""A mapping file to begin with: for each variable of a component the variable of an FMU that is called most like it."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from difflib import SequenceMatcher

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.fmu import Fmu
from ...fmu.types import REALS
from ...system.replace.fit import can_be
from ...system.values import start_as_toml
from ...units import conversion
from .binding import elements_of
from .opened import whole_variables
from .suites import Declared, Suite

ALIKE = 0.55  # how much alike names must be, 1 being the same
OFFERED = 8  # names of theirs that a remark lists
SAME_UNIT = 0.15  # what a unit that fits counts beside the name


@dataclass(frozen=True)
class Theirs:
    """A variable of theirs, or all elements of an array, by the name that a mapping file has for it."""

    name: str
    variable: ModelVariable
    count: int  # numbers in it; 0 for a scalar


def skeleton(fmu: Fmu, suite: Suite) -> str:
    """A mapping file as text, which `load_mapping` accepts for this FMU."""
    theirs = _theirs(fmu)
    found = _pairs(suite.interface, theirs)
    lines = [
        f"# {suite.name} = {fmu.path.name}: the nearest names. Check each one; what is missing there is \"\".",
        "# The opposite direction, or a unit that their FMU leaves out: { name = \"tau\", sign = -1, unit = \"N.m\" }",
        "[variables]",
    ]  # fmt: skip
    width = max(len(_line(v, found)) for v in suite.interface)
    lines += [f"{_line(v, found):<{width}}  # {_remark(v, found, suite, theirs)}" for v in suite.interface]
    used = {match.name for match in found.values()}
    free = [t for t in theirs if t.variable.causality == "input" and t.name not in used]
    if free:
        lines += ["", "[inputs]  # of theirs that none of ours stands for: held over the run, in their units"]
        lines += [f"{_key(t.name)} = {_start(fmu, t)}" for t in free if _start(fmu, t)]
    return "\n".join(lines) + "\n"


def _theirs(fmu: Fmu) -> list[Theirs]:
    """Whole variables; elements `cmd[1]`, `cmd[2]` of FMI 2.0 together as `cmd`."""
    found: dict[str, list[ModelVariable]] = {}
    for v in whole_variables(fmu).values():
        base = re.sub(r"\[\d+\]$", "", v.name)
        found.setdefault(base if base != v.name else v.name, []).append(v)
    joined = []
    for name, members in found.items():
        single = members[0].name == name
        count = (elements_of(members[0]) if members[0].shape else 0) if single else len(members)
        joined.append(Theirs(name, members[0], count))
    return joined


def _pairs(ours: Iterable[Declared], theirs: list[Theirs]) -> dict[str, Theirs]:
    """The best match of each, best first; nothing of theirs stands for two of ours."""
    scored = sorted(
        ((score, k, v.name, t) for k, v in enumerate(ours) for t in theirs if (score := _score(v, t)) >= ALIKE),
        key=lambda entry: (-entry[0], entry[1]),
    )
    found: dict[str, Theirs] = {}
    taken: set[str] = set()
    for _, _, name, t in scored:
        if name not in found and t.name not in taken:
            found[name] = t
            taken.add(t.name)
    return found


def _score(ours: Declared, theirs: Theirs) -> float:
    """How well a variable of theirs could stand for one of ours; 0 if it cannot."""
    v = theirs.variable
    if not can_be(ours.causality, v) or theirs.count != ours.size:
        return 0.0
    if v.type in ("String", "Binary", "Clock") or (ours.kind == "Real" and v.type not in REALS):
        return 0.0
    unit = v.unit
    try:
        conversion(ours.unit, unit, "")
    except InputError:
        return 0.0
    last = re.split(r"[.:/]", theirs.name)[-1]
    alike = max(_alike(ours.name, theirs.name), 0.95 * _alike(ours.name, last))
    words = str(getattr(ours, "description", "") or "")
    if words and v.description:
        alike = max(alike, 0.9 * _alike(words, v.description))
    return alike + (SAME_UNIT if unit and unit not in ("1", "") else 0.0) if alike > 1 - SAME_UNIT - ALIKE else 0.0


def _alike(a: str, b: str) -> float:
    return SequenceMatcher(None, a.lower(), b.lower()).ratio()


def _line(ours: Declared, found: dict[str, Theirs]) -> str:
    return f"{_key(ours.name)} = {json.dumps(found[ours.name].name if ours.name in found else '', ensure_ascii=False)}"


def _remark(ours: Declared, found: dict[str, Theirs], suite: Suite, theirs: list[Theirs]) -> str:
    said = f"{ours.causality} [{ours.unit}]" + (f", {ours.size} elements" if ours.size else "")
    if ours.name not in found:
        if ours.name not in suite.essential:
            return f"{said}: nothing there is like it"
        used = {match.name for match in found.values()}
        free = [t.name for t in theirs if t.variable.causality == ours.causality and t.name not in used]
        there = ", ".join(free[:OFFERED]) or f"no {ours.causality}"
        return f"{said}: nothing there is like it, and a system needs it; there: {there}"
    v = found[ours.name].variable
    unit = v.unit
    words = f"theirs: {v.causality}, {f'[{unit}]' if unit else 'no unit stated'}"
    return f"{said}; {words}{f', {chr(39)}{v.description}{chr(39)}' if v.description else ''}".replace("\n", " ")


def _start(fmu: Fmu, theirs: Theirs) -> str:
    scalars = [v for v in fmu.expand(theirs.name) if fmu.type_of(v) is not None]
    values = [start_as_toml(fmu.variables[v]) for v in scalars]
    if not values or any(not _is_value(value) for value in values):
        return ""
    return values[0] if theirs.count == 0 else f"[{', '.join(values)}]"


def _is_value(text: str) -> bool:
    """Whether a start value is one in a TOML file too."""
    if text.startswith('"') or text in ("true", "false"):
        return True
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def _key(name: str) -> str:
    return name if re.fullmatch(r"[\w-]+", name, re.ASCII) else json.dumps(name, ensure_ascii=False)
