"""A formula of `loop/formulas.py` as lines of C."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping

from ....loop.formulas import parsed
from ..exchange import indented
from ..names import number

SIGNS = {ast.Add: ("+", 1), ast.Sub: ("-", 1), ast.Mult: ("*", 2)}  # how tight they bind


def in_c(code: int, cell: Callable[[str], str], coefficients: Mapping[int, str], n: str = "") -> list[str]:
    """The lines of an operation, in the order of its arithmetic.

    `cell`: a cell by the column that names it; `n`: the whole number that it takes, as a double.
    """

    def place(node: ast.expr) -> str:
        assert isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name)
        if node.value.id == "c":
            assert isinstance(node.slice, ast.Constant) and isinstance(node.slice.value, int)
            return coefficients[node.slice.value]
        assert isinstance(node.slice, ast.Name)
        return cell(node.slice.id)

    def value(node: ast.expr, tighter_than: int = 0) -> str:
        """Its text, in brackets where what is around it binds as tight or tighter."""
        if isinstance(node, ast.BinOp):
            sign, tight = SIGNS[type(node.op)]
            text = f"{value(node.left, tight - 1)} {sign} {value(node.right, tight)}"
            return f"({text})" if tight <= tighter_than else text
        if isinstance(node, ast.UnaryOp):
            return f"-{value(node.operand, 3)}"
        if isinstance(node, ast.Constant):
            assert isinstance(node.value, float)
            return number(node.value)
        if isinstance(node, ast.Name):
            return n if node.id == "n" else node.id
        return place(node)

    lines: list[str] = []
    named = False
    for line in parsed(code):
        (target,), found = line.targets, line.value
        if isinstance(target, ast.Name):
            named = True
            lines.append(f"const double {target.id} = {value(found)};")
            continue
        to = place(target)
        if isinstance(found, ast.BinOp) and isinstance(found.op, ast.Add) and ast.dump(found.left) == _read(target):
            lines.append(f"{to} += {value(found.right)};")
        else:
            lines.append(f"{to} = {value(found)};")
    return ["{", *indented(lines), "}"] if named else lines


def _read(target: ast.expr) -> str:
    """A cell that is written, as it is where it is read."""
    assert isinstance(target, ast.Subscript)
    return ast.dump(ast.Subscript(target.value, target.slice, ast.Load()))
