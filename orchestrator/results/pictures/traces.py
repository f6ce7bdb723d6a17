"""The recorded signals of a result with what a picture needs to know of them: of a run, or of the folder of one."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError, nearest
from ...system.file.recorded import matching
from ..signals import Signal, Signals
from ..tables import AT_START, Run

if TYPE_CHECKING:
    from ..opened import OpenedResult
    from ..result import Result

COUPLING = "coupling."  # what the algorithm says of itself


@dataclass(frozen=True)
class Traces:
    """Signals by name, `component.variable`, read when they are asked for."""

    title: str
    names: tuple[str, ...]
    get: Callable[[str], Signal]
    connected: tuple[str, ...] = ()  # what drives something, in the order of the connections
    events: tuple[tuple[float, str], ...] = ()  # when [s], and what happened
    caption: str = ""  # what the parameter set says of itself
    failure: str = ""

    def __getitem__(self, name: str) -> Signal:
        return self.get(name)

    def usual(self) -> list[str]:
        """What is looked at first: the connected signals that are recorded; where there are none, all of them."""
        found = [name for source in self.connected for name in matching(source, self.names)]
        return list(dict.fromkeys(found)) or [name for name in self.names if not name.startswith(COUPLING)]

    def chosen(self, patterns: Sequence[str]) -> list[str]:
        """The signals that patterns such as `motor.*` mean; those looked at first for none. Raises InputError."""
        owners = {name.partition(".")[0] for name in self.names}
        found: list[str] = []
        for pattern in patterns:
            hits = matching(pattern, self.names)
            if not hits and len(owners) == 1:
                hits = matching(f"{next(iter(owners))}.{pattern}", self.names)
            if not hits:
                raise InputError(f"{self.title}: no recorded signal '{pattern}'{nearest(pattern, self.names)}")
            found += hits
        return list(dict.fromkeys(found)) if patterns else self.usual()


def traces(result: Result) -> Traces:
    """The signals of a result of this process, or of one that was opened."""
    from ..opened import OpenedResult

    return folder_traces(result) if isinstance(result, OpenedResult) else run_traces(result.run)


def run_traces(run: Run) -> Traces:
    """The signals of a run."""
    signals, system = Signals(run), run.plan.system
    return Traces(
        system.name,
        tuple(signals.places),
        signals.__getitem__,
        _sources(connection.label for connection in system.connections),
        tuple((row.time, row.what) for row in run.events if row.what not in ("", AT_START)),
        f"parameters: {system.parameter_set}" if system.parameter_set else "",
        run.failure,
    )


def folder_traces(result: OpenedResult) -> Traces:
    """The signals in a folder. What it does not say (an old one, or one without manifest) is left out."""
    tables = result.datasets
    places = {str(key): table for table in tables.values() for key in table.data_vars}
    about: dict[str, Any] = {}
    with suppress(OSError, ValueError, RecursionError):
        read = json.loads((result.folder / "manifest.json").read_text(encoding="utf-8"))
        about = read if isinstance(read, dict) else {}

    def get(name: str) -> Signal:
        if name not in places:
            raise InputError(f"no recorded signal '{name}'{nearest(name, places)}")
        table = places[name]
        stored = table[name]
        said = (str(stored.attrs.get("units", "")), str(stored.attrs.get("long_name", "")))
        return Signal(name, *said, np.asarray(table["time"].values), np.asarray(stored.values))

    happened = result.events
    events: list[tuple[float, str]] = []
    if "what" in happened:
        rows = zip(happened["time"].values.tolist(), happened["what"].values.tolist(), strict=True)
        events = [(float(time), str(what)) for time, what in rows if what not in ("", AT_START)]
    parameters = about.get("parameters")
    complete = bool(result.summary.get("complete"))
    return Traces(
        str(about.get("system", result.folder.name)),
        tuple(places),
        get,
        _sources(_labels(about)),
        tuple(events),
        f"parameters: {parameters}" if parameters else "",
        "" if complete else str(result.summary.get("failure", "the run did not reach its stop")),
    )


def _sources(labels: Iterable[str]) -> tuple[str, ...]:
    """What connections begin at: `a.y` of `a.y -> b.u (mean)`."""
    return tuple(dict.fromkeys(label.partition(" -> ")[0].strip() for label in labels))


def _labels(manifest: Mapping[str, Any]) -> list[str]:
    """The connections of a manifest, in words."""
    found = manifest.get("connections")
    entries = found if isinstance(found, list) else []
    return [str(entry["connection"]) for entry in entries if isinstance(entry, dict) and "connection" in entry]
