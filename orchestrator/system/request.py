"""What is asked for this time, as it is written on the command line, and what it means; see `assemble`."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any

from ..errors import InputError
from .formats import is_system_file


@dataclass(frozen=True)
class Request:
    """The options of `rovbrush run`: texts, tuples where they are repeatable. Kept with a checkpoint, so that the run
    can go on."""

    system: str
    set_: tuple[str, ...] = ()
    stop: str = ""
    replace: tuple[str, ...] = ()
    map_: tuple[str, ...] = ()
    period: tuple[str, ...] = ()
    record_boundary: tuple[str, ...] = ()
    record: tuple[str, ...] = ()
    step: str = ""
    fmus: str = ""
    checkpoint: str = ""
    input_: tuple[str, ...] = ()
    csv: str = ""  # "rates": a CSV file for each rate too
    allow_outside: tuple[str, ...] = ()  # folders from which an SSP may take files
    start: str = ""
    parameters: str = ""
    real_time: str = ""  # factor, of a run that keeps pace with the clock on the wall
    realtime_policy: str = ""
    deadlines: str = ""
    fifo: str = ""
    cores: str = ""
    scenario: tuple[str, ...] = ()  # files of events
    event: tuple[str, ...] = ()  # events in a line each
    workers: str = ""  # threads that step FMUs, or "auto"

    def content(self) -> dict[str, Any]:
        """As JSON, with paths that hold in any folder."""
        return asdict(
            replace(
                self,
                system=str(Path(self.system).absolute()) if is_system_file(self.system) else self.system,
                fmus=str(Path(self.fmus).absolute()) if self.fmus else "",
                replace=tuple(map(_absolute, self.replace)),
                map_=tuple(map(_absolute, self.map_)),
                input_=tuple(str(Path(path).absolute()) for path in self.input_),
                parameters=set_name(self.parameters),
                scenario=tuple(str(Path(path).absolute()) for path in self.scenario),
                allow_outside=tuple(str(Path(path).absolute()) for path in self.allow_outside),
            )
        )

    @classmethod
    def of(cls, content: Mapping[str, Any]) -> Request:
        """From JSON. Raises ValueError if it is no request."""
        values = {key: tuple(map(str, v)) if isinstance(v, list) else str(v) for key, v in content.items()}
        kinds = {f.name: str if f.type == "str" else tuple for f in fields(cls)}
        if values.keys() != kinds.keys() or not all(isinstance(v, kinds[key]) for key, v in values.items()):
            raise ValueError("no request")
        return cls(**values)  # type: ignore[arg-type]


def set_name(text: str, folder: Path | None = None) -> str:
    """A parameter set, by its name or by the path of its file, from `folder` or here, which then holds anywhere."""
    path = folder / text if folder and text else Path(text)
    return str(path.absolute()) if text.endswith(".toml") or os.path.isfile(path) else text


def _absolute(text: str) -> str:
    """`motor=their.fmu` with its path absolute."""
    name, equals, path = text.partition("=")
    return f"{name}{equals}{Path(path.strip()).absolute()}" if equals else str(Path(text.strip()).absolute())


@dataclass(frozen=True)
class Changes:
    """By component: the FMU that replaces it, its mapping file, its period as text. Hashable, small to send.

    An empty name stands for the only component of a system: see `assemble.apply_changes`.
    """

    fmus: tuple[tuple[str, str], ...] = ()  # absolute paths
    mappings: tuple[tuple[str, str], ...] = ()
    periods: tuple[tuple[str, str], ...] = ()
    outside: tuple[str, ...] = ()  # folders elsewhere from which an SSP may take files
    parameters: str = ""  # the set in place of the system's own: a name, or an absolute path
    scenarios: tuple[str, ...] = ()  # files of events, absolute paths
    events: tuple[str, ...] = ()  # in a line each


UNCHANGED = Changes()


def changes_of(
    replacements: Iterable[str],
    mappings: Iterable[str],
    periods: Iterable[str],
    outside: Iterable[object] = (),
    parameters: str = "",
    scenarios: Iterable[object] = (),
    events: Iterable[str] = (),
) -> Changes:
    """From the options `--replace motor=their.fmu --map motor=map.toml --period motor="1 ms" --allow-outside ../fmus`
    and `--scenario drift.toml --event "2 s: motor.V_in = 0"`.

    Raises InputError.
    """
    return Changes(
        _pairs("--replace", replacements, "motor=their.fmu", paths=True),
        _pairs("--map", mappings, "motor=map.toml", paths=True),
        _pairs("--period", periods, 'motor="1 ms"'),
        tuple(str(Path(str(folder)).absolute()) for folder in outside),
        set_name(parameters),
        tuple(str(Path(str(file)).absolute()) for file in scenarios),
        tuple(events),
    )


def _pairs(option: str, texts: Iterable[str], example: str, paths: bool = False) -> tuple[tuple[str, str], ...]:
    found: dict[str, str] = {}
    for text in texts:
        first, equals, rest = (part.strip() for part in text.partition("="))
        name, value = (first, rest) if equals else ("", first)
        if not value or (equals and not name):
            raise InputError(f"{option} {text}: write component=value, for instance {option} {example}")
        if name in found:
            raise InputError(f"{option} {text}: {name or 'the component'} has {found[name]} already")
        found[name] = str(Path(value).absolute()) if paths else value
    return tuple(found.items())


def assignments(options: Sequence[str], named: str = "--set") -> dict[str, object]:
    """`["motor.R=0.1"]` as a mapping; brackets hold a list: `beam.zeta=[0.02,0.03]`. Raises InputError.

    `named`: the option that they are of."""
    values: dict[str, object] = {}
    for option in options:
        name, equals, text = option.partition("=")
        if not (equals and name.strip()):
            raise InputError(f"{named} {option}: write component.variable=value, for instance motor.R=0.1")
        text = text.strip()
        if text.startswith("[") != text.endswith("]"):
            raise InputError(f"{named} {option}: a list needs both brackets, for instance beam.zeta=[0.02,0.03]")
        values[name.strip()] = [part.strip() for part in text[1:-1].split(",")] if text.startswith("[") else text
    return values
