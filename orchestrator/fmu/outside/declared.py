"""What a participant that is no FMU says of itself: a description made of declared variables.

    variables = [Declared("force", "input", unit="N"), Declared("V_in", "output", unit="V", minimum=0.0, maximum=12.0),
                 Declared("k", "parameter", unit="V/N", start=0.05)]
    fmu = declared_fmu("controller", variables, path, "Python function", settings=...)

It has the types Real, Integer and Boolean of FMI 2.0 and the calls of FMI 2.0 for co-simulation.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from fmpy.model_description import CoSimulation, ModelDescription, ModelVariable, Unknown

from ...errors import InputError
from ...units import parse_unit
from ..attributes import parse_value
from ..fmu import Fmu
from ..types import TYPES
from .model import Model

Causality = Literal["input", "output", "parameter"]
Type = Literal["Real", "Integer", "Boolean"]
ZERO: dict[str, Any] = {"Real": 0.0, "Integer": 0, "Boolean": False}


@dataclass(frozen=True)
class Declared:
    """One variable. `start`: of its type; zero or false where it is None. Of an output it is the value until the first
    step has one. `tunable`: a parameter that may be set while the run goes. `sampled`: only its component's
    instants count for it (FMI variability `discrete`)."""

    name: str
    causality: Causality
    type: Type = "Real"
    unit: str = ""
    start: float | int | bool | None = None
    minimum: float | None = None
    maximum: float | None = None
    description: str = ""
    tunable: bool = False
    sampled: bool = False


@dataclass(frozen=True)
class DeclaredFmu(Fmu):
    """What an FMU's files would say of it.

    `what`: what it is, in a word or two ("Python function"). `model` makes what it does of the start values; where it
    is None, `participant.outside.opening` knows what to make of `settings`.
    """

    what: str = "no FMU"
    settings: Any = None
    model: Callable[[Mapping[str, Any]], Model] | None = None
    remark: str = ""  # what a person must know before a run

    @property
    def standard(self) -> str:
        return self.what

    @property
    def is_file(self) -> bool:
        return False

    @property
    def origin(self) -> str:
        return self.what

    @cached_property
    def library(self) -> Path:
        """A file that there is not."""
        return self.path

    @cached_property
    def windows(self) -> str:
        return ""

    def starts(self) -> dict[str, Any]:
        """The start values of all variables."""
        return {name: self.start(name) for name in self.variables}


def declared_fmu(
    name: str, variables: Sequence[Declared], path: Path, what: str, settings: Any = None,
    model: Callable[[Mapping[str, Any]], Model] | None = None, feedthrough: Mapping[str, Iterable[str]] | None = None,
    saves: bool = True, writes: bool = True, varies: bool = True, content: bytes = b"", kind: type[Any] = DeclaredFmu,
) -> Any:  # fmt: skip
    """The description of these variables as a `kind` of DeclaredFmu.

    `path`: what it is called in messages, a file or not. `feedthrough`: for an output the inputs that act on it at
    once; none where nothing is stated. `saves`, `writes`: its state can be saved, and written to disk. `varies`: steps
    of different lengths are allowed. `content`: what decides its results beside its variables and settings, for its
    digest. Raises InputError for names, units and bounds that cannot be.
    """
    description = _description(name, variables, feedthrough or {}, saves, writes, varies)
    digest = hashlib.sha256(repr((what, name, list(variables), settings)).encode() + content).hexdigest()
    return kind(path, Path(), digest, description, {}, what=what, settings=settings, model=model)


def _description(
    name: str, variables: Sequence[Declared], feedthrough: Mapping[str, Iterable[str]], saves: bool, writes: bool,
    varies: bool,
) -> ModelDescription:  # fmt: skip
    made = {v.name: _variable(v, k) for k, v in enumerate(variables)}
    if len(made) < len(variables):
        names = [v.name for v in variables]
        twice = next(v for v in names if names.count(v) > 1)
        raise InputError(f"{twice} is declared twice; each variable needs a name of its own")
    unknowns = [
        Unknown(index=0, variable=v, dependencies=[made[u] for u in feedthrough.get(v.name, ())])
        for v in made.values()
        if v.causality == "output"
    ]
    return ModelDescription(
        fmiVersion="2.0", modelName=name, instantiationToken=name, modelVariables=list(made.values()),
        outputs=unknowns, initialUnknowns=unknowns,
        coSimulation=CoSimulation(
            modelIdentifier=name, canHandleVariableCommunicationStepSize=varies, canGetAndSetFMUstate=saves,
            canSerializeFMUstate=saves and writes,
        ),
    )  # fmt: skip


def _variable(declared: Declared, reference: int) -> ModelVariable:
    """As the description of an FMU has it. Raises InputError."""
    name, real = declared.name, declared.type == "Real"
    if declared.unit:
        if not real:
            raise InputError(f"{name} is of type {declared.type}, which has no unit; leave out {declared.unit!r}")
        parse_unit(declared.unit)
    low, high = declared.minimum, declared.maximum
    if low is not None and high is not None and not low <= high:
        raise InputError(f"{name}: min = {low:g} is above max = {high:g}")
    continuous = "continuous" if real and not declared.sampled else "discrete"
    own = "tunable" if declared.tunable else "fixed"
    found = ModelVariable(
        name=name, valueReference=reference, type=declared.type, causality=declared.causality,
        variability=own if declared.causality == "parameter" else continuous, unit=declared.unit or None,
        description=declared.description or None,
        min=None if low is None else _text(low), max=None if high is None else _text(high),
    )  # fmt: skip
    start = ZERO[declared.type] if declared.start is None else declared.start
    if declared.start is not None:
        start = parse_value(found, start, f"start of {name}", TYPES[2][declared.type])
    found.start = _text(start)
    return found


def _text(value: float | int | bool) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(value)
