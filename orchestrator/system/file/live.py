"""The table `[live]` of a system file, its names checked against the components."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ...errors import InputError, nearest
from ...toml.file import TomlFile
from ..component import Component
from ..schema.checked import checked
from ..schema.keys.live import LiveControl, LivePart, LiveTable


def live_of(file: TomlFile, components: Mapping[str, Component]) -> LiveTable:
    """What the file says of the page. Raises InputError for names that nothing has."""
    table: dict[str, Any] = file.entry(dict, "live")
    stated = checked(LiveTable, table, "live", file, "live")
    controls = [
        checked(LiveControl, entry, "live.controls", file, "live.controls") for entry in table.get("controls", ())
    ]
    scene = [checked(LivePart, entry, "live.scene", file, "live.scene") for entry in table.get("scene", ())]
    parts = {part.name for part in scene if part.name}
    names = [("live.charts", name) for chart in stated.charts for name in chart]
    names += [("live.controls", control.input) for control in controls]
    names += [("live.scene", name) for part in scene for name in names_of(part)]
    for label, name in names:
        owner, _, variable = name.partition(".")
        if owner not in components or not components[owner].fmu.expand(variable):
            known = [
                f"{c.name}.{v}" for c in components.values() for v in c.fmu.base_names("output", "input", "parameter")
            ]
            raise file.fail(f"{label}: no variable is called '{name}'{nearest(name, known)}", name, label)
    for part in scene:
        for key in ("on", "under"):
            other = getattr(part, key)
            if other and other not in parts:
                raise file.fail(f"live.scene: no part is called '{other}'{nearest(other, parts)}", other, "live.scene")
        if part.shape == "patches" and not (part.to and part.under):
            raise InputError(f"live.scene: patches need 'to' and 'under' ({file.path.name})")
    return LiveTable(charts=stated.charts, controls=controls, scene=scene)


def names_of(part: LivePart) -> Iterator[str]:
    """The outputs and parameters that a part names."""
    for numbers in (part.at, part.to, part.attitude, part.size, part.along, [part.value, part.turn, part.when]):
        yield from (name for name in numbers if isinstance(name, str) and name)
