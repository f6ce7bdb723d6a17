"""Which inputs an output answers to, as the model description states it; where it states nothing, to all of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .fmu import Fmu


def direct(fmu: Fmu, output: str) -> set[str]:
    """Inputs on which an output depends at once while the FMU steps (direct feedthrough)."""
    return _stated(fmu, fmu.description.outputs, output, set(fmu.names("input")))


def initial(fmu: Fmu, output: str) -> set[str]:
    """Inputs on which an output depends at time 0. An output with an exact start value depends on none."""
    exact = fmu.variables[output].initial == "exact"
    return _stated(fmu, fmu.description.initialUnknowns, output, set() if exact else set(fmu.names("input")))


def _stated(fmu: Fmu, unknowns: Iterable[Any], output: str, otherwise: set[str]) -> set[str]:
    for unknown in unknowns:
        if unknown.variable.name == output and unknown.dependencies is not None:
            return {v.name for v in unknown.dependencies if v.causality == "input"}
    return otherwise
