"""One declaration per variable of a component: name, unit, causality, start, range, description, source.

The declaration is all that the Python FMU (`slave.py`), its XML and the tests need to know about a component.
FMI 2.0 has no arrays, so a variable of size k appears in the XML as k scalars `name[1]` .. `name[k]`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

Causality = Literal["parameter", "calculatedParameter", "input", "output"]
Kind = Literal["Real", "Integer", "Boolean"]
Shape = int | tuple[int, ...]
INF = float("inf")


@dataclass(frozen=True)
class Variable:
    """One variable of a component's interface. `size` 0 is a scalar; `start` has one value per element."""

    name: str
    unit: str
    causality: Causality
    description: str
    start: tuple[float, ...] = (0.0,)
    minimum: float = -INF
    maximum: float = INF
    size: int = 0
    kind: Kind = "Real"
    source: str = ""
    depends: tuple[str, ...] = ()  # inputs with direct feedthrough to this output
    sampled: bool = False  # matters or changes at samples only (FMI variability `discrete`)
    tunable: bool = False  # a parameter that may change between two steps: nothing is derived from it at the start
    usual: bool = False  # a parameter that mostly is what it starts with: `step` is compiled for that value as well

    @property
    def element_names(self) -> list[str]:
        """Names of the FMI scalars: the name itself, or name[1] .. name[size]."""
        return [f"{self.name}[{k + 1}]" for k in range(self.size)] if self.size else [self.name]


@dataclass(frozen=True)
class Array:
    """A float array that a kernel works on; `shape` is a constant or follows from the parameters.

    `scratch` arrays carry nothing from one call to the next and are left out of the FMU state. `shown` declares, for
    a vector, the output that shows its first elements where an FMU is built with some.
    """

    name: str
    shape: Shape | Callable[[Any], Shape]
    scratch: bool = False
    shown: Variable | None = None

    def row_output(self, rows: int) -> tuple[Variable, ...]:
        """The output of size `rows` that shows it, if there is one and `rows` is not 0."""
        return (dataclasses.replace(self.shown, size=rows, start=(0.0,) * rows),) if self.shown and rows else ()

    def shape_for(self, parameters: Any) -> Shape:
        """The shape in an instance with these parameters (of the component's `Parameters`)."""
        return self.shape(parameters) if callable(self.shape) else self.shape


def parameter(
    default: float | bool | tuple[float, ...],
    unit: str,
    description: str,
    source: str,
    minimum: float = -INF,
    maximum: float = INF,
) -> Any:
    """Field of a frozen `Parameters` dataclass, with its unit, its source and its admissible range."""
    metadata = {"unit": unit, "description": description, "source": source, "minimum": minimum, "maximum": maximum}
    return dataclasses.field(default=default, metadata=metadata)


def tunable(*declared: Any, **named: Any) -> Any:
    """As `parameter`, of one that may be set between two steps too, and counts from the next one on: setup derives
    nothing from it."""
    field = parameter(*declared, **named)
    return dataclasses.field(default=field.default, metadata={**field.metadata, "tunable": True})


def usual(*declared: Any, **named: Any) -> Any:
    """As `parameter`, of one that is mostly left as it is: what it decides is decided when `step` is compiled, for an
    instance in which all such parameters have their start values. The bits are the same; where one has another value,
    `step` is compiled for all values when such an instance is first met."""
    field = parameter(*declared, **named)
    return dataclasses.field(default=field.default, metadata={**field.metadata, "usual": True})


def parameter_variables(parameters: type[Any]) -> tuple[Variable, ...]:
    """The declarations of a `Parameters` dataclass, in the order of its fields."""
    return tuple(_parameter_variable(f) for f in dataclasses.fields(parameters))


def _parameter_variable(field: dataclasses.Field[Any]) -> Variable:
    default = field.default
    values = default if isinstance(default, tuple) else (default,)
    kind: Kind = "Boolean" if isinstance(default, bool) else "Integer" if isinstance(default, int) else "Real"
    return Variable(
        name=field.name,
        causality="parameter",
        kind=kind,
        start=tuple(float(value) for value in values),
        size=len(default) if isinstance(default, tuple) else 0,
        **field.metadata,
    )


def tunable_places(parameters: type[Any]) -> dict[int, Variable]:
    """The tunable parameters, by the value references of their elements: parameters come first."""
    places = [v for v in parameter_variables(parameters) for _ in v.start]
    return {place: v for place, v in enumerate(places) if v.tunable}
