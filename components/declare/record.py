"""Records: the named values that a kernel reads and writes, `p.k_c`, `x.theta_b`, `y.F_z`.

A record class declares its fields once, each with unit and description. Run as plain Python, a record is a small object
over arrays; under Numba and in C the same text is lowered to named scalars and cells of arrays (`lowering/`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar, Literal, get_type_hints

import numpy as np
import numpy.typing as npt

INF = float("inf")
if TYPE_CHECKING:  # arrays, tuples of parameters and packed records alike
    Vector = Any
    Matrix = Any
else:
    Vector = npt.NDArray[np.float64]  # one-dimensional
    Matrix = npt.NDArray[np.float64]  # two-dimensional
Shape = int | tuple[int, ...]
Role = Literal["input", "output", "calculatedParameter", "parameter", "value"]


@dataclasses.dataclass(frozen=True)
class Field:
    """One field of a record. `shape` 0 is a scalar; it may follow from the parameters.

    `kind`: float, int, bool or a record.
    """

    role: Role
    unit: str
    description: str
    shape: Shape | Callable[[Any], Shape] = 0
    start: float = 0.0
    minimum: float = -INF
    maximum: float = INF
    depends: tuple[str, ...] = ()
    sampled: bool = False
    shown: bool = False
    begins: str = ""  # with this field: another name for it and what follows
    name: str = ""
    kind: type[Any] = float

    @property
    def is_record(self) -> bool:
        """Is the field a record of its own?"""
        return hasattr(self.kind, "packed")

    @property
    def is_array(self) -> bool:
        """Is the field an array?"""
        return self.shape != 0

    @property
    def size(self) -> int:
        """Number of cells; only for a shape that does not follow from parameters."""
        assert not callable(self.shape)
        return int(np.prod(self.shape)) if self.shape else 1


def input_(
    unit: str,
    description: str,
    start: float = 0.0,
    size: int = 0,
    minimum: float = -INF,
    maximum: float = INF,
    sampled: bool = False,
) -> Any:
    """An input; it keeps its value over a communication step. `sampled`: only its value at the samples counts."""
    return Field("input", unit, description, size, start, minimum, maximum, sampled=sampled)


def output(unit: str, description: str, depends: tuple[str, ...] = (), size: int = 0, sampled: bool = False) -> Any:
    """An output; `depends` names the inputs that act on it at once (direct feedthrough)."""
    return Field("output", unit, description, size, depends=depends, sampled=sampled)


def calculated(unit: str, description: str, size: int = 0) -> Any:
    """A calculated parameter: follows from the parameters when initialization ends, constant from then on."""
    return Field("calculatedParameter", unit, description, size)


def value(
    unit: str, description: str, shape: Shape | Callable[[Any], Shape] = 0, shown: bool = False
) -> Any:
    """A value of a state, of scratch or of what a function returns; `shape` may follow from the parameters.

    `shown`: of a vector; an FMU can be built with its first elements as an output.
    """
    return Field("value", unit, description, shape, shown=shown)


def overlay(unit: str, description: str, begins: str, size: int) -> Any:
    """In a packed record: a name for fields that lie side by side, `size` values from the field `begins` on."""
    return Field("value", unit, description, size, begins=begins)


class Record:
    """Base of all records. Scalars share one array of cells, in order; each array is one of its own."""

    packed: ClassVar[bool] = False
    _cells: Any

    def __init__(self, *values: Any, **named: Any) -> None:
        names = list(fields_of(type(self)))
        given = [*zip(names, values, strict=False), *named.items()]
        if [name for name, _ in given] != names:
            raise TypeError(f"{type(self).__name__} is made of {', '.join(names)}, in this order")
        for name, one in given:
            object.__setattr__(self, name, one)

    def __setattr__(self, name: str, one: Any) -> None:
        if name not in fields_of(type(self)):
            raise AttributeError(f"{type(self).__name__} has no field {name}")
        object.__setattr__(self, name, one)


class Packed(Record):
    """A record of one array: its arrays, of fixed size, lie between the scalars. It can be passed as a `Vector`."""

    packed = True

    def __getitem__(self, k: int) -> float:
        return float(self._cells[k])

    def __setitem__(self, k: int, one: float) -> None:
        self._cells[k] = one

    def __len__(self) -> int:
        return len(self._cells)


class Rows(Packed):
    """A packed record as a matrix: each of its arrays, all of one size, is a row; scalars fill further rows.

    In hot code that is faster than one vector: the index of an element needs no sum.
    """

    rows = True


_FIELDS: dict[type[Any], dict[str, Field]] = {}


def fields_of(record: type[Any]) -> dict[str, Field]:
    """The fields of a record class, or of a `Parameters` dataclass, by name."""
    if record not in _FIELDS:
        _FIELDS[record] = _fields(record)
    return _FIELDS[record]


def _fields(record: type[Any]) -> dict[str, Field]:
    if dataclasses.is_dataclass(record):
        return {f.name: _of_parameter(f) for f in dataclasses.fields(record)}
    found: dict[str, Field] = {}
    hints = get_type_hints(record)
    for name, one in [item for base in reversed(record.__mro__) for item in vars(base).items()]:
        if hasattr(one, "role"):
            kind = hints[name] if hints[name] in (float, int, bool) or hasattr(hints[name], "packed") else float
            found[name] = dataclasses.replace(one, name=name, kind=kind)
    return found


def _of_parameter(f: dataclasses.Field[Any]) -> Field:
    default = f.default
    known = {key: f.metadata[key] for key in ("unit", "description", "minimum", "maximum")}
    kind = bool if isinstance(default, bool) else int if isinstance(default, int) else float
    return Field("parameter", name=f.name, kind=kind, shape=len(default) if isinstance(default, tuple) else 0, **known)
