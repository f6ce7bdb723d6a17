"""Which signals are recorded: patterns of names, and a choice of them in place of the system file's.

`*` and `?` stand for inputs and outputs. A local variable, a parameter or another name of an input is recorded by its
own name, or by a pattern that no input or output matches; of an FMU without outputs `*` means all of its locals.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import Any

from ...errors import InputError, nearest
from ..component import Component
from ..model import System
from .merits import merit

OTHERS = ("local", "parameter", "calculatedParameter", "independent")  # what can be recorded beside inputs and outputs


def matches(patterns: Iterable[str], name: str) -> bool:
    """Whether one of the patterns is `name`: * and ? stand for any characters and any one; brackets for themselves."""
    return any(fnmatchcase(name, pattern.replace("[", "[[]")) for pattern in patterns)


class Recorded:
    """What a system records, by `component.variable`; quick also for thousands of names."""

    def __init__(self, patterns: Iterable[str]) -> None:
        self.names = set(patterns)
        self._patterns = [name for name in self.names if _is_pattern(name)]

    def has(self, name: str) -> bool:
        """Whether an input or output is recorded."""
        return name in self.names or "*" in self.names or matches(self._patterns, name)

    def others(self, component: Component) -> list[str]:
        """The locals, parameters and aliases of a component that are recorded, in the order of the description."""
        wanted = {name for owner, _, name in (n.partition(".") for n in self.names) if owner == component.name}
        return [name for name in _others(component) if name in wanted]


def _others(component: Component) -> list[str]:
    """What is recorded by its own name only."""
    fmu = component.fmu
    inputs = set(fmu.names("input"))
    return [name for name in fmu.names("input", *OTHERS, aliases=True) if name not in inputs]


def recorded_names(
    components: Mapping[str, Component], patterns: Sequence[str], fail: Callable[[str, str], InputError]
) -> tuple[str, ...]:
    """The patterns, with every local and parameter that they mean by its name.

    Raises what `fail` makes of a pattern and the words why: nothing is called so, or it cannot be recorded.
    """
    usual = _names(components, "input", "output")
    further = [f"{name}.{variable}" for name, c in components.items() for variable in _others(c)]
    found: list[str] = []
    for pattern in patterns:
        if pattern == "*":
            found.append(pattern)
            silent = {name: c for name, c in components.items() if not c.fmu.names("output")}
            found += [name for name in _names(silent, "local") if _recordable(silent, name)]
            continue
        hits = matching(pattern, usual)
        found += [pattern] if _is_pattern(pattern) else hits
        if not hits:
            hits = matching(pattern, further)
            found += [name for name in hits if _recordable(components, name)]
        if not hits:
            raise fail(pattern, f"no variable is called so{nearest(pattern, [*usual, *further])}")
        if not any(_recordable(components, name) for name in hits):
            owner, _, variable = hits[0].partition(".")
            kind = components[owner].fmu.variables[variable].type
            raise fail(pattern, f"{hits[0]} is of type {kind}, which cannot be recorded")
    return tuple(dict.fromkeys(found))


def _names(components: Mapping[str, Component], *causalities: str) -> list[str]:
    return [f"{name}.{variable}" for name, c in components.items() for variable in c.fmu.names(*causalities)]


def matching(pattern: str, names: Sequence[str]) -> list[str]:
    """The name that the pattern is, or all that match it; an array by its own name is all of its elements."""
    if pattern in names:
        return [pattern]
    if _is_pattern(pattern):
        return [name for name in names if matches((pattern,), name)]
    return [name for name in names if name.startswith(f"{pattern}[") and name.endswith("]")]


def _is_pattern(text: str) -> bool:
    return "*" in text or "?" in text


def _recordable(components: Mapping[str, Component], name: str) -> bool:
    owner, _, variable = name.partition(".")
    return components[owner].fmu.type_of(variable) is not None


def select_recorded(system: System, patterns: Sequence[str]) -> System:
    """A copy that records what matches `patterns`, and what its figures of merit need.

    Figures of which a signal is not recorded are left out; signals of the coupling are always recorded. Raises
    InputError for a pattern that no variable matches.
    """
    alone = next(iter(system.components)) if len(system.components) == 1 else ""
    full = [
        f"{alone}.{pattern}" if alone and pattern != "*" and not pattern.startswith(f"{alone}.") else pattern
        for pattern in map(system.full_name, patterns)
    ]
    record = recorded_names(system.components, full, lambda name, why: InputError(f"--record {name}: {why}"))
    kept = Recorded((*record, *reported_names(system)))
    figures = [
        entry
        for entry in system.reporting.get("figures", ())
        if all(str(name).startswith("coupling.") or kept.has(str(name)) for name in _drawn(system, entry))
    ]
    record = (*record, *reported_names(system))
    return replace(system, record=record, reporting={**system.reporting, "figures": figures})


def _drawn(system: System, entry: Mapping[str, Any]) -> list[str]:
    """The signals that a figure needs; of one along an array the elements of its arrays."""
    names = [str(name) for name in entry.get("signals", ())]
    if "along" not in entry:
        return names
    found = []
    for name in names:
        owner, _, variable = name.partition(".")
        inside = system.components[owner].fmu.expand(variable) if owner in system.components else []
        found += [f"{owner}.{one}" for one in inside] or [name]
    return found


def reported_names(system: System) -> list[str]:
    """The signals that summary and balance name."""
    found = []
    for key, text in system.reporting.get("summary", {}).items():
        if key != "window":
            found += merit(text)[1]
        elif isinstance(text, dict) and "angle" in text:
            found.append(str(text["angle"]))
    for names in system.reporting.get("balance", {}).values():
        found += map(str, names) if isinstance(names, list) else []
    return list(dict.fromkeys(found))
