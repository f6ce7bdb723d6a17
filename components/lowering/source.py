"""The files that a kernel is spread over, each once, those that it imports from before it."""

from __future__ import annotations

import ast
import importlib
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

from ..declare.record import Matrix, Vector
from .errors import refuse
from .lowered import Part

OUTSIDE = "rovbrush.components."  # what a component outside of the package imports from it


@dataclass(frozen=True)
class Source(Part):
    """One file of a kernel as it is written, with its syntax tree."""

    @cached_property
    def tree(self) -> ast.Module:
        """The syntax tree of the text."""
        return ast.parse(self.text)

    @property
    def functions(self) -> list[ast.FunctionDef]:
        """The functions of the file, in order."""
        return [node for node in self.tree.body if isinstance(node, ast.FunctionDef)]


def parts_of(kernel: ModuleType) -> tuple[list[Source], dict[str, type[Any]]]:
    """The files of a kernel module, and the record classes that they import, by name."""
    done: list[str] = []
    parts: list[Source] = []
    records: dict[str, type[Any]] = {}

    def add(module: ModuleType) -> None:
        if module.__name__ in done:
            return
        done.append(module.__name__)
        path = Path(str(module.__file__))
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for node in ast.parse(text).body:
            if not isinstance(node, ast.ImportFrom):
                continue
            ours = bool(node.level) or (node.module or "").startswith(OUTSIDE)
            if not (ours or node.module == "__future__"):
                continue
            if ours:
                name = "." * node.level + (node.module or "")
                imported = importlib.import_module(name, module.__package__)
                found = declared(path, node, imported)
                records.update(found)
                if not found:
                    add(imported)
            for number in range(node.lineno - 1, node.end_lineno or node.lineno):
                lines[number] = ""
        parts.append(Source(path, "\n".join(lines) + "\n"))

    add(kernel)
    return parts, records


def declared(path: Path, node: ast.ImportFrom, module: ModuleType) -> dict[str, type[Any]]:
    """The declarations that an import brings: records and array types; none if it brings functions."""
    named = {alias.name: getattr(module, alias.name) for alias in node.names}
    types = {name: one for name, one in named.items() if isinstance(one, type) or one in (Vector, Matrix)}
    if types and len(types) != len(named):
        refuse(path, node, "an import brings functions or declarations, not both; write two")
    if any(alias.asname for alias in node.names):
        refuse(path, node, "a kernel imports names as they are, without `as`")
    return {name: one for name, one in types.items()}


def is_record(one: object) -> bool:
    """Is it a record class, or a `Parameters` dataclass? Known by what it has: a copy in an FMU is one too."""
    return isinstance(one, type) and (hasattr(one, "packed") or hasattr(one, "__dataclass_fields__"))
