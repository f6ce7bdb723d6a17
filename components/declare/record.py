"""Records: the named values that a kernel reads and writes, `p.k_c`, `x.theta_b`, `y.F_z`.

A record class declares its fields once, each with unit and description. Run as plain Python, a record is a small object
over arrays; under Numba and in C the same text is lowered to named scalars and cells of arrays (`lowering/`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping
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
_VIEWS: dict[type[Any], type[Any]] = {}


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


def width(record: type[Any]) -> int:
    """Length of the rows of a record that lies in a matrix, else 0."""
    if getattr(record, "rows", False) is not True:  # a field may be called so
        return 0
    return max(field.size for field in fields_of(record).values())


def cells_of(record: type[Any]) -> dict[str, int]:
    """Where the fields that share the record's array of cells begin in it."""
    places: dict[str, int] = {}
    packed = getattr(record, "packed", False)  # parameters are not
    at = 0
    for name, field in fields_of(record).items():
        if field.is_record or (field.is_array and not packed):
            continue
        if field.is_array and width(record):
            at = -(-at // width(record)) * width(record)  # begins a row
        places[name] = places[field.begins] if field.begins else at
        at += 0 if field.begins else field.size
    return places


class _Ones:
    """Parameters that are all 1."""

    def __getattr__(self, name: str) -> int:
        return 1


def dimensions(field: Field) -> int:
    """0 for a scalar, 1 or 2 for an array."""
    shape = field.shape(_Ones()) if callable(field.shape) else field.shape
    return len(shape) if isinstance(shape, tuple) else int(shape != 0)


def cell_count(record: type[Any]) -> int:
    """Length of the record's array of cells."""
    fields = fields_of(record)
    count = max((at + fields[name].size for name, at in cells_of(record).items()), default=0)
    return -(-count // width(record)) * width(record) if width(record) else count


def cells_shape(record: type[Any]) -> Shape:
    """Shape of the record's array of cells."""
    count, columns = cell_count(record), width(record)
    return (count // columns, columns) if columns else count


def storage(
    record: type[Record], name: str, before: str = ""
) -> Iterator[tuple[str, Shape | Callable[[Any], Shape], Field | None]]:
    """The arrays that a record lies in: name, shape, and the field if it is one's own.

    `name`: that of the cells; `before`: what the others' names begin with, `now_` for those of a record `now`.
    """
    if cells_of(record):
        yield name, cells_shape(record), None
    for key, field in fields_of(record).items():
        if field.is_record:
            yield from ((inner, shape, one) for inner, shape, one in storage(field.kind, key, f"{key}_"))
        elif field.is_array and not record.packed:
            yield before + key, field.shape, field


def cells_name(record: type[Any]) -> str:
    """The name of the array that a record's scalars share: `y` for outputs, else as the class."""
    outputs = any(f.role in ("output", "calculatedParameter") for f in fields_of(record).values())
    return "y" if outputs else record.__name__.lower()


def over(record: type[Record], cells: Any, arrays: Mapping[str, Any]) -> Any:
    """A record as an object over its cells and arrays, for plain Python."""
    if record not in _VIEWS:
        _VIEWS[record] = _view(record)
    return _VIEWS[record](cells, arrays)


def _view(record: type[Record]) -> type[Any]:
    """A subclass of the record whose scalars are properties over the cells."""
    fields, places = fields_of(record), cells_of(record)

    def fill(self: Any, cells: Any, arrays: Mapping[str, Any]) -> None:
        cells = cells if cells is None else cells.reshape(-1)
        object.__setattr__(self, "_cells", cells)
        for name, field in fields.items():
            if field.is_record:
                inner = {key: arrays[f"{name}_{key}"] for key in fields_of(field.kind) if f"{name}_{key}" in arrays}
                object.__setattr__(self, name, over(field.kind, arrays.get(name), inner))
            elif field.is_array:
                whole = arrays[name] if name not in places else cells[places[name] : places[name] + field.size]
                object.__setattr__(self, name, whole.reshape(field.shape) if name in places else whole)

    members: dict[str, Any] = {"__init__": fill, "__module__": record.__module__}
    members |= {name: _cell(places[name]) for name in places if not fields[name].is_array}
    return type(record.__name__, (record,), members)


def _cell(k: int) -> property:
    def put(self: Any, one: float) -> None:
        self._cells[k] = one

    return property(lambda self: float(self._cells[k]), put)
