"""How a cell of a record is written: by its number for Numba, by its name for C."""

from __future__ import annotations

from typing import Any

from ..declare.layout import cells_of, width


class Cells:
    """By number: `x[3]`, and `m[1, r]` in a record of rows."""

    def in_rows(self, record: type[Any]) -> bool:
        """Are the cells a matrix here?"""
        return bool(width(record))

    def annotation(self, record: type[Any]) -> str:
        """The annotation of a record's cells."""
        return "'float[:,:]'" if self.in_rows(record) else "'float[:]'"

    def first(self, record: type[Any], key: str, behind: int = 0) -> str:
        """The index of a field's first cell, or of one behind it."""
        return str(cells_of(record)[key] + behind)

    def before(self, record: type[Any], key: str) -> str:
        """What stands before an index that counts from a field's first cell."""
        return f"{self.first(record, key)} + " if cells_of(record)[key] else ""

    def scalar(self, name: str, record: type[Any], key: str) -> str:
        """A scalar among the cells."""
        at, columns = cells_of(record)[key], width(record)
        return f"{name}[{at // columns}, {at % columns}]" if columns else f"{name}[{at}]"


class NamedCells(Cells):
    """By name: `x[State_theta_b]`, `z[Motion_v + i]`; rows lie one behind the other. `records`: those that occur."""

    def __init__(self) -> None:
        self.records: dict[str, type[Any]] = {}

    def in_rows(self, record: type[Any]) -> bool:
        """All cells are one vector."""
        return False

    def first(self, record: type[Any], key: str, behind: int = 0) -> str:
        """The name of a field's first cell."""
        self.records[record.__name__] = record
        return f"{record.__name__}_{key}" + f" + {behind}" * bool(behind)

    def before(self, record: type[Any], key: str) -> str:
        """The name is said even where it is 0."""
        return f"{self.first(record, key)} + "

    def scalar(self, name: str, record: type[Any], key: str) -> str:
        """A scalar among the cells."""
        return f"{name}[{self.first(record, key)}]"
