"""What the functions of a kernel take, return and do with records, and how each record is passed."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from ..declare.layout import cells_of, storage
from ..declare.record import fields_of
from .errors import meant, refuse
from .source import Source, is_record

ENTRIES = ("setup", "initialize", "outputs", "step", "table")  # what an FMU calls
READ_ONLY = ("parameter", "input")
ARRAYS = {"Vector": "'float[:]'", "Matrix": "'float[:,:]'"}


@dataclass
class Use:
    """What a function does with a record: fields read, fields written, and whether it is passed on as one array."""

    read: set[str] = field(default_factory=set)
    written: set[str] = field(default_factory=set)
    whole: bool = False

    def include(self, other: Use) -> bool:
        """Add what a called function does; has anything changed?"""
        before = len(self.read), len(self.written), self.whole
        self.read |= other.read
        self.written |= other.written
        self.whole |= other.whole
        return before != (len(self.read), len(self.written), self.whole)


@dataclass
class Function:
    """A function of a kernel. `records`: the record parameters; `locals`: records that it makes."""

    node: ast.FunctionDef
    path: Path
    parameters: dict[str, Any]  # name -> record class, or the text of an annotation
    returned: type[Any] | None
    locals: dict[str, type[Any]] = field(default_factory=dict)
    uses: dict[str, Use] = field(default_factory=dict)

    @cached_property
    def nodes(self) -> list[ast.AST]:
        """All that the function consists of."""
        return list(ast.walk(self.node))

    @cached_property
    def names(self) -> set[str]:
        """All names of variables and parameters."""
        return {n.id for n in self.nodes if isinstance(n, ast.Name)} | set(self.parameters)

    @property
    def records(self) -> dict[str, type[Any]]:
        """The record parameters."""
        return {name: one for name, one in self.parameters.items() if not isinstance(one, str)}

    def in_cells(self, name: str) -> bool:
        """Is a record passed as its array of cells, because one is written or the whole is needed?

        An entry point gets all records so that are not given from outside.
        """
        record, use = self.parameters[name], self.uses[name]
        fields, cells = fields_of(record), cells_of(record)
        kept = self.node.name in ENTRIES and not any(f.role in READ_ONLY for f in fields.values())
        return use.whole or any(
            key in cells and (kept or key in use.written or (getattr(record, "packed", False) and fields[key].is_array))
            for key in use.read | use.written
        )

    def passed(self, name: str) -> list[str]:
        """The fields of a record that are passed one by one, in declared order; of a record in it all its arrays."""
        use, cells = self.uses[name], cells_of(self.parameters[name])
        together = set(cells) if self.in_cells(name) else set()
        fields = fields_of(self.parameters[name])
        found: list[str] = []
        for key in fields:
            if key in (use.read | use.written) - together:
                inner = storage(fields[key].kind, key, f"{key}_") if fields[key].is_record else [(key, 0, None)]
                found += [one for one, _, _ in inner]
        return found


def functions_of(parts: list[Source], records: dict[str, type[Any]]) -> dict[str, Function]:
    """All functions of a kernel, with what they and the functions that they call do with records."""
    found: dict[str, Function] = {}
    for part in parts:
        for node in part.functions:
            if node.name in found:
                refuse(part.path, node, f"there is a function {node.name} in {found[node.name].path.name} already")
            found[node.name] = _declared(node, part.path, records)
    for function in found.values():
        function.locals = dict(_locals(function, found, records))
        function.uses = {name: Use() for name in function.records}
        for name, key, written in _accesses(function):
            (function.uses[name].written if written else function.uses[name].read).add(key)
    given = [one for function in found.values() for one in _given(function, found)]
    while any([own.include(use) for own, use in given]):
        pass
    for function in found.values():
        for name, use in function.uses.items():
            if not (use.read or use.written or use.whole):
                refuse(function.path, function.node, f"{function.node.name} uses nothing of {name}; leave it out")
    return found


def _declared(node: ast.FunctionDef, path: Path, records: dict[str, type[Any]]) -> Function:
    a = node.args
    if a.posonlyargs or a.kwonlyargs or a.vararg or a.kwarg or a.defaults:
        refuse(path, node, f"{node.name} takes plain parameters only, without defaults, * and **")
    parameters: dict[str, Any] = {}
    known = ("float", "int", "bool", *ARRAYS)
    for argument in a.args:
        if argument.annotation is None:
            refuse(path, argument, f"parameter {argument.arg} needs a type: {', '.join(known)} or a record")
        text = _annotation(argument.annotation)
        record = records.get(text)
        if record is None and text not in known and not isinstance(argument.annotation, ast.Constant):
            refuse(path, argument, f"'{text}' is no type of a kernel{meant(text, [*known, *records])}")
        parameters[argument.arg] = record if is_record(record) else ARRAYS.get(text, ast.unparse(argument.annotation))
    returned = records.get(_annotation(node.returns)) if node.returns is not None else None
    return Function(node, path, parameters, returned if is_record(returned) else None)


def _annotation(node: ast.expr) -> str:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ast.unparse(node)


def _locals(
    function: Function, found: dict[str, Function], records: dict[str, type[Any]]
) -> Iterator[tuple[str, type[Any]]]:
    """Records that a function makes by a record class or a function that returns one."""
    for node in function.nodes:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Name):
            made = records.get(node.value.func.id)
            made = made if is_record(made) else None
            if made is None and node.value.func.id in found:
                made = found[node.value.func.id].returned
            if made is not None:
                target = node.targets[0]
                if len(node.targets) != 1 or not isinstance(target, ast.Name):
                    refuse(function.path, node, "a record is made under one name: `a = rates(x, p)`")
                if target.id in function.parameters:
                    refuse(function.path, node, f"{target.id} is a parameter; give the new record a name of its own")
                yield target.id, made


def _accesses(function: Function) -> Iterator[tuple[str, str, bool]]:
    """(parameter, field, is a scalar written) for each field access in a function."""
    stored = {id(node.target) for node in function.nodes if isinstance(node, ast.AugAssign)}
    for node in function.nodes:
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in function.records:
            yield node.value.id, node.attr, isinstance(node.ctx, ast.Store) or id(node) in stored


def _given(function: Function, found: dict[str, Function]) -> Iterator[tuple[Use, Use]]:
    """Pairs: what a function does with a record, and what a function that it calls does with the same one."""
    for node in function.nodes:
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in found):
            continue
        called = found[node.func.id]
        for argument, (name, kind) in zip(node.args, called.parameters.items(), strict=False):
            if isinstance(argument, ast.Name) and argument.id in function.uses:
                yield function.uses[argument.id], Use(whole=True) if isinstance(kind, str) else called.uses[name]
