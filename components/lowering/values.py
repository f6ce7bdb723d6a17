"""What an expression of a kernel may be: numbers, elements of arrays, fields of records, calls."""

from __future__ import annotations

import ast
import math
from typing import Any, NoReturn

from ..declare.layout import cells_of, width
from ..declare.record import Field, fields_of
from .errors import meant, refuse
from .functions import Function
from .source import is_record

EXPRESSIONS = (
    ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.Call, ast.IfExp, ast.Name, ast.Constant, ast.Attribute,
    ast.Subscript, ast.Tuple,
)  # fmt: skip
BUILTINS = ("abs", "min", "max", "range", "float", "int", "bool")


class Values:
    """The checks of expressions in one function."""

    def __init__(self, function: Function, functions: dict[str, Function], records: dict[str, type[Any]]) -> None:
        self.f, self.functions = function, functions
        self.classes = {name: one for name, one in records.items() if is_record(one)}
        self.known = {**function.records, **function.locals}

    def no(self, node: ast.AST, text: str) -> NoReturn:
        """Refuse a place of this function."""
        refuse(self.f.path, node, text)

    def value(self, node: ast.expr) -> None:
        """An expression that is a number, or several."""
        if not isinstance(node, EXPRESSIONS):
            self.no(node, f"a kernel has no {words(node)}")
        if isinstance(node, ast.Name) and node.id in self.known:
            self.no(node, f"the record {node.id} is no value: name a field of it, or give it to a function")
        if isinstance(node, ast.Attribute):
            field = self.field(node)
            if field.is_record:
                self.no(node, f"{ast.unparse(node)} is a record: give it to a function")
            if field.is_array:
                self.no(node, f"{ast.unparse(node)} is an array: name an element of it, or give it to a function")
        elif isinstance(node, ast.Subscript):
            self.element(node)
        elif isinstance(node, ast.Call):
            if self.makes(node) is not None:
                self.no(node, "a record is made alone on the right side: `a = rates(x, p)`, then `a.di`")
            self.call(node)
        else:
            for child in ast.iter_child_nodes(node):
                if isinstance(child, ast.expr):
                    self.value(child)

    def element(self, node: ast.Subscript) -> None:
        """`K[r, s]` or `s.K[r, s]`, with numbers as indices."""
        if isinstance(node.slice, ast.Slice) or any(isinstance(n, ast.Slice) for n in ast.walk(node.slice)):
            self.no(node, "a kernel takes single elements, no slices")
        if isinstance(node.value, ast.Attribute):
            field = self.field(node.value)
            if not field.is_array:
                self.no(node, f"{ast.unparse(node.value)} has no elements")
        elif not isinstance(node.value, ast.Name):
            self.no(node, "only an array has elements")
        elif node.value.id in self.known:
            self.no(node, f"the record {node.value.id} has fields, not elements")
        self.value(node.slice)

    def field(self, node: ast.Attribute) -> Field:
        """The field that an attribute names."""
        if isinstance(node.value, ast.Attribute):
            self.no(node, f"{ast.unparse(node.value)} is a field; give it to a function that takes such a record")
        if not isinstance(node.value, ast.Name) or node.value.id not in self.known:
            known = meant(ast.unparse(node.value), self.known)
            self.no(node, f"only a record stands before a dot, and {ast.unparse(node.value)} is none{known}")
        record = self.known[node.value.id]
        found = fields_of(record).get(node.attr)
        if found is None:
            self.no(node, f"{record.__name__} has no field '{node.attr}'{meant(node.attr, fields_of(record))}")
        return found

    def makes(self, node: ast.expr | None) -> type[Any] | None:
        """The record class that a call makes or returns."""
        name = called_name(node)
        return self.classes.get(name) or (self.functions[name].returned if name in self.functions else None)

    def call(self, node: ast.Call) -> None:
        """A call of a function of the kernel, of `math`, or of a record class."""
        name = called_name(node)
        if not name:
            self.no(node, f"{ast.unparse(node.func)} is no function; records have no methods")
        if name in self.classes:
            self.construction(node, self.classes[name])
            return
        if node.keywords:
            self.no(node, f"{name} is called with values in order, without names")
        if name not in self.functions:
            if name not in BUILTINS and not hasattr(math, name):
                self.no(node, f"there is no function {name}{meant(name, self.functions)}")
            for argument in node.args:
                self.value(argument)
            return
        called = self.functions[name]
        if len(node.args) != len(called.parameters):
            wanted = ", ".join(called.parameters)
            self.no(node, f"{name} takes {len(called.parameters)} values ({wanted}), not {len(node.args)}")
        for argument, (parameter, kind) in zip(node.args, called.parameters.items(), strict=True):
            self.argument(argument, called, parameter, kind)
        self.aliases(node, called)

    def construction(self, node: ast.Call, record: type[Any]) -> None:
        """`Rates(a, b)` or `Rates(di=a, domega_m=b)`: all fields, in order."""
        names = list(fields_of(record))
        given = [*names[: len(node.args)], *(keyword.arg for keyword in node.keywords)]
        if given != names or len(node.args) > len(names):
            self.no(node, f"{record.__name__} is made of {', '.join(names)}, in this order")
        for one in (*node.args, *(keyword.value for keyword in node.keywords)):
            self.value(one)

    def argument(self, node: ast.expr, called: Function, parameter: str, kind: Any) -> None:
        """One argument: a record where one is taken, an array where one is taken, else a number."""
        if isinstance(kind, str) and "float[" not in kind:
            self.value(node)
            return
        text, name = ast.unparse(node), called.node.name
        owner = field = None
        record = self.known.get(node.id) if isinstance(node, ast.Name) else None
        if isinstance(node, ast.Attribute):
            field = self.field(node)
            owner = self.known[ast.unparse(node.value)]
            record = field.kind if field.is_record else None
        if isinstance(kind, str):
            if record is not None and width(record):
                self.no(node, f"{text} is a record of rows, which no function takes as one array")
            if record is not None and not record.packed:
                self.no(node, f"{text} is a record of several arrays, and {name} takes one array as {parameter}")
            if record is None and not isinstance(node, ast.Name) and (field is None or not field.is_array):
                self.no(node, f"{name} takes an array as {parameter}, and {text} is none")
            if record is None and owner is not None and field is not None and field.name in cells_of(owner):
                self.no(node, f"{text} lies inside a packed record; give the whole, or make it an array of its own")
            return
        if record is not kind:
            what = f"a {record.__name__}" if record is not None else "no record"
            self.no(node, f"{name} takes a {kind.__name__} as {parameter}, and {text} is {what}")
        if isinstance(node, ast.Name) and node.id in self.f.locals and called.in_cells(parameter):
            self.no(node, f"{name} writes to {parameter}, which a record made here cannot take")

    def aliases(self, node: ast.Call, called: Function) -> None:
        """The same record twice in one call is allowed only where nobody writes to it."""
        seen: dict[str, bool] = {}
        for argument, (name, kind) in zip(node.args, called.parameters.items(), strict=True):
            if isinstance(kind, str):
                continue
            text = ast.unparse(argument)
            written = bool(called.uses[name].written or called.uses[name].whole)
            if text in seen and (written or seen[text]):
                self.no(node, f"{text} is given twice, and {called.node.name} writes to it")
            for other in seen:  # x.motion beside x
                inner, outer = (text, other) if len(text) > len(other) else (other, text)
                within = inner.startswith(f"{outer}.") and self.reaches(node, called, outer, inner)
                if within and (written or seen[other]):
                    self.no(node, f"{inner} is given twice, also in {outer}, and {called.node.name} writes to it")
            seen[text] = written or seen.get(text, False)
        arrays = [a for a, kind in zip(node.args, called.parameters.values(), strict=True) if isinstance(kind, str)]
        for text in map(ast.unparse, arrays):
            if text in seen:
                self.no(node, f"{text} is given twice, as a record and as an array")
            outer = text.split(".")[0]
            if outer in seen and "." in text and self.reaches(node, called, outer, text):
                self.no(node, f"{text} is given twice, also in {outer}, of which {called.node.name} uses it")

    def reaches(self, node: ast.Call, called: Function, outer: str, inner: str) -> bool:
        """Does a called function use a record in a record that it is given, beside what it is given by itself?"""
        given = {ast.unparse(a): name for a, name in zip(node.args, called.parameters, strict=True)}
        return inner.split(".")[1] in called.uses[given[outer]].read


def called_name(node: ast.expr | None) -> str:
    return node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""


def words(node: ast.AST) -> str:
    """The name of a construct in lower case: `list comp`, `try`."""
    name = type(node).__name__
    return "".join(f" {c.lower()}" if c.isupper() and k else c.lower() for k, c in enumerate(name))
