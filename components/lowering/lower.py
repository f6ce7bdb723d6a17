"""Lowering: each access of a record becomes a named scalar or a cell of an array, on the line where it stands.

The text is changed in place, so that lines, comments and layout stay: an error of Numba or Pyccel points at the
source. A record of which no cell is written is passed as the fields that a function and those it calls use; one with a
written cell as its array of cells. A local record is scalars; a record that is returned is a tuple.
"""

from __future__ import annotations

import ast
from typing import Any

from ..declare.layout import cells_name, cells_of, dimensions, storage, width
from ..declare.record import Field, fields_of
from .allowed import check
from .cells import Cells
from .edits import Edits
from .functions import Function, functions_of
from .lowered import Lowered, Part
from .source import Source, is_record


def lower(parts: list[Source], records: dict[str, type[Any]], cells: Cells | None = None) -> Lowered:
    """Lower the files of a kernel; `records` are the classes that they name. `cells`: how cells are written."""
    functions = functions_of(parts, records)
    made = []
    for part in parts:
        edits = Edits(part.text)
        for node in part.functions:
            check(functions[node.name], functions, records)
            _Rewriter(functions[node.name], functions, records, edits, cells or Cells()).function()
        made.append(Part(part.path, edits.applied()))
    return Lowered(made, {name: _arguments(f) for name, f in functions.items()})


def _arguments(function: Function) -> list[str]:
    """What a lowered function is called with: a record's cells by the name of their array, fields by their own."""
    found: list[str] = []
    for name, kind in function.parameters.items():
        if isinstance(kind, str):
            found.append(name)
        else:
            found += [cells_name(kind)] * function.in_cells(name) + function.passed(name)
    return found


