"""What crosses the boundary of one component, in the layout of the FMI cross-check, to replay it elsewhere.

    motor_in.csv          time and inputs: a row's values are held from its time to that of the next row
    motor_ref.csv         time and outputs at the communication points
    motor_ref.opt         StartTime, StopTime, StepSize [s], RelTol
    motor_parameters.csv  name, causality, value, unit: parameters and inputs as they are set before time 0, and the
                          outputs of time 0

Numbers have all their digits, so that the same FMU, stepped by StepSize, gives the same outputs bit by bit; a Boolean
is 0 or 1, an Enumeration its value, a text stands in quotes where it must.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

from ...errors import RunError
from ...files import write_file
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ...results.signals import Signals
from ...results.tables import Run
from ...system.inputs.free_inputs import left_alone
from ...system.replace.view import OWN
from .values import cells_of

HEAD = ("name", "causality", "value", "unit")
TOLERANCE = 1e-6  # RelTol of a recording: between solvers of ordinary accuracy, not between bits


def write_boundary(run: Run, name: str, folder: Path, title: str = "") -> list[Path]:
    """Write the recording of component `name`, all of whose signals must be recorded. Raises RunError.

    `title`: what the files are called, if not as the component.
    """
    title = title or name
    plan = run.plan
    component = plan.system.components[name]
    fmu, variables, signals = component.fmu, component.fmu.variables, Signals(run)
    found = next((g for g, group in enumerate(plan.groups) if name in group.components), None)
    if found is None:
        raise RunError(f"--record-boundary {name}: {fmu.path.name} has neither inputs nor outputs that are recorded")
    group = plan.groups[found]
    recorded = {v: cells_of(signals[f"{name}.{v}"].values) for owner, v in group.columns if owner == name}
    times = signals.times(found).tolist()
    # In row k of a table stands the input of the step that ends there; a file of inputs has it where the step begins.
    inputs = {v: [*recorded[v][1:], recorded[v][-1]] for v in fmu.names("input") if v in recorded}
    alone = {v: fmu.start(v) for v in left_alone(plan.system).get(name, ())}
    constant = {v: value for v, value in {**alone, **component.inputs}.items() if not v.startswith(OWN)}
    inputs |= {v: [_number(fmu, v, value)] * len(times) for v, value in constant.items()}
    outputs = {v: recorded[v] for v in fmu.names("output") if v in recorded}
    starts: dict[str, object] = {v: variables[v].start for v in fmu.names("parameter") if fmu.type_of(v)}
    starts |= {**component.parameters, **constant}
    starts |= {v: recorded[v][0] for v in (*inputs, *outputs) if v in recorded}
    rows = [
        (v, variables[v].causality, _text(value), variables[v].unit or "1")
        for v, value in starts.items()
        if value is not None and not v.startswith(OWN)  # what is another FMU's own means nothing to the next one
    ]
    step = float(plan.clock.seconds(group.period))
    settings = {"StartTime": times[0], "StopTime": times[-1], "StepSize": step, "RelTol": TOLERANCE}
    options = "".join(f"{key}, {value!r}\n" for key, value in settings.items())
    return [
        write_file(folder / f"{title}_in.csv", lambda path: _write_rows(path, _series(times, inputs))),
        write_file(folder / f"{title}_ref.csv", lambda path: _write_rows(path, _series(times, outputs))),
        write_file(folder / f"{title}_ref.opt", lambda path: path.write_text(options, encoding="utf-8")),
        write_file(folder / f"{title}_parameters.csv", lambda path: _write_rows(path, [HEAD, *rows])),
    ]


def boundary_files(title: str) -> list[str]:
    """The names of the files of a recording."""
    return [f"{title}_{end}" for end in ("in.csv", "ref.csv", "ref.opt", "parameters.csv")]


def _text(value: object) -> object:
    if isinstance(value, bytes):
        return value.hex()
    return str(value).lower() if isinstance(value, bool) else value


def _number(fmu: Fmu, name: str, value: Value) -> object:
    """A constant input as a cell."""
    return float(value) if fmu.is_real(name) else int(value) if isinstance(value, bool) else _text(value)


def _series(times: Sequence[float], columns: dict[str, list[object]]) -> Iterable[Sequence[object]]:
    yield ("time", *columns)
    yield from zip(times, *columns.values(), strict=True)


def _write_rows(path: Path, rows: Iterable[Sequence[object]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)  # a float is written with all its digits
