"""What crosses the boundary of one component, in the layout of the FMI cross-check, to replay it elsewhere.

    motor_in.csv          time and inputs: a row's values are held from its time to that of the next row
    motor_ref.csv         time and outputs at the communication points
    motor_ref.opt         StartTime, StopTime, StepSize [s], RelTol
    motor_parameters.csv  name, causality, value, unit: parameters and inputs as they are set before time 0, and the
                          outputs of time 0

Numbers have all their digits, so that the same FMU, stepped by StepSize, gives the same outputs bit by bit.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from ...files import write_file
from ...results.tables import Run
from ...system.replace.view import OWN

HEAD = ("name", "causality", "value", "unit")
TOLERANCE = 1e-6  # RelTol of a recording: between solvers of ordinary accuracy, not between bits


def write_boundary(run: Run, name: str, folder: Path, title: str = "") -> list[Path]:
    """Write the recording of component `name`, all of whose signals must be recorded. Raises RunError.

    `title`: what the files are called, if not as the component.
    """
    title = title or name
    plan = run.plan
    component = plan.system.components[name]
    at = next(k for k, group in enumerate(plan.groups) if name in group.components)
    group, table = plan.groups[at], run.tables[at]
    columns = {variable: k for k, (owner, variable) in enumerate(group.columns) if owner == name}
    times = [plan.clock.time(tick) for tick in run.ticks_of(at).tolist()]
    variables = component.fmu.variables
    # In row k of a table stands the input of the step that ends there; a file of inputs has it where the step begins.
    held = np.concatenate([table[1:], table[-1:]])
    inputs = {v: held[:, columns[v]].tolist() for v in component.fmu.names("input") if v in columns}
    constant = {v: value for v, value in component.inputs.items() if not v.startswith(OWN)}
    inputs |= {v: [float(value)] * len(times) for v, value in constant.items() if variables[v].type == "Real"}
    outputs = {v: table[:, columns[v]].tolist() for v in component.fmu.names("output") if v in columns}
    starts: dict[str, object] = {v: variables[v].start for v in component.fmu.names("parameter")}
    starts |= {**component.parameters, **constant}
    starts |= {v: float(table[0, columns[v]]) for v in (*inputs, *outputs) if v in columns}
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
    return str(value).lower() if isinstance(value, bool) else value


def _series(times: Sequence[float], columns: dict[str, list[float]]) -> Iterable[Sequence[object]]:
    yield ("time", *columns)
    yield from zip(times, *columns.values(), strict=True)


def _write_rows(path: Path, rows: Iterable[Sequence[object]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)  # a float is written with all its digits
