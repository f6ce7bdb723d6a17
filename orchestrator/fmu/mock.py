"""A participant for tests of plans and algorithms, which take milliseconds then: a Python object that notes its calls.

The loop calls it by the same addresses as any FMU, and it keeps to the same life-cycle table (`outside/`). Its `Model`
is given and gives Real variables by name:

    class Lag(Model):
        def step(self, time: float, length: float) -> int | None:
            self.values["y"] += length * (self.values["u"] - self.values["y"])

    fmu = mock_fmu("lag", Lag, inputs=["u"], outputs=["y"])
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from .outside import model as outside
from .outside.declared import Declared, DeclaredFmu, declared_fmu


class Model(outside.Model):
    """What a mock does; `calls` are what it was told: ("set", {name: value}), ("step", time, length), ..."""

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.calls: list[tuple[Any, ...]] = []

    def told(self, action: str, *what: Any) -> None:
        self.calls.append((action, *what))


@dataclass(frozen=True)
class MockFmu(DeclaredFmu):
    """What an FMU's files would say of a mock."""

    made: list[Model] = field(default_factory=list)  # the models of its instances, to look at what they were told


def mock_fmu(
    name: str, model: Callable[[Mapping[str, float]], Model] = Model, inputs: Iterable[str] = (),
    outputs: Iterable[str] = (), parameters: Mapping[str, float] | None = None,
    feedthrough: Mapping[str, Iterable[str]] | None = None,
) -> MockFmu:  # fmt: skip
    """Of Real variables that start with 0; `feedthrough`: for an output the inputs that act on it at once."""
    variables = [
        *(Declared(v, "input") for v in inputs), *(Declared(v, "output") for v in outputs),
        *(Declared(v, "parameter", start=float(start)) for v, start in (parameters or {}).items()),
    ]  # fmt: skip
    made: list[Model] = []

    def noted(starts: Mapping[str, float]) -> Model:
        made.append(model(starts))
        return made[-1]

    found = declared_fmu(
        name, variables, Path(f"{name}.mock"), "mock", model=noted, feedthrough=feedthrough, writes=False, kind=MockFmu
    )
    return replace(found, made=made)  # type: ignore[no-any-return]
