"""What is called in a kernel, and of which kind expressions are, as far as that is known before their text is."""

from __future__ import annotations

import ast
import math
from typing import Any

from .arithmetic import ROUNDED
from .kinds import BOOL, FLOAT, INT, UnknownError, constant, joined, returned


class Calls:
    """What the names in a function stand for."""

    def __init__(self, functions: dict[str, ast.FunctionDef], namespace: dict[str, Any]) -> None:
        """`functions`: those of the kernel; `namespace`: its constants, and what it has of `math`."""
        self.functions, self.namespace = functions, namespace
        self.local: set[str] = set()  # names that the function writes to

    def kind_of(self, node: ast.expr, known: dict[str, str]) -> str:
        """The kind of a scalar expression, or nothing while the kinds of its names are not known."""
        if isinstance(node, ast.Constant):
            return constant(node.value).kind
        if isinstance(node, ast.Name):
            outside = node.id not in self.local and node.id in self.namespace
            return known.get(node.id) or (constant(self.namespace[node.id]).kind if outside else "")
        if isinstance(node, ast.Subscript):
            return FLOAT
        if isinstance(node, ast.Compare | ast.BoolOp):
            return BOOL
        if isinstance(node, ast.UnaryOp):
            return BOOL if isinstance(node.op, ast.Not) else self.kind_of(node.operand, known)
        if isinstance(node, ast.IfExp):
            return joined(self.kind_of(node.body, known), self.kind_of(node.orelse, known))
        if isinstance(node, ast.BinOp):
            one, other = self.kind_of(node.left, known), self.kind_of(node.right, known)
            return FLOAT if isinstance(node.op, ast.Div) or FLOAT in (one, other) else joined(one, other)
        if isinstance(node, ast.Call):
            return self._kind_of_call(node, known)
        raise UnknownError(ast.unparse(node))

    def _kind_of_call(self, node: ast.Call, known: dict[str, str]) -> str:
        name = self.called(node)
        if name in self.functions:
            kinds = returned(self.functions[name])
            return kinds[0] if len(kinds) == 1 else ""
        if name in ("int", *ROUNDED):
            return INT
        if name in ("min", "max", "abs"):
            kind = ""
            for argument in node.args:
                kind = joined(kind, self.kind_of(argument, known))
            return kind
        return BOOL if name == "bool" else FLOAT

    def kinds_of_call(self, node: ast.expr) -> tuple[str, ...]:
        """What a function of the kernel returns."""
        if isinstance(node, ast.Call) and self.called(node) in self.functions:
            return returned(self.functions[self.called(node)])
        raise UnknownError(ast.unparse(node))

    def called(self, node: ast.Call) -> str:
        """The function of a call: of the kernel, a built-in one, or of `math`, by the name it has there."""
        if not isinstance(node.func, ast.Name) or node.keywords:
            raise UnknownError(ast.unparse(node))
        name = node.func.id
        given = self.namespace.get(name)
        if name not in self.functions and given is not None:
            own = str(getattr(given, "__name__", ""))
            if getattr(math, own, None) is not given:
                raise UnknownError(ast.unparse(node))
            return own
        return name
