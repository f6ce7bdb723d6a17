"""What a kernel may use, checked function by function before anything is changed."""

from __future__ import annotations

import ast
from typing import Any

from ..declare.record import Field, fields_of
from .functions import READ_ONLY, Function
from .values import Values, called_name, words

STATEMENTS = (
    ast.Assign, ast.AugAssign, ast.Return, ast.For, ast.While, ast.If, ast.Expr, ast.Break, ast.Continue, ast.Pass,
    ast.Raise,
)  # fmt: skip
_ARTICLES = {"parameter": "a parameter", "input": "an input"}


def check(function: Function, functions: dict[str, Function], records: dict[str, type[Any]]) -> None:
    """Raise KernelError for the first thing in a function that cannot be lowered or compiled."""
    _Statements(function, functions, records).all()


class _Statements(Values):
    """The checks of statements in one function."""

    def all(self) -> None:
        """Names first, then each statement."""
        for name, record in self.f.locals.items():
            for key, field in fields_of(record).items():
                if field.is_array or field.is_record:
                    self.no(self.f.node, f"{record.__name__}.{key} is an array; a record made here has scalars only")
                self._free(name, key)
        for name, record in self.f.records.items():
            for key in fields_of(record):
                self._free(name, key)
        for statement in self.f.node.body:
            self.statement(statement)

    def _free(self, name: str, key: str) -> None:
        if f"{name}_{key}" in self.f.names:
            self.no(self.f.node, f"{name}_{key} is what {name}.{key} becomes; give the variable another name")

    def statement(self, node: ast.stmt) -> None:
        """One statement and what is in it."""
        if not isinstance(node, STATEMENTS):
            self.no(node, f"a kernel has no {words(node)}")
        if isinstance(node, ast.Assign):
            self.assigned(node)
        elif isinstance(node, ast.AugAssign):
            self.target(node.target)
            self.value(node.value)
        elif isinstance(node, ast.Return):
            self.returned(node)
        elif isinstance(node, ast.For):
            if not isinstance(node.target, ast.Name) or called_name(node.iter) != "range":
                self.no(node, "a kernel counts: `for i in range(n)`")
            self.value(node.iter)
        elif isinstance(node, ast.Expr):
            if isinstance(node.value, ast.Call):
                self.call(node.value)
            elif not (isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)):
                self.no(node, "this line does nothing")
        elif isinstance(node, (ast.While, ast.If)):
            self.value(node.test)
        for inner in (*getattr(node, "body", ()), *getattr(node, "orelse", ())):
            self.statement(inner)

    def assigned(self, node: ast.Assign) -> None:
        """`x.theta_b = ..`, `a, b = f()`, or a record that is made."""
        if len(node.targets) != 1:
            self.no(node, "one `=` per line")
        target = node.targets[0]
        if isinstance(target, ast.Name) and target.id in self.f.locals:
            if self.makes(node.value) is not self.f.locals[target.id]:
                self.no(node, f"{target.id} is a {self.f.locals[target.id].__name__} and stays one")
            assert isinstance(node.value, ast.Call)
            self.call(node.value)
            return
        for one in target.elts if isinstance(target, ast.Tuple) else [target]:
            self.target(one)
        self.value(node.value)

    def target(self, node: ast.expr) -> None:
        """What a value is put into."""
        if isinstance(node, ast.Name) and node.id in self.known:
            self.no(node, f"the record {node.id} stays what it is: assign to its fields")
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Attribute):
            self.writable(node.value, self.field(node.value))
            self.value(node.slice)
        elif isinstance(node, ast.Attribute):
            field = self.field(node)
            self.writable(node, field)
            if field.is_array or field.is_record:
                self.no(node, f"{ast.unparse(node)} is no scalar: assign to its elements, or give it to a function")
        elif isinstance(node, (ast.Name, ast.Subscript)):
            self.value(node)
        else:
            self.no(node, "assign to names, fields and elements")

    def writable(self, node: ast.Attribute, field: Field) -> None:
        """Parameters and inputs are given; nobody writes them."""
        if field.role in READ_ONLY:
            self.no(node, f"{ast.unparse(node)} is {_ARTICLES[field.role]}, which no kernel changes")

    def returned(self, node: ast.Return) -> None:
        """Scalars, or a record made here."""
        wanted, given = self.f.returned, node.value
        if given is None:
            return
        if isinstance(given, ast.Name) and given.id in self.f.records:
            self.no(node, f"the record {given.id} is the caller's already; return nothing, or a record made here")
        made = self.f.locals.get(given.id) if isinstance(given, ast.Name) else self.makes(given)
        if wanted is not None:
            if made is not wanted or called_name(given) in self.functions:
                self.no(node, f"return a {wanted.__name__} that is made here: `return {wanted.__name__}(..)`")
            if isinstance(given, ast.Call):
                self.call(given)
        elif made is not None:
            self.no(node, f"a {made.__name__} is returned; say so: `-> {made.__name__}`")
        else:
            self.value(given)
