"""Drives one FMU with recorded inputs and compares its outputs with the recorded ones."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ...errors import RunError
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ...participant.opening import load
from ...system.replace.mapping import VariableMapping, load_mapping
from .drive import drive
from .fit import check_steps, crossings_for
from .read import Recording, read_recording
from .values import typed

EXACT = ("Boolean", "Enumeration", "String", "Binary")  # outputs that are right or wrong, with nothing between


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
    check_steps(fmu, recording)
    crossings, notes = crossings_for(fmu, recording, mapping)
    instance = load(fmu, path.stem)
    try:
        found = drive(instance, recording, mapping, crossings, progress)
    finally:
        said = instance.close()
    notes += [said] if said else []
    relative = recording.options["RelTol"] if rtol is None else rtol
    verdicts = []
    for output, values in found.items():
        theirs = crossings[output].name
        reference = typed(recording.outputs[output], fmu, theirs, f"{recording.name}_ref.csv: {output}")
        exact = fmu.variables[theirs].type in EXACT
        errors = [_error(value, wanted) for value, wanted in zip(values, reference, strict=True)]
        k = max(range(len(errors)), key=errors.__getitem__)
        scale = max((abs(float(wanted)) for wanted in reference if not isinstance(wanted, (str, bytes))), default=0.0)
        start = recording.starts.get(output)
        verdicts.append(
            Verdict(
                output, (start.unit if start else None) or "", errors[k], float(recording.times[k]), scale,
                sum(error != 0.0 for error in errors), 0.0 if exact else atol + relative * scale,
            )
        )  # fmt: skip
    return verdicts, notes


def _error(value: Value, wanted: Value) -> float:
    """The difference of two numbers; infinite where one is none, or where two texts differ."""
    if isinstance(value, (str, bytes)) or isinstance(wanted, (str, bytes)):
        return 0.0 if value == wanted else math.inf
    error = float(abs(value - wanted))  # of whole numbers exact
    return error if math.isfinite(error) else math.inf
