"""Operations on cells as formulas, and such a formula as LLVM's text.

`z[a]`...: cells by the columns of an operation; `c[0]`...: coefficients, of which column k is the first; `n`: the whole
number in cell a. Each line is that of `run.run`: the same arithmetic in the same order.
"""

from __future__ import annotations

import ast
import struct
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING

from ..operations import (
    ACCUMULATE,
    COPY,
    LEDGER,
    LINEAR,
    MEAN,
    MIX,
    MOVE,
    NUMBER,
    PUSH,
    QUADRATIC,
    RISE,
    WORK,
)

if TYPE_CHECKING:
    from .writer import Writer

FORMULAS = {
    COPY: "z[b] = c[0] * z[a] + c[1]",
    MOVE: "z[b] = z[a]",
    PUSH: "z[b] = z[a]",
    LINEAR: "z[b] = c[0] * (z[a] + c[2] * (z[a] - z[p])) + c[1]",
    ACCUMULATE: "z[b] = z[b] + c[0] * (z[p] + z[a])",
    RISE: "z[b] = z[b] + c[0] * (z[a] - z[p])",
    MEAN: "tail = c[2] * z[a] + c[3] * z[p]; z[b] = c[0] * (z[q] + tail) + c[1]; z[q] = -tail",
    NUMBER: "z[b] = c[0] * n + c[1]",
    WORK: "z[b] = z[b] + z[q] * (c[0] * z[p] + c[1] * z[a]) * c[2]",
    LEDGER: "total = z[a] - z[p]; z[b] = total - z[q]; z[q] = total",
    QUADRATIC: "slope = z[a] - z[p]; curvature = z[a] - 2.0 * z[p] + z[q]; "
    "value = z[a] + c[2] * slope + c[3] * curvature; z[b] = c[0] * value + c[1]",
    MIX: "value = c[0] * z[b] + c[1] * z[a]; z[b] = value + c[2] * z[p] + c[3]",
}
OPERATORS = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul"}


@cache
def _parsed(code: int) -> list[ast.stmt]:
    return ast.parse(FORMULAS[code]).body


def write_formula(to: Writer, code: int, columns: Mapping[str, int], first: int) -> None:
    """The lines of an operation; `columns`: cells by their names in the formula, `first`: of its coefficients."""
    known: dict[str, str] = {}

    def value(node: ast.expr) -> str:
        if isinstance(node, ast.BinOp):
            left, right = value(node.left), value(node.right)
            return to.value(f"{OPERATORS[type(node.op)]} double {left}, {right}")
        if isinstance(node, ast.UnaryOp):
            return to.value(f"fneg double {value(node.operand)}")
        if isinstance(node, ast.Constant):
            assert isinstance(node.value, float)
            return literal(node.value)
        if isinstance(node, ast.Subscript):
            return to.load("double", place(node))
        assert isinstance(node, ast.Name)
        if node.id == "n":
            unsigned = "ui" if columns["p"] else "si"
            return to.value(f"{unsigned}tofp i64 {to.load('i64', to.cell(columns['a']))} to double")
        return known[node.id]

    def place(node: ast.Subscript) -> str:
        assert isinstance(node.value, ast.Name)
        if node.value.id == "c":
            assert isinstance(node.slice, ast.Constant) and isinstance(node.slice.value, int)
            return to.place("c", first + node.slice.value)
        assert isinstance(node.slice, ast.Name)
        return to.cell(columns[node.slice.id])

    for line in _parsed(code):
        assert isinstance(line, ast.Assign)
        (target,), found = line.targets, value(line.value)
        if isinstance(target, ast.Subscript):
            to.store("double", found, place(target))
        else:
            assert isinstance(target, ast.Name)
            known[target.id] = found


def literal(number: float) -> str:
    """A double for LLVM, with all its bits."""
    return f"0x{struct.unpack('>Q', struct.pack('>d', number))[0]:016X}"
