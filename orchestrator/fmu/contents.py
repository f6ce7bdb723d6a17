"""What is in an FMU, as data for a person or a program: variables, capabilities, platforms, experiment."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from fmpy.model_description import ModelVariable

from ..errors import FmuError
from .attributes import items_of
from .files.unpacked import unpack
from .fmu import Fmu
from .kinds import FIELDS, usual_kind
from .reading.aliases import other_names
from .reading.description import described
from .reading.states import state_names
from .reading.terminals import as_data

FLAGS = (
    "canHandleVariableCommunicationStepSize", "canInterpolateInputs", "maxOutputDerivativeOrder",
    "canGetAndSetFMUstate", "canSerializeFMUstate", "providesDirectionalDerivative", "hasEventMode",
    "mightReturnEarlyFromDoStep", "canReturnEarlyAfterIntermediateUpdate", "providesIntermediateUpdate",
    "recommendedIntermediateInputSmoothness", "providesEvaluateDiscreteStates", "fixedInternalStepSize",
    "needsExecutionTool",
    "canBeInstantiatedOnlyOncePerProcess", "canNotUseMemoryManagementFunctions",
)  # fmt: skip
TIMES = {"startTime": "start", "stopTime": "stop", "stepSize": "step", "tolerance": "tolerance"}


def readable(path: Path) -> tuple[Fmu, str]:
    """An FMU whose description can be read, and why it cannot be run here; empty if it can. Raises FmuError."""
    try:
        return Fmu.open(path), ""
    except FmuError as error:
        if not os.path.exists(path):
            raise
        folder, digest = unpack(path)
        found = described(path, folder)
        return Fmu(path, folder, digest, *found, kind=usual_kind(found.description)), str(error)


def contents_of(fmu: Fmu) -> dict[str, Any]:
    """Ready for JSON; what the description leaves open is None, or not there."""
    d = fmu.description
    others = other_names(d.modelVariables, fmu.negated)
    experiment = {
        name: float(stated)
        for key, name in TIMES.items()
        if (stated := getattr(d.defaultExperiment, key, None)) is not None
    }
    return {
        "file": fmu.path.name, "sha256": fmu.digest, "model": d.modelName, "fmi": d.fmiVersion,
        "description": d.description, "version": d.version, "author": d.author, "tool": d.generationTool,
        "identity": d.guid,
        "interfaces": [kind for kind in FIELDS.values() if getattr(d, kind) is not None],
        "platforms": sorted(path.name for path in (fmu.folder / "binaries").glob("*") if path.is_dir()),
        "sources": any((fmu.folder / "sources").glob("**/*.c*")),
        "capabilities": {
            key: value for key in FLAGS if (value := getattr(fmu.interface, key, None)) not in (None, False, 0, "0")
        },
        "experiment": experiment, "equations": _equations(fmu),
        "terminals": as_data(fmu.terminals),
        "variables": [_variable(fmu, v, others.get(v.name, "")) for v in d.modelVariables],
    }  # fmt: skip


def _equations(fmu: Fmu) -> dict[str, int]:
    """How many states and event indicators there are; nothing where it is not for Model Exchange."""
    if fmu.description.modelExchange is None:
        return {}
    return {"states": len(state_names(fmu)), "event indicators": int(fmu.description.numberOfEventIndicators)}


def _variable(fmu: Fmu, v: ModelVariable, alias_of: str) -> dict[str, Any]:
    found = {
        "name": v.name, "type": v.type, "causality": v.causality or "local", "variability": v.variability,
        "initial": v.initial, "unit": v.unit, "min": _number(v, "min"), "max": _number(v, "max"),
        "start": v.start, "description": v.description,
    }  # fmt: skip
    if len(texts := fmu.texts.get(v.name, [])) > 1:
        found["start"] = texts
    if v.displayUnit and v.displayUnit != v.unit:
        found["displayUnit"] = v.displayUnit
    if alias_of:
        found["alias"] = alias_of
    if v.shape:
        found["shape"] = list(v.shape)
        found["dimensions"] = [None if d.variable is None else d.variable.name for d in v.dimensions]
    if v.clocks:
        found["clocks"] = [clock.name for clock in v.clocks]
    if further := fmu.details.get(v.name if v.alias is None else v.alias.name):
        found["further"] = dict(further)
    if items := items_of(v):
        found["items"] = items
    return found


def _number(v: ModelVariable, key: str) -> float | None:
    bound = getattr(v, key)
    return None if bound is None else float(bound)


def in_order(variables: Iterable[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """By causality: what can be connected or set first."""
    order = ("input", "output", "parameter", "structuralParameter", "calculatedParameter", "local", "independent")
    found: dict[str, list[dict[str, Any]]] = {causality: [] for causality in order}
    for variable in variables:
        found.setdefault(variable["causality"], []).append(variable)
    return {causality: members for causality, members in found.items() if members}