class _Rewriter:
    """Collects the edits of one function."""

    def __init__(
        self,
        function: Function,
        functions: dict[str, Function],
        records: dict[str, type[Any]],
        edits: Edits,
        cells: Cells,
    ) -> None:
        self.f, self.functions, self.edits, self.cells = function, functions, edits, cells
        self.classes = {name: one for name, one in records.items() if is_record(one)}

    def function(self) -> None:
        """The signature, then the body."""
        node = self.f.node
        if node.args.args:
            given = ", ".join(self._parameters())
            last = node.args.args[-1]
            self.edits.replace(node.args.args[0], given, until=last.annotation or last)
        if self.f.returned is not None and node.returns is not None:
            kinds = [field.kind.__name__ for field in fields_of(self.f.returned).values()]
            self.edits.replace(node.returns, kinds[0] if len(kinds) == 1 else f"tuple[{', '.join(kinds)}]")
        for statement in node.body:
            self.visit(statement)

    def _parameters(self) -> list[str]:
        found = []
        for name, kind in self.f.parameters.items():
            if isinstance(kind, str):
                found.append(f"{name}: {kind}")
                continue
            if self.f.in_cells(name):
                found.append(f"{name}: {self.cells.annotation(kind)}")
            types = {key: _type(field) for key, field in fields_of(kind).items() if not field.is_record}
            for key, field in fields_of(kind).items():
                if field.is_record:
                    inner = storage(field.kind, key, f"{key}_")
                    types |= {one: _type(own) if own else self.cells.annotation(field.kind) for one, _, own in inner}
            found += [f"{name}_{key}: {types[key]}" for key in self.f.passed(name)]
        return found

    def visit(self, node: ast.AST) -> None:
        """Edits for a node and what is in it."""
        if isinstance(node, ast.Assign) and self._made(node.value) is not None:
            self._make(node)
        elif isinstance(node, ast.Return) and isinstance(node.value, ast.Call) and self._made(node.value):
            self.edits.replace(node.value.func, "")
            self._values(node.value)
        elif isinstance(node, ast.Return) and isinstance(node.value, ast.Name) and node.value.id in self.f.locals:
            record, name = self.f.locals[node.value.id], node.value.id
            self.edits.replace(node.value, ", ".join(f"{name}_{key}" for key in fields_of(record)))
        elif isinstance(node, ast.Subscript) and isinstance(node.value, ast.Attribute):
            self._element(node, node.value)
        elif isinstance(node, ast.Attribute):
            self.edits.replace(node, self._field(node))
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in self.functions:
            for argument, (name, kind) in zip(
                node.args, self.functions[node.func.id].parameters.items(), strict=True
            ):
                self._argument(argument, self.functions[node.func.id], name, kind)
        else:
            for child in ast.iter_child_nodes(node):
                self.visit(child)

    def _made(self, value: ast.expr) -> type[Any] | None:
        """The record class that an expression makes, or a function of the kernel returns."""
        if not (isinstance(value, ast.Call) and isinstance(value.func, ast.Name)):
            return None
        called = self.functions.get(value.func.id)
        return self.classes.get(value.func.id) or (called.returned if called else None)

    def _make(self, node: ast.Assign) -> None:
        """`a = rates(x, p)` fills all fields at once, `a = Rates(1.0, b)` one after the other."""
        target, call = node.targets[0], node.value
        assert isinstance(target, ast.Name) and isinstance(call, ast.Call) and isinstance(call.func, ast.Name)
        names = [f"{target.id}_{key}" for key in fields_of(self.f.locals[target.id])]
        if call.func.id not in self.classes:
            self.edits.replace(target, ", ".join(names))
            self.visit(call)
            return
        values = [*call.args, *(keyword.value for keyword in call.keywords)]
        reads_itself = any(isinstance(n, ast.Name) and n.id == target.id for one in values for n in ast.walk(one))
        first = [f"new_{name}" for name in names] if reads_itself else names
        self.edits.replace(target, f"{first[0]} = (", until=values[0], inside=False)
        for name, one, following in zip(first[1:], values, values[1:], strict=False):
            self.edits.between(one, following, f"); {name} = (")
        self.edits.between(values[-1], None, ")", end=call)
        if reads_itself:
            self.edits.after(call, "".join(f"; {name} = new_{name}" for name in names))
        for one in values:
            self.visit(one)

    def _values(self, call: ast.Call) -> None:
        """The values of a record that is returned, without the fields' names."""
        for one in call.args:
            self.visit(one)
        for keyword in call.keywords:
            self.edits.replace(keyword, "", until=keyword.value, inside=False)
            self.visit(keyword.value)

    def _record(self, node: ast.expr) -> tuple[type[Any], str] | None:
        """Class and name of the record that an expression names: a parameter, a local, or a field that is a record."""
        if isinstance(node, ast.Name):
            kind = self.f.locals.get(node.id) or self.f.records.get(node.id)
            return (kind, node.id) if kind is not None else None
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            owner = self._record(node.value)
            if owner is not None and fields_of(owner[0])[node.attr].is_record:
                return fields_of(owner[0])[node.attr].kind, f"{owner[1]}_{node.attr}"
        return None

    def _in_cells(self, name: str) -> bool:
        return name in self.f.records and self.f.in_cells(name)

    def _field(self, node: ast.Attribute) -> str:
        """A field as text: a cell of an array, or a name."""
        assert isinstance(node.value, ast.Name)
        name = node.value.id
        cells = cells_of(self.f.locals.get(name) or self.f.records[name])
        if node.attr in cells and self._in_cells(name):
            return self.cells.scalar(name, self.f.records[name], node.attr)
        return f"{name}_{node.attr}"

    def _element(self, node: ast.Subscript, of: ast.Attribute) -> None:
        """An element of an array; that of a packed record lies behind what comes before it."""
        assert isinstance(of.value, ast.Name)
        record = self.f.locals.get(of.value.id) or self.f.records[of.value.id]
        at = cells_of(record).get(of.attr)
        if at is None:
            self.edits.replace(of, f"{of.value.id}_{of.attr}")
            self.visit(node.slice)
            return
        name, index = of.value.id, node.slice
        if self.cells.in_rows(record):
            self.edits.replace(of, f"{name}[{at // width(record)}, ", until=index, inside=False)
            self.visit(index)
        elif isinstance(index, ast.Tuple):
            row, column = index.elts
            shape = fields_of(record)[of.attr].shape
            assert isinstance(shape, tuple)
            first = self.cells.first(record, of.attr)
            self.edits.replace(of, f"{name}[{first} + {shape[1]} * (", until=row, inside=False)
            self.edits.between(row, column, ") + (")
            self.edits.between(column, None, ")]", end=node)
            self.visit(row)
            self.visit(column)
        elif isinstance(index, ast.Constant):
            cell = self.cells.first(record, of.attr, int(str(index.value)))
            self.edits.replace(of, f"{name}[{cell}", until=index)
        else:
            before = self.cells.before(record, of.attr)
            simple = isinstance(index, ast.Name) or not before
            self.edits.replace(of, f"{name}[{before}{'' if simple else '('}", until=index, inside=False)
            if not simple:
                self.edits.after(index, ")")
            self.visit(index)

    def _argument(self, node: ast.expr, called: Function, name: str, kind: Any) -> None:
        """An argument as what the called function takes of it."""
        given = self._record(node)
        if given is None:
            self.visit(node)
            return
        record, own = given
        nested = isinstance(node, ast.Attribute)
        if isinstance(kind, str):
            self.edits.replace(node, own)
            return
        cells = cells_of(record)
        texts = [own] if called.in_cells(name) else []
        for key in called.passed(name):
            whole = key in cells and (nested or self._in_cells(own))
            texts.append(self.cells.scalar(own, record, key) if whole else f"{own}_{key}")
        self.edits.replace(node, ", ".join(texts))


def _type(field: Field) -> str:
    """The annotation of a field that is passed by itself."""
    if field.is_array:
        return "'float[:,:]'" if dimensions(field) == 2 else "'float[:]'"
    return field.kind.__name__
