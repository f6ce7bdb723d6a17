"""An FMU that is driven alone, with recorded inputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ...participant.here.loaded import LoadedInstance
from ...participant.port import Ports
from ...system.replace.crossing import Crossing
from ...system.replace.mapping import VariableMapping
from ...system.replace.own import own_values
from .read import Recording
from .values import cell_value, typed


def drive(
    instance: LoadedInstance, recording: Recording, mapping: VariableMapping, crossings: Mapping[str, Crossing],
    report: Callable[[float], None],
) -> dict[str, list[Value]]:  # fmt: skip
    """Initialize as recorded, step through the times, collect the outputs: (rows,) each, in our units."""
    times, step, fmu = recording.times.tolist(), recording.options["StepSize"], instance.fmu
    inputs = [v for v in recording.inputs if v in crossings]
    outputs = [v for v in recording.outputs if v in crossings]
    own = own_values(fmu.variables, mapping, {c.name for c in crossings.values()}, fmu.path.name)
    starts = {name: start.value for name, start in recording.starts.items() if start.causality != "output"}
    starts = {**{name: recording.inputs[name][0] for name in inputs}, **starts}
    file = f"{recording.name}_parameters.csv"
    columns = []
    for name in inputs:
        values = typed(recording.inputs[name], fmu, crossings[name].name, f"{recording.path.name}: {name}")
        columns.append([_given(crossings[name], value) for value in values])
    begin = {
        crossings[name].name: _there(fmu, crossings[name], value, name in recording.inputs, f"{file}: {name}")
        for name, value in starts.items()
        if name in crossings
    }
    begin |= {name: parse_value(fmu.variables[name], value, name) for name, value in own.items()}
    instance.set_up(recording.options["StopTime"], times[0])
    instance.set_all(begin)
    instance.enter_initialization()
    given, taken = (Ports(instance, [crossings[name].name for name in names]) for names in (inputs, outputs))
    given.put([begin[crossings[name].name] for name in inputs])
    instance.exit_initialization()
    rows = [taken.take()]
    for k in range(len(times) - 1):
        given.put([column[k] for column in columns])
        gap = float(Fraction(repr(times[k + 1])) - Fraction(repr(times[k])))  # of decimals, as clocks have them
        instance.step(times[k], step if abs(gap - step) <= 1e-9 * max(step, abs(times[k])) else gap)
        rows.append(taken.take())
        if k % 1000 == 0:
            report((times[k] - times[0]) / (times[-1] - times[0]))
    return {name: [_taken(crossings[name], row[k]) for row in rows] for k, name in enumerate(outputs)}


def _given(cross: Crossing, value: Value) -> Value:
    """Our value as theirs; only real numbers have a unit or a sign."""
    return cross.there(value) if isinstance(value, float) else value


def _taken(cross: Crossing, value: Value) -> Value:
    return cross.back(value) if isinstance(value, float) else value


def _there(fmu: Fmu, cross: Crossing, text: str, held: bool, label: str) -> Value:
    """What a variable of theirs is set to before time 0: a parameter within its range, an input as it was recorded."""
    variable, kind = fmu.variables[cross.name], fmu.type_of(cross.name)
    value = cell_value(text, variable, kind, label)
    theirs = cross.there(value) if isinstance(value, float) and not cross.exact else value
    return theirs if held else parse_value(variable, theirs, label, kind)
