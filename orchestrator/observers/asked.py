"""Observers as they are asked for, `mcap=run.mcap`: which kinds there are, and what each wants to know."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from ..errors import InputError, nearest
from ..extras import require
from .sink import Sink


class Kind(NamedTuple):
    """`module`: of the package that it needs, if any; `place`: the file of its sink here; `where`: an example."""

    place: str
    module: str
    where: str


KINDS = {
    "csv": Kind("csv_stream", "", "run.csv, or - for standard output"),
    "mcap": Kind("mcap_file", "mcap", "run.mcap"),
    "ros2": Kind("ros2_file", "mcap", "run.mcap"),
    "foxglove": Kind("foxglove_server", "foxglove", "8765 or 127.0.0.1:8765"),
    "rerun": Kind("rerun_log", "rerun", "run.rrd, or 127.0.0.1:9876 of a viewer"),
    "udp": Kind("udp", "", "127.0.0.1:9870"),
    "mqtt": Kind("mqtt", "paho", "localhost:1883/prefix"),
}


def sinks_of(given: Sequence[str | Sink], option: str = "--observe") -> list[tuple[str, Sink]]:
    """Observers by what they are called. Raises InputError for a kind that there is not, a place that is none, two for
    one place, and a package that is missing."""
    found: dict[str, Sink] = {}
    for each in given:
        name = each if isinstance(each, str) else type(each).__name__
        if name in found:
            raise InputError(f"{option} {name}: it is there already")
        found[name] = _sink(each, option) if isinstance(each, str) else each
    return list(found.items())


def _sink(text: str, option: str) -> Sink:
    kind, equals, where = (part.strip() for part in text.partition("="))
    if kind not in KINDS:
        raise InputError(f"{option} {text}: no observer is called '{kind}'{nearest(kind, KINDS)}")
    if not equals or not where:
        raise InputError(f"{option} {text}: where to? Write {kind}={KINDS[kind].where}")
    found = KINDS[kind]
    if found.module:
        require(found.module, f"{option} {text}")
    make: Callable[[str, str], Sink] = import_module(f".sinks.{found.place}", __package__).sink_of
    return make(where, f"{option} {text}")


def file_of(where: str, label: str) -> Path:
    """A file that can be written. Raises InputError."""
    path = Path(where).absolute()
    if path.is_dir():
        raise InputError(f"{label}: {where} is a folder; give a file in it")
    if not path.parent.is_dir():
        raise InputError(f"{label}: there is no folder {path.parent}")
    return path


def address_of(where: str, label: str, host: str = "127.0.0.1", port: int | None = None) -> tuple[str, int]:
    """`127.0.0.1:9870`, `[::1]:9870`, or a port alone. Raises InputError."""
    match = re.fullmatch(r"(?:(?P<host>\[[0-9a-fA-F:.]+\]|[\w.-]+?):)?(?P<port>\d{1,5})", where)
    if match is None and port is not None and re.fullmatch(r"[\w.-]+", where):
        return where, port
    if match is None or int(match["port"]) > 65535:
        raise InputError(f"{label}: {where} is no address; write host:port, with a port from 0 to 65535")
    return (match["host"] or host).strip("[]"), int(match["port"])
