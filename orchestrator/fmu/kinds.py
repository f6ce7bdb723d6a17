"""The kinds of FMUs: how an FMU is run, of the interfaces that it has."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

from fmpy.model_description import ModelDescription

from ..errors import FmuError

Kind = Literal["co-simulation", "model-exchange", "scheduled-execution"]
CO_SIMULATION: Kind = "co-simulation"
MODEL_EXCHANGE: Kind = "model-exchange"
SCHEDULED_EXECUTION: Kind = "scheduled-execution"
FIELDS: dict[Kind, str] = {  # of fmpy's description; an FMU of several kinds is taken for the first of them
    CO_SIMULATION: "coSimulation", MODEL_EXCHANGE: "modelExchange", SCHEDULED_EXECUTION: "scheduledExecution",
}  # fmt: skip
WORDS: dict[Kind, str] = {
    CO_SIMULATION: "co-simulation", MODEL_EXCHANGE: "model exchange", SCHEDULED_EXECUTION: "scheduled execution",
}  # fmt: skip
RUN = {  # what can be run: versions of FMI and kinds
    *((version, CO_SIMULATION) for version in (1, 2, 3)), *((version, MODEL_EXCHANGE) for version in (1, 2, 3)),
    (3, SCHEDULED_EXECUTION),
}  # fmt: skip


def kinds_of(description: ModelDescription) -> tuple[Kind, ...]:
    """The kinds that an FMU can be taken for, that which is taken where nobody chooses first."""
    return tuple(kind for kind, name in FIELDS.items() if getattr(description, name) is not None)


def usual_kind(description: ModelDescription) -> Kind:
    """What an FMU is taken for where nobody chooses: the first of its kinds that can be run."""
    kinds, version = kinds_of(description), int(description.fmiMajorVersion)
    return next((kind for kind in kinds if (version, kind) in RUN), kinds[0])


def interface_of(description: ModelDescription, kind: Kind) -> Any:
    """What a description says about one of its kinds."""
    return getattr(description, FIELDS[kind])


def require_kind(path: Path, description: ModelDescription, kind: Kind | None = None) -> None:
    """Raise FmuError for an FMU that cannot be run as this kind, or as none of its kinds."""
    there, version = kinds_of(description), int(description.fmiMajorVersion)
    names = " and ".join(WORDS[each] for each in there)
    if kind is None:
        if not any((version, each) in RUN for each in there):
            raise FmuError(f"FMU {path} is for {names} only; export it for co-simulation")
    elif kind not in there:
        raise FmuError(f'FMU {path} is for {names}, not for {WORDS[kind]}; kind = "{there[0]}"')
    elif (version, kind) not in RUN:
        what = f"{WORDS[kind]} of FMI {version}.0"
        raise FmuError(f"FMU {path}: {what} cannot be run; export it for co-simulation")
