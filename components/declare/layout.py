"""Where the fields of a record lie: in the cells that they share, or in arrays of their own; and a record over them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from .record import Field, Record, Shape, fields_of

_VIEWS: dict[type[Any], type[Any]] = {}
_CELLS: dict[type[Any], dict[str, int]] = {}


def width(record: type[Any]) -> int:
    """Length of the rows of a record that lies in a matrix, else 0."""
    if getattr(record, "rows", False) is not True:  # a field may be called so
        return 0
    return max(field.size for field in fields_of(record).values())


def cells_of(record: type[Any]) -> dict[str, int]:
    """Where the fields that share the record's array of cells begin in it."""
    if record not in _CELLS:
        _CELLS[record] = _cells_of(record)
    return _CELLS[record]


def _cells_of(record: type[Any]) -> dict[str, int]:
    places: dict[str, int] = {}
    packed, columns = getattr(record, "packed", False), width(record)  # parameters are not packed
    at = 0
    for name, field in fields_of(record).items():
        if field.is_record or (field.is_array and not packed):
            continue
        if field.is_array and columns:
            at = -(-at // columns) * columns  # begins a row
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
