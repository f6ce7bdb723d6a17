"""Which signals are recorded: patterns of names, and a choice of them in place of the system file's."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase

from ..errors import InputError, nearest
from .model import System


def matches(patterns: Iterable[str], name: str) -> bool:
    """Whether one of the patterns is `name`: * and ? stand for any characters and any one; brackets for themselves."""
    return any(fnmatchcase(name, pattern.replace("[", "[[]")) for pattern in patterns)


def matching(pattern: str, names: Sequence[str]) -> bool:
    """Whether any of the names is, or matches, the pattern."""
    return pattern in names or any(matches((pattern,), name) for name in names)


def select_recorded(system: System, patterns: Sequence[str]) -> System:
    """A copy that records what matches `patterns`, and what its figures of merit need.

    Figures of which a signal is not recorded are left out; signals of the coupling are always recorded. Raises
    InputError for a pattern that matches no input or output.
    """
    names = [
        f"{name}.{variable}"
        for name, component in system.components.items()
        for variable in component.fmu.names("input", "output")
    ]
    for pattern in patterns:
        if not matching(pattern, names):
            raise InputError(f"--record {pattern}: no input or output is called so{nearest(pattern, names)}")
    record = (*patterns, *_needed(system))
    figures = [
        entry
        for entry in system.reporting.get("figures", ())
        if all(str(name).startswith("coupling.") or matches(record, str(name)) for name in entry.get("signals", ()))
    ]
    return replace(system, record=record, reporting={**system.reporting, "figures": figures})


def _needed(system: System) -> list[str]:
    """The signals that summary and balance name."""
    found = []
    for key, text in system.reporting.get("summary", {}).items():
        if key != "window":
            found += str(text).split()[1:]
        elif isinstance(text, dict) and "angle" in text:
            found.append(str(text["angle"]))
    for names in system.reporting.get("balance", {}).values():
        found += map(str, names) if isinstance(names, list) else []
    return list(dict.fromkeys(found))
