"""Whether an FMU fits a recording: the steps that it can take, and its variables for those that were recorded."""

from __future__ import annotations

import numpy as np
from fmpy.model_description import ModelVariable

from ...clock import seconds_text
from ...errors import InputError, nearest
from ...fmu.fmu import Fmu
from ...system.replace.crossing import Crossing
from ...system.replace.fit import crossing_between
from ...system.replace.mapping import VariableMapping
from .read import Recording


def check_steps(fmu: Fmu, recording: Recording) -> None:
    """Raise InputError for an FMU of fixed steps that cannot make those of the recording."""
    steps, step = np.diff(recording.times), recording.options["StepSize"]
    if fmu.can_vary_step:
        return
    label = f"{fmu.path.name} has fixed steps (canHandleVariableCommunicationStepSize = false)"
    if np.any(np.abs(steps - step) > 1e-9 * max(step, float(np.max(np.abs(recording.times))))):
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


def crossings_for(fmu: Fmu, recording: Recording, mapping: VariableMapping) -> tuple[dict[str, Crossing], list[str]]:
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
            crossings[ours] = crossing_between(
                recording.name, known, theirs, mapping, label, (unit, fmu.unit(theirs.name))
            )
        elif mapping.states(ours):
            notes.append(f"{label} has no {role} for {ours}, as {mapping.file} says; left out")
        else:
            lacking.setdefault(role, []).append(ours)
    for role, names in lacking.items():
        theirs_all = [n for n, v in fmu.variables.items() if v.causality == role]
        raise InputError(
            f"{label} has no {role} {', '.join(repr(n) for n in names)}; give a mapping file with --map: "
            f'[variables] {names[0]} = "their name", or {names[0]} = "" to do without{nearest(names[0], theirs_all)}'
        )
    return crossings, notes
