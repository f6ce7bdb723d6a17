"""An FMU that is driven alone, with recorded inputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ...errors import InputError
from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import REALS
from ...participant.loaded import LoadedInstance
from ...participant.port import Port
from ...system.replace.crossing import Crossing
from ...system.replace.mapping import VariableMapping
from ...system.replace.replacement import own_values
from .read import Recording


def drive(
    instance: LoadedInstance, recording: Recording, mapping: VariableMapping, crossings: Mapping[str, Crossing],
    report: Callable[[float], None],
) -> dict[str, np.ndarray]:  # fmt: skip
    """Initialize as recorded, step through the times, collect the outputs: (rows,) each, in our units."""
    times, step, fmu = recording.times.tolist(), recording.options["StepSize"], instance.fmu
    inputs = [v for v in recording.inputs if v in crossings]
    outputs = [v for v in recording.outputs if v in crossings]
    for name in (*inputs, *outputs):
        if fmu.variables[crossings[name].name].type not in REALS:
            raise InputError(f"{fmu.path.name}: '{crossings[name].name}' is no real number; only such are recorded")
    own = own_values(fmu.variables, mapping, {c.name for c in crossings.values()}, fmu.path.name)
    starts = {name: start.value for name, start in recording.starts.items() if start.causality != "output"}
    starts = {**{name: repr(float(recording.inputs[name][0])) for name in inputs}, **starts}
    begin = {
        crossings[name].name: _there(fmu, crossings[name], value) for name, value in starts.items() if name in crossings
    }
    begin |= {name: parse_value(fmu.variables[name], value, name) for name, value in own.items()}
    instance.set_up(recording.options["StopTime"], times[0])
    instance.set_all(begin)
    instance.enter_initialization()
    given, taken = (Port(instance, [crossings[name].name for name in names]) for names in (inputs, outputs))
    there, back = [crossings[name].there for name in inputs], [crossings[name].back for name in outputs]
    given.put([begin[crossings[name].name] for name in inputs])
    instance.exit_initialization()
    rows = [[f(value) for f, value in zip(back, taken.take(), strict=True)]]
    columns = [recording.inputs[name].tolist() for name in inputs]
    for k in range(len(times) - 1):
        given.put([f(column[k]) for f, column in zip(there, columns, strict=True)])
        gap = times[k + 1] - times[k]
        instance.step(times[k], step if abs(gap - step) <= 1e-9 * max(step, abs(times[k])) else gap)
        rows.append([f(value) for f, value in zip(back, taken.take(), strict=True)])
        if k % 1000 == 0:
            report((times[k] - times[0]) / (times[-1] - times[0]))
    return dict(zip(outputs, np.array(rows).T.reshape(len(outputs), -1), strict=True))


def _there(fmu: Fmu, cross: Crossing, text: str) -> float | int | bool | str:
    variable = fmu.variables[cross.name]
    value = float(text) if variable.type in REALS and not cross.exact else text
    return parse_value(variable, cross.there(value) if isinstance(value, float) else value, cross.name)
