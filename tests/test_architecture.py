"""The rules that keep the parts apart, read from the source."""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from helpers import ROOT
from rovbrush.components.build import COMPONENTS
from rovbrush.components.lowering.lowered import lowered
from rovbrush.orchestrator.exchange.component_tests.suites import FILES as BEHAVIOUR_FILES

COMPONENT_FILES = sorted((ROOT / "components").rglob("*.py"))


def imported(path: Path) -> Iterator[str]:
    """Absolute names of what a file of the package imports, wherever in the file."""
    package = ("rovbrush", *path.relative_to(ROOT).with_suffix("").parts[:-1])
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = ".".join(package[: len(package) + 1 - node.level]) if node.level else ""
            module = ".".join(filter(None, (base, node.module)))
            yield from (f"{module}.{alias.name}" for alias in node.names)


BRUSHES = re.compile(
    r"(?<!rov)brush|filament|bristle|\bhull|mode_?shape|elastica|\blambda_r|\bF_[xyzn]\b|\bT_brush|\bomega_[bm]|\bmu_[sk]\b",
    re.IGNORECASE,
)


def test_rooms_import_only_from_rooms_below_them() -> None:
    """The contracts stand in pyproject.toml; `lint-imports` prints them."""
    command = [
        sys.executable,
        "-c",
        "from importlinter.cli import lint_imports_command as f; f()",
        "--no-logo",
        "--no-cache",
    ]
    said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert said.returncode == 0, said.stdout + said.stderr


def test_only_paper_and_systems_know_brushes() -> None:
    """No other file of a room has a word of the shipped systems in its code, examples or explanations."""
    rooms = (p for pattern in ("*.py", "*.toml", "*.c", "*.j2") for p in (ROOT / "orchestrator").rglob(pattern))
    known = [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for path in sorted(rooms)
        if path.relative_to(ROOT / "orchestrator").parts[0] not in ("paper", "systems")
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if BRUSHES.search(line)
    ]
    assert not known, "\n".join(known)


@pytest.mark.parametrize("path", COMPONENT_FILES, ids=lambda p: str(p.relative_to(ROOT)))
def test_components_never_import_each_other(path: Path) -> None:
    names = list(imported(path))
    own = path.relative_to(ROOT / "components").parts[0]
    others = [f"rovbrush.components.{other}" for other in COMPONENTS if other != own]
    assert not [name for name in names if name.startswith(tuple(others))], "components meet at FMUs"


def kernel_files(name: str) -> list[Path]:
    """kernel.py and the files with functions that it is spread over."""
    return [part.path for part in lowered(importlib.import_module(f"rovbrush.components.{name}.kernel")).parts]


@pytest.mark.parametrize("name", COMPONENTS)
def test_no_two_files_of_a_kernel_define_the_same_function(name: str) -> None:
    trees = [ast.parse(path.read_text(encoding="utf-8")) for path in kernel_files(name)]
    functions = [node.name for tree in trees for node in tree.body if isinstance(node, ast.FunctionDef)]
    assert len(functions) == len(set(functions))


@pytest.mark.parametrize("name", COMPONENTS)
def test_kernels_import_nothing_but_math_and_keep_no_globals(name: str) -> None:
    for path in kernel_files(name):
        own = f"rovbrush.components.{name}."
        shared = ("rovbrush.components.library.", "rovbrush.components.declare.record.")
        assert all(module.startswith(("math.", own, *shared)) for module in imported(path)), path
        tree = ast.parse(path.read_text(encoding="utf-8"))
        allowed = (ast.FunctionDef, ast.ImportFrom)
        extra = [
            node
            for node in tree.body
            if not isinstance(node, allowed)
            and not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))
        ]
        assert not extra, f"{path.name} line {extra[0].lineno}"
        for node in ast.walk(tree):
            forbidden = (ast.Dict, ast.ClassDef, ast.Lambda, ast.Try, ast.Raise, ast.ListComp, ast.Global, ast.With)
            assert not isinstance(node, forbidden), f"{path.name} line {getattr(node, 'lineno', '?')}"
            if isinstance(node, ast.FunctionDef):
                assert ast.get_docstring(node), f"{path.name}: {node.name}"


@pytest.mark.parametrize("name", COMPONENTS)
def test_fmu_files_hold_names_and_no_equations(name: str) -> None:
    text = (ROOT / "components" / name / "fmu.py").read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 60
    tree = ast.parse(text)
    shapes = {inner for node in ast.walk(tree) if isinstance(node, ast.Lambda) for inner in ast.walk(node)}
    for node in ast.walk(tree):
        if isinstance(node, (ast.BinOp, ast.AugAssign)) and node not in shapes:  # | joins tables of names
            assert isinstance(node.op, ast.BitOr), f"arithmetic in line {node.lineno}: {ast.unparse(node)}"
        assert not isinstance(node, (ast.While, ast.If)), "no logic"
    methods = [node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    assert not methods


@pytest.mark.parametrize("name", COMPONENTS)
def test_every_component_has_the_same_files(name: str) -> None:
    files = {path.name for path in (ROOT / "components" / name).iterdir() if path.is_file()}
    assert {"__init__.py", "parameters.py", "kernel.py", "fmu.py", "README.md"} <= files
    tests = [file for file in BEHAVIOUR_FILES if (ROOT / "components" / name / file).is_file()]
    assert len(tests) == 1, f"one of {BEHAVIOUR_FILES} has the component's suite"


def test_contributing_names_files_and_rooms_that_exist() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").replace("<name>", "battery")  # the example there
    for named in re.findall(r"`([\w./-]+)`", text):
        if "/" in named or named.endswith(".py"):
            places = [ROOT / named, ROOT / "orchestrator" / named, *(ROOT / "orchestrator").rglob(named.strip("/"))]
            places += (ROOT / "components" / "battery").glob(named.strip("/"))
            assert any(place.exists() for place in places), named


def test_test_files_have_names_of_their_own() -> None:
    """pytest imports them by their base names, whatever their folders."""
    names = [path.name for path in (ROOT / "tests").rglob("*.py") if path.name not in ("__init__.py", "conftest.py")]
    names = [name for name in names if name.startswith("test_")]
    assert len(names) == len(set(names))


def test_tests_lie_in_folders_named_as_the_rooms() -> None:
    files = [path for top in ("orchestrator", "components") for path in (ROOT / "tests" / top).rglob("*.py")]
    for folder in {path.parent for path in files}:
        assert (ROOT / folder.relative_to(ROOT / "tests")).is_dir(), folder
