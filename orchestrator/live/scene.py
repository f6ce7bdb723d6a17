"""The scene of a system for the page's script: every number of a part is one, or the place of a posted signal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from msgspec import to_builtins

from ..errors import InputError
from ..system.file.live import names_of
from ..system.model import System

LISTS, SINGLE = ("at", "to", "attitude", "size", "along"), ("value", "turn", "when")


def scene_signals(system: System) -> list[str]:
    """The scalars that the parts of the scene name."""
    found = []
    for part in system.live.scene if system.live else ():
        for name in names_of(part):
            owner, _, variable = name.partition(".")
            found += [f"{owner}.{scalar}" for scalar in system.components[owner].fmu.expand(variable)]
    return found


def scene_of(system: System, posted: Sequence[str]) -> dict[str, Any] | None:
    """The parts; a signal is `{"signal": its number}`. None where there are none."""
    places = {name: number for number, name in enumerate(posted)}

    def numbers(entry: Any) -> list[Any]:
        if not isinstance(entry, str):
            return [entry]
        owner, _, variable = entry.partition(".")
        component = system.components[owner]
        given = {**component.parameters, **component.inputs}
        found: list[Any] = []
        for scalar in component.fmu.expand(variable):
            name = f"{owner}.{scalar}"
            if name in places:
                found.append({"signal": places[name]})
            elif component.fmu.variables[scalar].causality in ("parameter", "input"):
                found.append(float(given.get(scalar, component.fmu.start(scalar))))
            else:
                raise InputError(f"live.scene: {name} is not recorded, so nothing can follow it; add it to 'record'")
        return found

    parts = []
    for part in system.live.scene if system.live else ():
        plain = to_builtins(part)
        plain |= {key: [n for entry in plain[key] for n in numbers(entry)] for key in LISTS}
        plain |= {key: numbers(plain[key])[0] if plain[key] != "" else None for key in SINGLE}
        parts.append(plain)
    return {"parts": parts} if parts else None
