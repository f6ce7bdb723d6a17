"""Expressions of signals, such as `-abs(drive.w - 30) - 0.01 * time`, as functions of no argument.

Names, numbers, arithmetic (`+ - * / // % **`), comparisons, `abs`, `min`, `max`, `exp`, `and`, `or`, `not`:
nothing else is read, and nothing is evaluated as Python.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable
from functools import reduce

from ..errors import InputError, RunError

Reader = Callable[[], float]
BINARY: dict[type[ast.AST], Callable[[float, float], float]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod, ast.Pow: math.pow,
}  # fmt: skip
UNARY: dict[type[ast.AST], Callable[[float], float]] = {ast.USub: operator.neg, ast.UAdd: operator.pos,
                                                        ast.Not: operator.not_}  # fmt: skip
COMPARED: dict[type[ast.AST], Callable[[float, float], bool]] = {
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge, ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}  # fmt: skip
FUNCTIONS: dict[str, tuple[int, int]] = {"abs": (1, 1), "exp": (1, 1), "min": (2, 99), "max": (2, 99)}  # arguments
LONGEST, DEEPEST = 2000, 50


class Expression:
    """An expression that was read; `reader` gives what reads a signal by its full name, and refuses unknown ones.

    Raises InputError that says where it cannot be read.
    """

    def __init__(self, text: str, what: str, reader: Callable[[str], Reader]) -> None:
        self.text, self.what, self._reader = text, what, reader
        if len(text) > LONGEST:
            raise InputError(f"{what}: the expression has {len(text)} characters; {LONGEST} are allowed")
        try:
            body = ast.parse(text.strip(), mode="eval").body
        except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
            column = getattr(error, "offset", 0) or len(text.strip()) + 1  # 0 where the text ends too early
            raise InputError(f"{what} = {text!r}, column {column}: {getattr(error, 'msg', error)}") from None
        self._value = self._read(body, 0)

    def __call__(self) -> float:
        """Its value now. Raises RunError where it has none."""
        try:
            return float(self._value())
        except (ArithmeticError, ValueError) as error:
            raise RunError(f"{self.what} = {self.text!r} has no value: {error}") from error

    def _refuse(self, node: ast.AST, why: str) -> InputError:
        return InputError(f"{self.what} = {self.text!r}, column {getattr(node, 'col_offset', 0) + 1}: {why}")

    def _read(self, node: ast.expr, depth: int) -> Reader:
        if depth > DEEPEST:
            raise self._refuse(node, f"it is nested deeper than {DEEPEST}")

        def of(part: ast.expr) -> Reader:
            return self._read(part, depth + 1)

        if isinstance(node, ast.Constant) and type(node.value) in (int, float, bool):
            number = float(node.value)  # type: ignore[arg-type]
            return lambda: number
        if isinstance(node, (ast.Name, ast.Attribute, ast.Subscript)):
            return self._signal(node)
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY:
            act, left, right = BINARY[type(node.op)], of(node.left), of(node.right)
            return lambda: act(left(), right())
        if isinstance(node, ast.UnaryOp) and type(node.op) in UNARY:
            turn, inner = UNARY[type(node.op)], of(node.operand)
            return lambda: turn(inner())
        if isinstance(node, ast.BoolOp):
            parts = [of(value) for value in node.values]
            if isinstance(node.op, ast.And):
                return lambda: all(part() for part in parts)
            return lambda: any(part() for part in parts)
        if isinstance(node, ast.Compare) and all(type(op) in COMPARED for op in node.ops):
            values = [of(value) for value in (node.left, *node.comparators)]
            tests = [COMPARED[type(op)] for op in node.ops]
            return lambda: all(test(values[k](), values[k + 1]()) for k, test in enumerate(tests))
        if isinstance(node, ast.Call):
            return self._call(node, of)
        raise self._refuse(
            node,
            f"`{ast.unparse(node)}` is not allowed; there are names, numbers, arithmetic, comparisons, "
            f"{', '.join(FUNCTIONS)}, and, or, not",
        )

    def _signal(self, node: ast.expr) -> Reader:
        name, inner = ast.unparse(node).replace(" ", ""), node
        while isinstance(inner, (ast.Attribute, ast.Subscript)):
            inner = inner.value
        if not isinstance(inner, ast.Name):
            raise self._refuse(node, f"`{name}` is the name of no signal")
        try:
            return self._reader(name)
        except InputError as error:
            raise self._refuse(node, str(error)) from None

    def _call(self, node: ast.Call, of: Callable[[ast.expr], Reader]) -> Reader:
        name = ast.unparse(node.func)
        if name not in FUNCTIONS or node.keywords or any(isinstance(a, ast.Starred) for a in node.args):
            raise self._refuse(node, f"`{name}` cannot be called; there are {', '.join(FUNCTIONS)}")
        least, most = FUNCTIONS[name]
        if not least <= len(node.args) <= most:
            raise self._refuse(node, f"{name} takes {least if least == most else f'{least} or more'} arguments")
        parts = [of(argument) for argument in node.args]
        if name in ("abs", "exp"):
            one, part = (abs if name == "abs" else math.exp), parts[0]
            return lambda: one(part())
        choose = min if name == "min" else max
        return lambda: reduce(choose, [part() for part in parts])
