"""Expressions as LLVM's text."""

from __future__ import annotations

import ast
from typing import Any

from .arithmetic import ROUNDED, Arithmetic
from .calls import Calls
from .kinds import (
    BOOL,
    DIMENSIONS,
    FLOAT,
    INT,
    OF_ANNOTATION,
    Array,
    Number,
    UnknownError,
    annotation,
    constant,
    joined,
    returned,
)
from .text import result_type

INTRINSICS = {name: f"llvm.{name}.f64" for name in ("exp", "log", "log10", "log2", "sin", "cos", "sqrt", "fabs")}
EXTERNALS = ("tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "log1p", "expm1", "erf",
             "erfc", "atan2")  # fmt: skip
COMPARED = {
    ast.Lt: ("olt", "slt"), ast.LtE: ("ole", "sle"), ast.Gt: ("ogt", "sgt"), ast.GtE: ("oge", "sge"),
    ast.Eq: ("oeq", "eq"), ast.NotEq: ("une", "ne"),
}  # fmt: skip


class Expressions(Calls, Arithmetic):
    """The text of one function so far, and what its names are."""

    def __init__(self, functions: dict[str, ast.FunctionDef], namespace: dict[str, Any], externals: set[str]) -> None:
        Calls.__init__(self, functions, namespace)
        Arithmetic.__init__(self, externals)
        self.kinds: dict[str, str] = {}
        self.arrays: dict[str, Array] = {}
        self.counters: set[str] = set()
        self.prefix = "k"  # of the functions that are called

    def value(self, node: ast.expr) -> Number:
        """A scalar expression."""
        if isinstance(node, ast.Constant):
            return constant(node.value)
        if isinstance(node, ast.Name):
            if node.id in self.kinds:
                return Number(self.new(f"load {self.kinds[node.id]}, ptr %v.{node.id}"), self.kinds[node.id])
            if node.id in self.namespace:
                return constant(self.namespace[node.id])
        if isinstance(node, ast.Subscript):
            return Number(self.new(f"load double, ptr {self.place(node)}"), FLOAT)
        if isinstance(node, ast.BinOp):
            return self.arithmetic(node.op, self.value(node.left), self.value(node.right))
        if isinstance(node, ast.UnaryOp):
            return self._unary(node)
        if isinstance(node, ast.Compare):
            return self._compared(node)
        if isinstance(node, ast.BoolOp):
            if any(self.kind_of(one, self.kinds) != BOOL for one in node.values):
                raise UnknownError(ast.unparse(node))
            return self._short(node)
        if isinstance(node, ast.IfExp):
            return self._chosen(node)
        if isinstance(node, ast.Call):
            return self._call(node)
        raise UnknownError(ast.unparse(node))

    def truth(self, node: ast.expr) -> str:
        """An expression as a condition."""
        value = self._short(node) if isinstance(node, ast.BoolOp) else self.value(node)
        return self.condition(value).text

    def _unary(self, node: ast.UnaryOp) -> Number:
        if isinstance(node.op, ast.Not):
            return Number(self.new(f"xor i1 {self.truth(node.operand)}, true"), BOOL)
        value = self.value(node.operand)
        if value.kind == BOOL or not isinstance(node.op, ast.USub):
            raise UnknownError(ast.unparse(node))
        return Number(self.new(f"fneg double {value.text}" if value.kind == FLOAT else f"sub i64 0, {value.text}"),
                      value.kind)  # fmt: skip

    def _compared(self, node: ast.Compare) -> Number:
        if len(node.ops) > 1 and any(isinstance(n, ast.Subscript | ast.Call) for n in ast.walk(node)):
            raise UnknownError(ast.unparse(node))
        values = [self.value(one) for one in (node.left, *node.comparators)]
        result = ""
        for operator, one, other in zip(node.ops, values, values[1:], strict=False):
            if type(operator) not in COMPARED:
                raise UnknownError(ast.unparse(node))
            kind = joined(one.kind, other.kind)
            of_floats, of_ints = COMPARED[type(operator)]
            if kind == BOOL and of_ints not in ("eq", "ne"):
                raise UnknownError(ast.unparse(node))
            how = f"fcmp {of_floats}" if kind == FLOAT else f"icmp {of_ints}"
            text = self.new(f"{how} {kind} {self.as_kind(one, kind)}, {self.as_kind(other, kind)}")
            result = self.new(f"and i1 {result}, {text}") if result else text
        return Number(result, BOOL)

    def _short(self, node: ast.BoolOp) -> Number:
        """`and`, `or`: what stands behind is looked at only where it matters."""
        end, comes = self.label(), []
        for k, one in enumerate(node.values):
            condition = self.truth(one)
            comes.append(f"[ {condition}, %{self.block} ]")
            if k == len(node.values) - 1:
                self.do(f"br label %{end}")
            else:
                ahead = self.label()
                first, second = (ahead, end) if isinstance(node.op, ast.And) else (end, ahead)
                self.do(f"br i1 {condition}, label %{first}, label %{second}")
                self.begin(ahead)
        self.begin(end)
        return Number(self.new(f"phi i1 {', '.join(comes)}"), BOOL)

    def _chosen(self, node: ast.IfExp) -> Number:
        kind = self.kind_of(node, self.kinds)
        yes, no, end = self.label(), self.label(), self.label()
        self.do(f"br i1 {self.truth(node.test)}, label %{yes}, label %{no}")
        comes = []
        for block, one in ((yes, node.body), (no, node.orelse)):
            self.begin(block)
            text = self.as_kind(self.value(one), kind)
            comes.append(f"[ {text}, %{self.block} ]")
            self.do(f"br label %{end}")
        self.begin(end)
        return Number(self.new(f"phi {kind} {', '.join(comes)}"), kind)

    # --- elements of arrays ---

    def place(self, node: ast.Subscript) -> str:
        """The address of an element; an index below zero counts from the end, as Python's does."""
        array = self.array(node.value)
        indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if len(indices) != len(array.sizes):
            raise UnknownError(ast.unparse(node))
        at = ""
        for index, size in zip(indices, array.sizes, strict=True):
            text = self._index(index, size)
            at = self.new(f"add i64 {self.new(f'mul i64 {at}, {size}')}, {text}") if at else text
        return self.new(f"getelementptr double, ptr {array.pointer}, i64 {at}")

    def _index(self, node: ast.expr, size: str) -> str:
        value = self.value(node)
        if value.kind != INT:
            raise UnknownError(f"the index {ast.unparse(node)}")
        if self._not_negative(node):
            return value.text
        below, around = self.new(f"icmp slt i64 {value.text}, 0"), self.new(f"add i64 {value.text}, {size}")
        return self.new(f"select i1 {below}, i64 {around}, i64 {value.text}")

    def _not_negative(self, node: ast.expr) -> bool:
        if isinstance(node, ast.Constant):
            return isinstance(node.value, int) and node.value >= 0
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Mult):
            return self._not_negative(node.left) and self._not_negative(node.right)
        return isinstance(node, ast.Name) and node.id in self.counters

    def array(self, node: ast.expr) -> Array:
        """An array by its name."""
        if isinstance(node, ast.Name) and node.id in self.arrays:
            return self.arrays[node.id]
        raise UnknownError(f"{ast.unparse(node)} as an array")

    # --- calls ---

    def call_own(self, node: ast.Call) -> str:
        """A call of a function of the kernel; the text of what it returns."""
        called = self.functions[self.called(node)]
        if len(node.args) != len(called.args.args):
            raise UnknownError(ast.unparse(node))
        given = []
        for argument, parameter in zip(node.args, called.args.args, strict=True):
            kind = self.parameter_kind(parameter)
            if isinstance(kind, str):
                given.append(f"{kind} {self.as_kind(self.value(argument), kind)}")
                continue
            array = self.array(argument)
            if len(array.sizes) != kind:
                raise UnknownError(ast.unparse(node))
            given += [f"ptr {array.pointer}", *(f"i64 {size}" for size in array.sizes)]
        kinds = returned(called)
        what = f"call {result_type(kinds)} @{self.prefix}.{called.name}({', '.join(given)})"
        if kinds:
            return self.new(what)
        self.do(what)
        return ""

    def parameter_kind(self, parameter: ast.arg) -> str | int:
        """The kind of a scalar that a function takes, or the number of dimensions of an array."""
        text = annotation(parameter.annotation)
        found = OF_ANNOTATION.get(text) or DIMENSIONS.get(text)
        if not found:
            raise UnknownError(f"{parameter.arg}: {text}")
        return found

    def _call(self, node: ast.Call) -> Number:
        name = self.called(node)
        if name in self.functions:
            kinds = returned(self.functions[name])
            if len(kinds) != 1:
                raise UnknownError(ast.unparse(node))
            return Number(self.call_own(node), kinds[0])
        values = [self.value(one) for one in node.args]
        if name in ("min", "max") and len(values) > 1:
            return self.least(name, values)
        if len(values) != (2 if name == "atan2" else 1):
            raise UnknownError(ast.unparse(node))
        if name == "bool":
            return self.condition(values[0])
        if name in ("int", "float", "abs", *ROUNDED):
            return self.converted(name, values[0])
        if (name not in INTRINSICS and name not in EXTERNALS) or any(value.kind == BOOL for value in values):
            raise UnknownError(ast.unparse(node))
        called = INTRINSICS.get(name, name)
        self.externals.add(f"declare double @{called}({', '.join(['double'] * len(values))})")
        given = ", ".join(f"double {self.as_kind(value, FLOAT)}" for value in values)
        return Number(self.new(f"call double @{called}({given})"), FLOAT)
