"""Inputs that follow a table of times and values instead of a connection.

    series   the mean over the step of the line through the rows: its value in the middle of the step where no row lies
             within, and nothing is aliased where many do. Exact for what is straight between the rows, so the error
             against a smooth signal is O(h^2) with h the distance of the rows, whatever the step
    sample   a sampled input (FMI variability `discrete`), and any that is no floating-point number, takes the last row
             at or before the beginning of its step: O(h + H), as `hold`

As the transfers of connections, both say what is held over the step. Two rows of one time are a jump.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import FmiType, decode, encode
from ...loop.lookup import held_at, value_at
from ...units import conversion

if TYPE_CHECKING:
    from ..model import System

ROUNDING = 1e-12  # relative: by so much the last time of a table may miss the stop


@dataclass(frozen=True, eq=False)
class Series:
    """Times [s] that never fall and the cells of the input at them, both (n,); see `fmi_types` for cells."""

    times: np.ndarray
    cells: np.ndarray
    sampled: bool
    origin: str  # where it comes from, in words

    def __str__(self) -> str:
        return self.origin

    @property
    def table(self) -> np.ndarray:
        """As `lookup` reads it: (2 n + 1,)."""
        return np.concatenate([[float(len(self.times))], self.times, self.cells])

    @property
    def digest(self) -> str:
        """Hash of its content."""
        return hashlib.sha256(self.table.tobytes()).hexdigest()

    def first(self, kind: FmiType, time: float) -> float | int | bool:
        """The value at the start of a run [s]."""
        cell = held_at(self.table, 0, time) if self.sampled else value_at(self.table, 0, time)
        found: float | int | bool = decode(kind, np.array([cell]))[0].item()
        return found


def series_of(fmu: Fmu, name: str, times: Any, values: Any, unit: str | None, origin: str, label: str) -> Series:
    """Check a table for one scalar input and convert its unit. Raises InputError.

    `times` [s] and `values` are of shape (n,), arrays or sequences; `unit` is that of the values, None for the
    input's own; `label` begins every message.
    """
    variable, kind = fmu.variables[name], fmu.type_of(name)
    if kind is None or kind.dtype.kind == "O":
        raise InputError(f"{label}: an input of type {variable.type} takes one value, no series")
    t = _numbers(times, f"{label}: times")
    if not np.all(np.diff(t) >= 0):
        row = int(np.argmin(np.diff(t) >= 0))
        raise InputError(f"{label}: the times fall, from {t[row]:g} s to {t[row + 1]:g} s in row {row + 2}")
    shape = shape_of(values, label)
    if len(shape) != 1 or len(t) != len(values):
        raise InputError(f"{label}: {len(t)} times and values of shape {shape}; there must be one for each")
    if not kind.real:
        if unit is not None and unit != variable.unit:
            raise InputError(f"{label}: an input of type {variable.type} has no unit; leave out [{unit}]")
        known = {value: encode(kind, _checked(variable, value, label, kind)) for value in set(_plain(values))}
        cells = np.array([known[value] for value in _plain(values)])
        return Series(t, cells, True, origin)
    v = _numbers(values, f"{label}: values")
    gain, offset = conversion(None if unit is None else fmu.unit_called(unit, name), fmu.unit(name), label)
    v = v if (gain, offset) == (1.0, 0.0) else gain * v + offset
    for extreme in (np.min(v), np.max(v)):
        parse_value(variable, float(extreme), label, kind)
    return Series(t, v, variable.variability in ("discrete", "tunable"), origin)


def shape_of(values: Any, label: str) -> tuple[int, ...]:
    """The shape of an array or of nested lists. Raises InputError where lists of different lengths stand in one."""
    try:
        return np.shape(values)
    except ValueError:
        raise InputError(f"{label}: values have rows of different lengths; every row needs as many numbers") from None


def _plain(values: Any) -> list[Any]:
    found: list[Any] = values.tolist() if isinstance(values, np.ndarray) else list(values)
    return found


def _checked(variable: Any, value: object, label: str, kind: FmiType) -> float | int | bool:
    found = parse_value(variable, value, label, kind)
    assert not isinstance(found, (str, bytes))
    return found


def _numbers(values: Any, label: str) -> np.ndarray:
    """Finite numbers of shape (n,), n at least 1, in memory of their own."""
    try:
        found = np.array(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"{label}: {error}") from None
    if found.ndim != 1 or not len(found):
        raise InputError(f"{label}: a list of numbers is needed, not an array of shape {found.shape}")
    if not np.all(np.isfinite(found)):
        row = int(np.argmin(np.isfinite(found)))
        raise InputError(f"{label}: row {row + 1} holds {found[row]}, which is no finite number")
    return found


def check_series(system: System, clock: Clock) -> None:
    """Raise InputError where a table does not reach from the start to the stop."""
    start, stop = clock.time(0), clock.time(clock.stop)
    near = ROUNDING * max(abs(start), abs(stop))
    for component in system.components.values():
        for name, series in component.series.items():
            first, last = float(series.times[0]), float(series.times[-1])
            if first > start or last < stop - near:
                sooner = f', or stop at "{last:.9g} s"' if first <= start < last < stop else ""
                later = f', or start at "{first:.9g} s"' if start < first < stop <= last else ""
                begin, end = (seconds_text(clock.seconds(clock.start + tick)) for tick in (0, clock.stop))
                raise InputError(
                    f"input {component.name}.{name}: {series.origin} holds {first:.9g} s to {last:.9g} s, the run goes "
                    f"from {begin} to {end}; add rows{sooner}{later}"
                )


def series_in_words(system: System) -> list[str]:
    """A line of the plan for every input that follows a table."""
    found = []
    for component in system.components.values():
        for name, series in component.series.items():
            how = (
                "sample, the last row at or before the step's beginning"
                if series.sampled
                else "series, the mean over the step of the line through the rows: second order in their distance"
            )
            label = f"{component.name}.{name}"
            found.append(f"  {label:<28} {series.origin}, {len(series.times)} rows; {how}")
    return found


def refuse_series(system: System, what: str) -> None:
    """Raise InputError where inputs follow tables and `what` cannot hold any."""
    for name, component in system.components.items():
        for variable in component.series:
            raise InputError(f"input {name}.{variable} follows a table, which {what}; give it one value")


def manifest_of(series: Mapping[str, Series]) -> dict[str, dict[str, Any]]:
    """What a manifest says of tables."""
    return {
        name: {"from": s.origin, "rows": len(s.times), "sha256": s.digest, "sampled": s.sampled}
        for name, s in series.items()
    }
