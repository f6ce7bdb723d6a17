"""What is imported is declared in pyproject.toml, and what is declared is used."""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path

from helpers import ROOT, python

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS: Mapping[str, list[str]] = PROJECT["optional-dependencies"]
NOT_IMPORTED = {
    "filelock": "Pyccel needs a newer one than it says",
    "h5py": "xarray and the checkpoints reach it through h5netcdf",
    "pyccel": "started as a program of its own",
    "tbb": "a library that ecospy loads and does not bring",
}
BY_ITS_USER = {"pytest": "the plugin is loaded by pytest only"}


def named(requirements: list[str]) -> set[str]:
    """Normalized names of distributions: `FMPy>=0.3` is `fmpy`."""
    return {normal(re.split(r"[<>=!~;\[ ]", text)[0]) for text in requirements}


def normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


NOT_IMPORTED |= {name: "of the documentation, which Sphinx builds" for name in named(EXTRAS["docs"])}
NOT_IMPORTED |= {name: "what runs a notebook" for name in named(EXTRAS["notebooks"])}
DECLARED = named(PROJECT["dependencies"]).union(*(named(texts) for extra, texts in EXTRAS.items() if extra != "test"))
DECLARED -= {"rovbrush"}  # of the extra that gathers others


@cache
def imports(path: Path) -> set[str]:
    """Top-level modules that a file imports, wherever in the file; none of the standard library."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    names |= {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom) and not node.level}
    return {name.split(".")[0] for name in names} - set(sys.stdlib_module_names) - {"rovbrush"}


@cache
def imported() -> dict[str, set[str]]:
    """Distributions that the package imports, with the files."""
    known = packages_distributions()
    found: dict[str, set[str]] = {}
    for path in (path for top in ("orchestrator", "components") for path in (ROOT / top).rglob("*.py")):
        for module in imports(path):
            names = sorted(map(normal, known.get(module, [f"module {module}"])))
            name = next(filter(DECLARED.__contains__, names), names[0])  # a left-over may claim the module too
            found.setdefault(name, set()).add(str(path.relative_to(ROOT)))
    return found


def test_everything_imported_is_declared() -> None:
    for name, places in imported().items():
        assert name in DECLARED | BY_ITS_USER.keys(), f"{name} is imported by {sorted(places)}"


def test_commands_start_without_the_extras() -> None:
    """Nothing of an extra is imported before it is asked for."""
    missing = set().union(*map(named, EXTRAS.values())) - named(PROJECT["dependencies"]) - {"rovbrush"}
    modules = [module for module, names in packages_distributions().items() if missing & set(map(normal, names))]
    code = (
        "import sys; sys.modules |= dict.fromkeys(sys.argv[1:]); sys.argv[1:] = ['systems']; "
        "from rovbrush.orchestrator.cli.main import main; main()"
    )
    done = python(code, *modules)
    assert done.returncode == 0 and "nominal" in done.stdout, done.stderr


def test_all_gathers_what_users_may_want() -> None:
    (gathered,) = EXTRAS["all"]
    extras = set(re.findall(r"[\w-]+", gathered.partition("[")[2]))
    assert {"native", "report", "study"} <= extras <= EXTRAS.keys() - {"all", "docs", "hosts", "test"}


def test_everything_declared_is_used() -> None:
    used = imported().keys() | NOT_IMPORTED.keys()
    assert used >= DECLARED, DECLARED - used


def test_the_tests_install_every_extra_they_test() -> None:
    for extra, requirements in EXTRAS.items():
        assert named(requirements) - {"rovbrush"} <= named(EXTRAS["test"]), extra


def test_the_tests_declare_what_they_import() -> None:
    declared = named(PROJECT["dependencies"]) | named(EXTRAS["test"])
    files = sorted((ROOT / "tests").rglob("*.py"))
    own = {path.stem for path in files} | {path.name for path in (ROOT / "tests").iterdir() if path.is_dir()}
    known = packages_distributions()
    for path in files:
        for module in imports(path) - own:
            names = set(map(normal, known.get(module, [])))
            assert names & declared, f"{path.relative_to(ROOT)} imports {module}, of {names or 'no distribution'}"
