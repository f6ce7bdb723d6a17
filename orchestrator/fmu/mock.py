"""A participant that is a Python object: for tests of plans and algorithms, which take milliseconds then.

The loop calls it by the same five addresses as any FMU, and it keeps to the same life-cycle table. Its `Model` is given
and gives Real variables by name:

    class Lag(Model):
        def step(self, time: float, length: float) -> int | None:
            self.values["y"] += length * (self.values["u"] - self.values["y"])

    fmu = mock_fmu("lag", Lag, inputs=["u"], outputs=["y"])
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from fmpy.model_description import CoSimulation, ModelDescription, ModelVariable, Unknown

from .fmu import Fmu


class Model:
    """What a mock does. Methods may return a status; None is OK, and an exception is Error with its text as message."""

    def __init__(self, starts: Mapping[str, float]) -> None:
        self.values = dict(starts)
        self.calls: list[tuple[Any, ...]] = []  # ("set", {name: value}), ("step", time, length), ...

    def set(self, values: Mapping[str, float]) -> int | None:
        self.values.update(values)
        return None

    def get(self, names: Iterable[str]) -> list[float]:
        return [self.values[name] for name in names]

    def step(self, time: float, length: float) -> int | None:
        """To be written."""
        return None

    def save(self) -> dict[str, float]:
        return dict(self.values)

    def restore(self, state: dict[str, float]) -> None:
        self.values = dict(state)


@dataclass(frozen=True)
class MockFmu(Fmu):
    """What an FMU's files would say of a mock."""

    model: Callable[[Mapping[str, float]], Model] = Model
    made: list[Model] = field(default_factory=list)  # the models of its instances, to look at what they were told

    @cached_property
    def library(self) -> Path:
        """A file that there is not: a mock has none."""
        return self.path


def mock_fmu(
    name: str, model: Callable[[Mapping[str, float]], Model] = Model, inputs: Iterable[str] = (),
    outputs: Iterable[str] = (), parameters: Mapping[str, float] | None = None,
    feedthrough: Mapping[str, Iterable[str]] | None = None,
) -> MockFmu:  # fmt: skip
    """Of Real variables that start with 0; `feedthrough`: for an output the inputs that act on it at once."""
    variables = [
        ModelVariable(
            name=variable, valueReference=k, type="Real", causality=causality,
            variability="fixed" if causality == "parameter" else "continuous",
            start=None if causality == "output" else repr(float(start)),
        )
        for k, (variable, causality, start) in enumerate(
            [*((v, "input", 0.0) for v in inputs), *((v, "output", 0.0) for v in outputs),
             *((v, "parameter", start) for v, start in (parameters or {}).items())]
        )
    ]  # fmt: skip
    known = {v.name: v for v in variables}
    unknowns = [
        Unknown(index=0, variable=v, dependencies=[known[u] for u in (feedthrough or {}).get(v.name, ())])
        for v in variables
        if v.causality == "output"
    ]
    description = ModelDescription(
        fmiVersion="2.0", modelName=name, instantiationToken=name, modelVariables=variables, outputs=unknowns,
        initialUnknowns=unknowns,
        coSimulation=CoSimulation(
            modelIdentifier=name, canHandleVariableCommunicationStepSize=True, canGetAndSetFMUstate=True
        ),
    )  # fmt: skip
    return MockFmu(Path(f"{name}.mock"), Path(), name, description, {}, model=model)
