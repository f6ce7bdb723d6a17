"""Arithmetic with numbers of several kinds as LLVM's text. What IEEE 754 says is kept: no rearranging, no fused
multiply-add."""

from __future__ import annotations

import ast

from .kinds import BOOL, FLOAT, INT, Number, UnknownError, joined
from .text import Text

ARITHMETIC = {ast.Add: ("fadd", "add"), ast.Sub: ("fsub", "sub"), ast.Mult: ("fmul", "mul")}
OF_BITS = {ast.BitAnd: "and", ast.BitOr: "or", ast.BitXor: "xor", ast.LShift: "shl", ast.RShift: "ashr"}
ROUNDED = {"floor": "llvm.floor.f64", "ceil": "llvm.ceil.f64", "trunc": "llvm.trunc.f64"}


class Arithmetic(Text):
    """Numbers made of numbers."""

    def __init__(self, externals: set[str]) -> None:
        """`externals`: what is declared for the functions that are called, of LLVM's and of the C library."""
        super().__init__()
        self.externals = externals

    def condition(self, value: Number) -> Number:
        """Whether a number is not zero, as Python has it."""
        if value.kind == BOOL:
            return value
        zero = "0.0" if value.kind == FLOAT else "0"
        how = "fcmp une" if value.kind == FLOAT else "icmp ne"
        return Number(self.new(f"{how} {value.kind} {value.text}, {zero}"), BOOL)

    def as_kind(self, value: Number, kind: str) -> str:
        """A value as one of another kind that takes it."""
        if value.kind == kind:
            return value.text
        if kind == FLOAT:
            return self.new(f"{'sitofp' if value.kind == INT else 'uitofp'} {value.kind} {value.text} to double")
        raise UnknownError(f"{value.kind} for {kind}")

    def arithmetic(self, operator: ast.operator, one: Number, other: Number) -> Number:
        """Two numbers and an operator."""
        if BOOL in (one.kind, other.kind):
            raise UnknownError("arithmetic with true and false")
        if isinstance(operator, ast.Div):
            return Number(self.new(f"fdiv double {self.as_kind(one, FLOAT)}, {self.as_kind(other, FLOAT)}"), FLOAT)
        if type(operator) in OF_BITS and one.kind == other.kind == INT:
            if isinstance(operator, ast.LShift | ast.RShift) and not other.text.isdigit():
                raise UnknownError("a shift by what is not known")
            return Number(self.new(f"{OF_BITS[type(operator)]} i64 {one.text}, {other.text}"), INT)
        if type(operator) not in ARITHMETIC:
            raise UnknownError(type(operator).__name__)
        of_floats, of_ints = ARITHMETIC[type(operator)]
        kind = joined(one.kind, other.kind)
        what = of_floats if kind == FLOAT else of_ints
        return Number(self.new(f"{what} {kind} {self.as_kind(one, kind)}, {self.as_kind(other, kind)}"), kind)

    def least(self, name: str, values: list[Number]) -> Number:
        """As Python compares: one that is not a number is passed over where it comes later."""
        best = values[0]
        for one in values[1:]:
            kind = joined(best.kind, one.kind)
            if kind == BOOL:
                raise UnknownError(name)
            a, b = self.as_kind(best, kind), self.as_kind(one, kind)
            order = "lt" if name == "min" else "gt"
            better = self.new(f"{'fcmp o' if kind == FLOAT else 'icmp s'}{order} {kind} {b}, {a}")
            best = Number(self.new(f"select i1 {better}, {kind} {b}, {kind} {a}"), kind)
        return best

    def converted(self, name: str, value: Number) -> Number:
        if name == "float":
            return Number(self.as_kind(value, FLOAT), FLOAT)
        if value.kind == BOOL and name == "int":
            return Number(self.new(f"zext i1 {value.text} to i64"), INT)
        if value.kind == BOOL:
            raise UnknownError(f"{name} of true or false")
        if name == "abs" and value.kind == INT:
            less, minus = self.new(f"icmp slt i64 {value.text}, 0"), self.new(f"sub i64 0, {value.text}")
            return Number(self.new(f"select i1 {less}, i64 {minus}, i64 {value.text}"), INT)
        if value.kind == INT:
            return value
        text = value.text
        if name != "int":
            called = ROUNDED.get(name, "llvm.fabs.f64")
            self.externals.add(f"declare double @{called}(double)")
            text = self.new(f"call double @{called}(double {text})")
        return Number(text, FLOAT) if name == "abs" else Number(self.new(f"fptosi double {text} to i64"), INT)
