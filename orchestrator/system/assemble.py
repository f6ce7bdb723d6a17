"""The only path from what was asked for to a checked system: its file, other FMUs, values, tables, what is recorded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..clock import duration
from ..errors import InputError, nearest
from .changes import UNCHANGED, Changes, changes_of
from .model import System
from .reader import load_system
from .request import Request
from .selection import select_recorded
from .series_file import with_files


def assemble(
    name: str,
    values: Mapping[str, object] | None = None,
    stop: str = "",
    fmus: Path | None = None,
    changes: Changes = UNCHANGED,
    boundaries: Sequence[str] = (),
    step: str = "",
    record: Sequence[str] = (),
    inputs: Sequence[Path] = (),
) -> System:
    """A system by the name of a shipped one or by the path of its file, with what is to be different this time.

    `values`: parameters and free inputs, as of `--set`. `stop`: another stop time. `fmus`: the folder of built FMUs.
    `changes`: FMUs in the place of others, and periods. `boundaries`: components of which every input and output is
    recorded. `step`: see `load_system`. `record`: patterns of what is recorded instead of what the system says.
    `inputs`: CSV files whose columns inputs follow. Raises InputError or FmuError.
    """
    system = changes.apply(load_system(name, fmus, step, stop)).with_values(values or {}, "--set")
    system = with_files(system, inputs)
    if record:
        system = select_recorded(system, record)
    for component in boundaries:
        if component not in system.components:
            raise InputError(f"--record-boundary: no component '{component}'{nearest(component, system.components)}")
    if boundaries and system.algorithm == "ecco":
        raise InputError(f"--record-boundary needs steps of one length; with algorithm 'ecco' they vary ({name})")
    system = replace(system, record=(*system.record, *(f"{component}.*" for component in boundaries)))
    return replace(system, stop=duration(stop, "--stop")) if stop else system


def assemble_request(request: Request) -> System:
    """What the command line asked for. Raises InputError or FmuError."""
    return assemble(
        request.system, assignments(request.set_), request.stop, Path(request.fmus) if request.fmus else None,
        changes_of(request.replace, request.map_, request.period), request.record_boundary, request.step,
        request.record, tuple(map(Path, request.input_)),
    )  # fmt: skip


def assignments(options: Sequence[str]) -> dict[str, object]:
    """`["motor.R=0.1"]` as a mapping; brackets hold a list: `beam.zeta=[0.02,0.03]`. Raises InputError."""
    values: dict[str, object] = {}
    for option in options:
        name, equals, text = option.partition("=")
        if not equals or "." not in name:
            raise InputError(f"--set {option}: write component.variable=value, for instance motor.R=0.1")
        text = text.strip()
        if text.startswith("[") != text.endswith("]"):
            raise InputError(f"--set {option}: a list needs both brackets, for instance beam.zeta=[0.02,0.03]")
        values[name.strip()] = [part.strip() for part in text[1:-1].split(",")] if text.startswith("[") else text
    return values
