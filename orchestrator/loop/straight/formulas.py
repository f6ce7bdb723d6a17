"""A formula of `loop/formulas.py` as LLVM's text."""

from __future__ import annotations

import ast
import struct
from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..formulas import parsed

if TYPE_CHECKING:
    from .writer import Writer

OPERATORS = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul"}


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

    for line in parsed(code):
        (target,), found = line.targets, value(line.value)
        if isinstance(target, ast.Subscript):
            to.store("double", found, place(target))
        else:
            assert isinstance(target, ast.Name)
            known[target.id] = found


def literal(number: float) -> str:
    """A double for LLVM, with all its bits."""
    return f"0x{struct.unpack('>Q', struct.pack('>d', number))[0]:016X}"
