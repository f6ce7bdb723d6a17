"""Drives one FMU with recorded inputs and compares its outputs with the recorded ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fmpy.model_description import ModelVariable

from ...clock import seconds_text
from ...errors import InputError, RunError, nearest
from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import REALS
from ...participant.loaded import LoadedInstance
from ...participant.opening import load
from ...participant.port import Port
from ...system.replace.crossing import Crossing
from ...system.replace.mapping import VariableMapping, load_mapping
from ...system.replace.replacement import crossing_between, own_values
from .read import Recording, read_recording


@dataclass(frozen=True)
class Verdict:
    """One output: the largest error, when [s], the largest recorded magnitude, and what follows."""

    output: str
    unit: str
    error: float
    at: float
    scale: float
    differing: int  # instants at which the two are not equal
    bound: float

    @property
    def text(self) -> str:
        return "equal" if not self.differing else "within" if self.error <= self.bound else "outside"


@dataclass(frozen=True)
class Replay:
    """What a replay gave: a verdict per output, and what was left out."""

    recording: str
    steps: int
    verdicts: list[Verdict]
    notes: list[str]

    def require_within(self) -> list[Verdict]:
        """The verdicts. Raises RunError if an output is outside its bound."""
        outside = [v.output for v in self.verdicts if v.text == "outside"]
        if outside:
            raise RunError(
                f"outside the tolerance: {', '.join(outside)}; see when, and whether parameters, units, signs and the "
                "FMU's own step are those of the recording; other tolerances: --rtol, --atol"
            )
        return self.verdicts


def replay(
    fmu: Path,
    folder: Path,
    name: str = "",
    mapping: Path | None = None,
    rtol: float | None = None,
    atol: float = 0.0,
    progress: Callable[[float], None] = lambda _share: None,
) -> Replay:
    """Drive an FMU through the recording `name` of a folder, or its only one.

    An output is within where |error| <= atol + rtol * its largest magnitude; `rtol`: None for the RelTol of the
    recording. `progress` hears now and then what share is done, 0 to 1. Raises InputError for files and names that do
    not fit, FmuError if the FMU refuses.
    """
    recording = read_recording(folder, name)
    known = load_mapping(mapping) if mapping else VariableMapping()
    verdicts, notes = compare(fmu, recording, known, rtol, atol, progress)
    return Replay(recording.name, len(recording.times) - 1, verdicts, notes)


def compare(
    path: Path, recording: Recording, mapping: VariableMapping, rtol: float | None, atol: float,
    progress: Callable[[float], None],
) -> tuple[list[Verdict], list[str]]:  # fmt: skip
    """Drive the FMU through the recording; a verdict per output, and what was left out."""
    fmu = Fmu.open(path)
    _check_steps(fmu, recording)
    crossings, notes = _crossings(fmu, recording, mapping)
    instance = load(fmu, path.stem)
    try:
        found = _drive(instance, recording, mapping, crossings, progress)
    finally:
        said = instance.close()
    notes += [said] if said else []
    relative = recording.options["RelTol"] if rtol is None else rtol
    verdicts = []
    for output, values in found.items():
        reference = recording.outputs[output]
        error = np.abs(values - reference)
        error[~np.isfinite(error)] = np.inf
        k, scale = int(np.argmax(error)), float(np.max(np.abs(reference)))
        start = recording.starts.get(output)
        verdicts.append(
            Verdict(
                output, (start.unit if start else None) or "", float(error[k]), float(recording.times[k]), scale,
                int(np.sum(error != 0)), atol + relative * scale,
            )
        )  # fmt: skip
    return verdicts, notes


def _check_steps(fmu: Fmu, recording: Recording) -> None:
    """Raise InputError for an FMU of fixed steps that cannot make those of the recording."""
    steps, step = np.diff(recording.times), recording.options["StepSize"]
    if fmu.can_vary_step:
        return
    label = f"{fmu.path.name} has fixed steps (canHandleVariableCommunicationStepSize = false)"
    if np.any(np.abs(steps - step) > 1e-9 * max(step, float(recording.times[-1]))):
        raise InputError(f"{label}, and {recording.name}_ref.csv has steps of several lengths")
    inside, made_for = fmu.internal_step, fmu.recommended_step
    size = inside or made_for
    if size is None:
        return
    ratio = step / float(size)
    if abs(ratio - (max(1, round(ratio)) if inside else 1)) > 1e-9 * ratio:
        raise InputError(
            f"{label} of {seconds_text(size)}, and the recording's are of {step:g} s; record anew: "
            f'`rovbrush run SYSTEM --period NAME="{seconds_text(size)}" --record-boundary NAME`'
        )


def _crossings(fmu: Fmu, recording: Recording, mapping: VariableMapping) -> tuple[dict[str, Crossing], list[str]]:
    """Their variable for every recorded one that they have. What they lack must be declared so."""
    roles = dict.fromkeys(recording.inputs, "input") | dict.fromkeys(recording.outputs, "output")
    roles |= {name: start.causality for name, start in recording.starts.items()}
    label = fmu.path.name
    left_out = [name for name, entry in mapping.entries.items() if entry.absent]  # a recording may lack them too
    mapping.check([*roles, *left_out], fmu.variables, recording.name, label)
    crossings: dict[str, Crossing] = {}
    lacking: dict[str, list[str]] = {}
    notes = []
    for ours, role in roles.items():
        theirs = fmu.variables.get(mapping.entry(ours).name)
        if theirs is not None:
            unit = recording.starts[ours].unit if ours in recording.starts else None
            known = ModelVariable(name=ours, causality=role, unit=unit, type=theirs.type)
            crossings[ours] = crossing_between(recording.name, known, theirs, mapping, label)
        elif mapping.states(ours):
            notes.append(f"{label} has no {role} for {ours}, as {mapping.file} says; left out")
        else:
            lacking.setdefault(role, []).append(ours)
    for role, names in lacking.items():
        theirs_all = [n for n, v in fmu.variables.items() if v.causality == role]
        raise InputError(
            f"{label} has no {role} {', '.join(repr(n) for n in names)}{nearest(names[0], theirs_all)}; give a mapping "
            f'file with --map: [variables] {names[0]} = "their name", or {names[0]} = "" to do without'
        )
    return crossings, notes


def _drive(
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
    instance.set_up(recording.options["StopTime"])
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
        instance.step(times[k], step if abs(gap - step) <= 1e-9 * max(step, times[k]) else gap)
        rows.append([f(value) for f, value in zip(back, taken.take(), strict=True)])
        if k % 1000 == 0:
            report(times[k] / times[-1])
    return dict(zip(outputs, np.array(rows).T.reshape(len(outputs), -1), strict=True))


def _there(fmu: Fmu, cross: Crossing, text: str) -> float | int | bool | str:
    variable = fmu.variables[cross.name]
    value = float(text) if variable.type in REALS and not cross.exact else text
    return parse_value(variable, cross.there(value) if isinstance(value, float) else value, cross.name)
