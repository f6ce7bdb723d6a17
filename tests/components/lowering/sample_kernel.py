"""Kernels as text: records for them, and a text in its lowered and in its plain form."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from textwrap import dedent
from typing import Any

import numpy as np
from rovbrush.components.declare.interface import parameter
from rovbrush.components.declare.interface_of import arrays_of
from rovbrush.components.declare.layout import cell_count, cells_name, over
from rovbrush.components.declare.record import (
    Matrix,
    Packed,
    Record,
    Rows,
    Vector,
    fields_of,
    input_,
    output,
    value,
)
from rovbrush.components.lowering.lower import lower
from rovbrush.components.lowering.lowered import Lowered
from rovbrush.components.lowering.source import Source

PATH = Path("somewhere/kernel.py")


@dataclasses.dataclass(frozen=True)
class Parameters:
    k: float = parameter(2.0, "1", "a factor", "assumed")
    n: int = parameter(3, "1", "a count", "assumed")
    on: bool = parameter(True, "1", "a choice", "assumed")
    zeta: tuple[float, ...] = parameter((0.1, 0.2, 0.3), "1", "an array", "assumed")


class Inputs(Record):
    u_1: float = input_("1", "a scalar", start=1.0)
    v: Vector = input_("1", "an array", size=3)


class Outputs(Packed):
    first: float = output("1", "a scalar")
    three: Vector = output("1", "an array", size=3)
    last: float = output("1", "behind it")


class Tip(Packed):
    F_n: float = value("N", "a scalar")
    r: Vector = value("m", "an array inside", 3)
    A: Matrix = value("m", "a matrix inside", (2, 3))
    moment: float = value("N.m", "behind them")


class Table(Rows):
    first: Vector = value("1", "a row", 4)
    second: Vector = value("1", "another", 4)
    alone: float = value("1", "a scalar in a further row")


class State(Record):
    a: float = value("1", "a scalar")
    eta: Matrix = value("1", "as many rows as n", lambda p: (p.n, 2))
    b: float = value("1", "another")
    tip: Tip = value("", "a record in it")
    rows: Table = value("", "a record of rows")


class Scratch(Record):
    work: Vector = value("1", "an array of its own", 4)
    spare: Tip = value("", "another record")


class Rates(Record):
    da: float = value("1/s", "a rate")
    db: float = value("1/s", "another")


class Counted(Record):
    count: int = value("1", "a whole number")
    yes: bool = value("1", "a truth")


RECORDS = {one.__name__: one for one in (Parameters, Inputs, Outputs, Tip, Table, State, Scratch, Rates, Counted)}
TYPES = {**RECORDS, "Vector": Vector, "Matrix": Matrix}


def lower_text(text: str) -> Lowered:
    """A kernel's text, lowered with the records above."""
    return lower([Source(PATH, dedent(text))], TYPES)


def plain(text: str) -> dict[str, Any]:
    """The functions of a text as plain Python runs them."""
    functions: dict[str, Any] = dict(TYPES)
    exec(dedent(text), functions)
    return functions


class Arguments:
    """Values for everything that `step` may be given, for plain Python as records, for the lowered text as arrays."""

    def __init__(self) -> None:
        self.p = Parameters()
        self.u = {"u_1": 0.7, "v": np.array([1.5, -2.0, 0.25])}
        self.arrays = {
            a.name: np.linspace(0.1, 0.9, int(np.prod(a.shape_for(self.p)))) for a in arrays_of(State, Scratch)
        }
        self.arrays = {a.name: self.arrays[a.name].reshape(a.shape_for(self.p)) for a in arrays_of(State, Scratch)}
        self.arrays["y"] = np.zeros(cell_count(Outputs))

    def records(self) -> dict[str, Any]:
        """By the names of parameters in the texts."""
        kept = {key: over(r, self.arrays.get(cells_name(r)), self.arrays) for key, r in KEPT.items()}
        return {"h": 0.5, "p": self.p, "u": Inputs(*self.u.values()), **kept}

    def named(self) -> dict[str, Any]:
        """By the names in `Lowered.arguments`."""
        given = {"h": 0.5, **self.u, **self.arrays}
        for name, field in fields_of(Parameters).items():
            given[name] = np.array(getattr(self.p, name)) if field.is_array else getattr(self.p, name)
        return given


KEPT: dict[str, type[Record]] = {"x": State, "y": Outputs, "s": Scratch}
