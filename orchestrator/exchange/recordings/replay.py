"""Drives one FMU with recorded inputs and compares its outputs with the recorded ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...errors import RunError
from ...fmu.fmu import Fmu
from ...participant.opening import load
from ...system.replace.mapping import VariableMapping, load_mapping
from .drive import drive
from .fit import check_steps, crossings_for
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
