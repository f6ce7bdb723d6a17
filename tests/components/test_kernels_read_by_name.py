"""Kernels are read by name: short functions of few parameters, and no index that stands for a name."""

from __future__ import annotations

import ast
import importlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from helpers import ROOT
from rovbrush.components.build import COMPONENTS
from rovbrush.components.lowering.lowered import lowered

PARAMETERS, LINES, COMPONENTS_OF_A_VECTOR = 8, 60, 4
EVERYWHERE = sorted((ROOT / "components").glob("*/*.py"))


def kernel_files() -> list[Path]:
    """All files with functions of kernels, each once."""
    kernels = [importlib.import_module(f"rovbrush.components.{name}.kernel") for name in COMPONENTS]
    return list(dict.fromkeys(part.path for kernel in kernels for part in lowered(kernel).parts))


def functions(path: Path) -> Iterator[ast.FunctionDef]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef):
            yield node


@pytest.mark.parametrize("path", EVERYWHERE, ids=lambda p: str(p.relative_to(ROOT)))
def test_no_function_is_long_or_takes_many_parameters(path: Path) -> None:
    for function in functions(path):
        where = f"{path.relative_to(ROOT)}:{function.lineno}: {function.name}"
        a = function.args
        assert len([*a.posonlyargs, *a.args, *a.kwonlyargs]) <= PARAMETERS, where
        assert (function.end_lineno or 0) - function.lineno + 1 <= LINES, where


@pytest.mark.parametrize("path", kernel_files(), ids=lambda p: str(p.relative_to(ROOT)))
def test_no_index_stands_for_a_name(path: Path) -> None:
    """Numbers are indices of components of vectors only; the shared library may take six components apart."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Subscript):
            for index in node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]:
                where = f"{path.relative_to(ROOT)}:{node.lineno}: {ast.unparse(node)}"
                largest = max((n.value for n in ast.walk(index) if is_number(n)), default=0)
                if isinstance(index, ast.Constant):
                    assert largest < COMPONENTS_OF_A_VECTOR or "library" in path.parts, where
                else:
                    sums = [n for n in ast.walk(index) if isinstance(n, ast.BinOp) and isinstance(n.op, ast.Add)]
                    added = [side.value for n in sums for side in (n.left, n.right) if is_number(side)]
                    assert max(added, default=0) < 2 or "library" in path.parts, where  # k + 1: the next one


def is_number(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int) and not isinstance(node.value, bool)
