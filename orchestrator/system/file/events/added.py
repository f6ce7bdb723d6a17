"""Events beside those of the system file: from files of events, scenarios, from single lines, from Python."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....clock import seconds_text
from ....errors import InputError, nearest
from ....files import plain
from ....toml.file import TomlFile
from ...event import Event
from ...model import System
from ...schema.checked import checked
from ...schema.keys.event import ScenarioTable
from .one_line import event_of_line
from .read import events_of

START: dict[str, Any] = {"String": "", "Binary": "", "Boolean": False}  # values that all variables of a type can have
KEYS = tuple(ScenarioTable.__struct_encode_fields__)
Given = str | Mapping[str, Any]  # an event in one line, or the table of a file


def with_scenarios(system: System, files: Iterable[Path], lines: Sequence[Given] = ()) -> System:
    """The system with more events: those of scenario files, in their order, then those of single lines.

    Raises InputError for a file that is none, and for what the system file could not say either; also for an event
    behind the stop, which is meant to happen.
    """
    for path in files:
        system = _with_file(system, path)
    return with_added(system, lines, "--event") if lines else system


def with_added(system: System, given: Sequence[Given], option: str) -> System:
    """The system with events that are no file's. Raises InputError that begins with `option`."""
    before = sum(event.name.startswith(f"{option} ") for event in system.events)
    for number, each in enumerate(given, before + 1):
        try:
            entry = event_of_line(each) if isinstance(each, str) else dict(each)
            entry = {**entry, "name": entry.get("name") or f"{option} {number}"}
            found = events_of(None, system.components, system.connections, [entry], before=system.events)
            _require_in_time(system, found)
        except InputError as error:
            said = f" {each!r}" if isinstance(each, str) else ""
            raise InputError(f"{option}{said}: {error}") from None
        system = replace(system, events=(*system.events, *found))
    return system


def set_by_hand(system: System, name: str) -> dict[str, Any]:
    """The table of an event by hand that sets a variable to what it is at the start."""
    owner, _, variable = name.partition(".")
    component, values = system.components.get(owner), list[Any]()
    for scalar in component.fmu.expand(variable) if component else ():
        start = START.get(component.fmu.variables[scalar].type, 0)  # type: ignore[union-attr]
        given = component.inputs.get(scalar, component.parameters.get(scalar))  # type: ignore[union-attr]
        values.append(start if given is None else given)
    value = plain(values if len(values) > 1 else values[0] if values else 0)
    return {"name": f"{name} by hand", "by_hand": True, "set": {name: value}}


def _with_file(system: System, path: Path) -> System:
    if not path.is_file():
        raise InputError(f"--scenario {path}: there is no such file; a scenario is a TOML file of [[events]]")
    file = TomlFile(path)
    for key in file.data:
        if key not in KEYS:
            raise file.fail(
                f"--scenario: unknown key '{key}'{nearest(key, KEYS)}; a scenario holds [[events]] and a description, "
                "all else stands in the system file",
                key,
            )
    checked(ScenarioTable, {**file.data, "events": []}, "", file)
    entries = file.entries(dict, "events")
    if not entries:
        raise InputError(f"--scenario {path}: it holds no [[events]]")
    named = [{**entry, "name": entry.get("name") or f"{path.stem} {k}"} for k, entry in enumerate(entries, 1)]
    found = events_of(file, system.components, system.connections, named, before=system.events)
    _require_in_time(system, found)
    return replace(system, events=(*system.events, *found))


def _require_in_time(system: System, events: Iterable[Event]) -> None:
    """Raise InputError for an event that is due behind the stop: who adds it wants to see it."""
    for event in events:
        if event.at is not None and event.at >= system.stop:
            raise InputError(
                f"event {event.name}: at = {seconds_text(event.at)} is not before the stop at "
                f"{seconds_text(system.stop)}; give a later stop, or leave it out {event.where}".rstrip()
            )
