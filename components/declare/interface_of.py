"""The interface and the arrays of a component from its records."""

from __future__ import annotations

from ..errors import BuildError
from .interface import Array, Variable
from .layout import cells_name, storage
from .record import Field, Record, fields_of


def variables_of(record: type[Record]) -> tuple[Variable, ...]:
    """The variables that a record of inputs or of outputs declares, in order."""
    return tuple(_variable(field) for field in fields_of(record).values())


def _variable(f: Field) -> Variable:
    assert not callable(f.shape) and not isinstance(f.shape, tuple)
    assert f.role in ("input", "output", "calculatedParameter")
    return Variable(
        f.name, f.unit, f.role, f.description, (f.start,) * f.size, f.minimum, f.maximum, f.shape,
        depends=f.depends, sampled=f.sampled,
    )  # fmt: skip


def _shown(name: str, f: Field) -> Variable:
    return Variable(name, f.unit, "output", f.description)


def arrays_of(state: type[Record], scratch: type[Record] | None = None) -> tuple[Array, ...]:
    """The arrays that state and scratch lie in. Raises BuildError where two would have one name."""
    found: list[Array] = []
    for record, is_scratch in ((state, False), (scratch, True)):
        if record is not None:
            found += [
                Array(name, shape, is_scratch, _shown(name, field) if field and field.shown else None)
                for name, shape, field in storage(record, cells_name(record))
            ]
    names = [array.name for array in found]
    for name in names:
        if names.count(name) > 1:
            raise BuildError(f"state and scratch of {state.__module__} both have an array '{name}'")
    return tuple(found)
