"""Whether several uses of an FMU in one process can be kept apart, as far as its files tell.

A library is loaded once more as a private copy, which has static data of its own, and Python modules are imported anew.
What this does not reach needs a process of its own: the libraries beside it, which the system loads once; data that C++
shares among all copies (STB_GNU_UNIQUE); Python modules that are imported while the FMU runs.
"""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from .fmu import Fmu

HOSTS = ("pythonfmu", "pythonfmu3")  # packages that run such FMUs, which each of them brings
EXTENSIONS = (".so", ".pyd", ".dylib")
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
BY_NAME = frozenset({"pickle", "dill", "cloudpickle", "shelve", "multiprocessing", "concurrent", "joblib", "importlib"})
STANDARD = (b"_ZNSt", b"_ZNKSt", b"_ZZNSt", b"_ZZNKSt", b"_ZGVNSt", b"_ZGVZNSt", b"_ZNSs", b"_ZSt", b"_ZGVZNKSt")
DYNAMIC_SYMBOLS, UNIQUE, WRITABLE = 11, 10, 1  # ELF: sh_type, binding, sh_flags

SECTION = np.dtype([("name", "<u4"), ("type", "<u4"), ("flags", "<u8"), ("address", "<u8"), ("offset", "<u8"),
                    ("size", "<u8"), ("link", "<u4"), ("info", "<u4"), ("align", "<u8"), ("each", "<u8")])  # fmt: skip
SYMBOL = np.dtype([("name", "<u4"), ("info", "u1"), ("other", "u1"), ("section", "<u2"), ("value", "<u8"),
                   ("size", "<u8")])  # fmt: skip


def made_by_pythonfmu(fmu: Fmu) -> bool:
    """Whether an FMU is one of pythonfmu's: Python runs in it, and may compile for half a minute before time 0."""
    return (fmu.folder / "resources" / "slavemodule.txt").is_file()


def made_here(fmu: Fmu) -> bool:
    """Whether an FMU is one of the project's own, which keep nothing outside of their instances."""
    return str(fmu.description.generationTool or "").startswith("rovbrush ")


def imports_late(fmu: Fmu) -> str:
    """Why the Python modules of an FMU from elsewhere must stay where others find them; empty if they need not."""
    if made_here(fmu) or not made_by_pythonfmu(fmu):
        return ""
    return _late(fmu.folder / "resources")


def why_alone(fmu: Fmu) -> str:
    """Why a second use of an FMU in one process would meet the first; empty if it would not."""
    if fmu.interface.canBeInstantiatedOnlyOncePerProcess:
        return "it allows one instance per process (canBeInstantiatedOnlyOncePerProcess)"
    if made_here(fmu) or made_by_pythonfmu(fmu):
        return imports_late(fmu)
    return _shared_data(fmu.library)


@cache
def bundled(resources: Path) -> frozenset[str]:
    """The top-level Python modules that an FMU brings."""
    found = {path.name.split(".")[0] for path in resources.glob("*") if path.suffix in (".py", *EXTENSIONS)}
    return frozenset(found | {path.name for path in resources.glob("*") if path.is_dir() and any(path.rglob("*.py"))})


@cache
def _late(resources: Path) -> str:
    own = bundled(resources)
    files = [path for path in sorted(resources.rglob("*")) if path.relative_to(resources).parts[0] not in HOSTS]
    for path in files:
        if path.suffix in EXTENSIONS:
            return f"it brings Python modules in machine code ({path.name}), which a process loads once"
    for path in files:
        if path.suffix == ".py" and (found := _late_import(path, own)):
            return f"{path.name} imports {found} while it runs"
    return ""


def _late_import(path: Path, own: frozenset[str]) -> str:
    """A module that a file imports while the FMU runs, or that finds others by their names then."""
    try:
        tree = ast.parse(path.read_bytes())
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return "what cannot be read here"
    inside: set[ast.AST] = set()
    for function in ast.walk(tree):
        if isinstance(function, FUNCTIONS) and getattr(function, "name", "") != "__init__":  # that runs at once
            inside.update(ast.walk(function))
    for node in ast.walk(tree):
        for name in _imported(node):
            if name in BY_NAME or (node in inside and (name in own or not name)):
                return name or "a module beside it"
        if isinstance(node, ast.Name) and node.id in ("__import__", "import_module", "exec", "eval"):
            return f"modules by {node.id}"
    return ""


def _imported(node: ast.AST) -> list[str]:
    """Top-level names; empty for a module beside it."""
    if isinstance(node, ast.Import):
        return [alias.name.split(".")[0] for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        return ["" if node.level else str(node.module).split(".")[0]]
    return []


@cache
def _shared_data(library: Path) -> str:
    """What all copies of a library in a process would share."""
    if not library.is_file():
        return ""
    beside = sorted(p.name for p in library.parent.iterdir() if p != library and p.suffix in EXTENSIONS)
    beside = [name for name in beside if not name.startswith(".")]
    content = np.fromfile(library, dtype=np.uint8)
    needed = [name for name in beside if name.encode() in content.tobytes()] if beside else []
    if needed:
        return f"its library needs another one beside it ({needed[0]}), which a process loads once"
    try:
        name = _unique(content)
    except (ValueError, IndexError, OverflowError):  # no ELF file, or a damaged one
        return ""
    return f"its library shares data among all its copies in a process ({name}, STB_GNU_UNIQUE)" if name else ""


def _unique(content: np.ndarray) -> str:
    """A symbol of ELF that all copies share and that can be written; those of the C++ library itself are left out."""
    head = content[:64].tobytes()
    if head[:6] != b"\x7fELF\x02\x01":  # of 64 bits
        return ""
    at, size, count = (int.from_bytes(head[a:b], "little") for a, b in ((40, 48), (58, 60), (60, 62)))
    sections = np.frombuffer(content[at : at + size * count].tobytes(), dtype=SECTION)
    table: Any = sections[sections["type"] == DYNAMIC_SYMBOLS][0]
    begin, length = int(table["offset"]), int(table["size"])
    symbols = np.frombuffer(content[begin : begin + length // SYMBOL.itemsize * SYMBOL.itemsize].tobytes(), SYMBOL)
    names = sections[int(table["link"])]
    texts = content[int(names["offset"]) : int(names["offset"]) + int(names["size"])].tobytes()
    for symbol in symbols[(symbols["info"] >> 4 == UNIQUE) & (symbols["section"] < count) & (symbols["section"] > 0)]:
        name = texts[int(symbol["name"]) : texts.index(b"\0", int(symbol["name"]))]
        if sections[int(symbol["section"])]["flags"] & WRITABLE and not name.startswith(STANDARD):
            return name.decode("ascii", "replace")
    return ""
