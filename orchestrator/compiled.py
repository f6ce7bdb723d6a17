"""The compiled life of the loop, and the name under which Numba keeps it.

Numba's cache on disk looks at the date of one file, `execute.py`; other files of the loop may change behind its back.
So the name of what is compiled holds a hash of all of them: code compiled from other text is never taken.
"""

from __future__ import annotations

import ast
import hashlib
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

from . import execute


def loop_files(top: Path) -> list[Path]:
    """A file and all files of its folder from which it or they import, in alphabetical order."""
    found: set[Path] = set()
    waiting = [top]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.ImportFrom) and node.level:
                    names = [node.module] if node.module else [alias.name for alias in node.names]
                    waiting += [path.with_name(f"{name}.py") for name in names]
    return sorted(found)


def loop_hash(top: Path) -> str:
    """A hash of the texts of `loop_files`."""
    texts = [path.read_bytes() for path in loop_files(top)]
    return hashlib.sha256(b"\0".join(texts)).hexdigest()[:24]


@cache
def compiled_run() -> Any:
    """`execute.run` under Numba. Its compiled form holds no address, so one cached compilation serves every system."""
    import numba

    run = FunctionType(execute.run.__code__, vars(execute))
    run.__qualname__ = f"run_{loop_hash(Path(execute.__file__))}"
    compiled = numba.njit(cache=True, error_model="numpy")(run)
    table, cells, numbers, raw = numba.int64[:, ::1], numba.int64[::1], numba.float64[::1], numba.uint8[::1]
    signals = (numbers, cells, raw, numba.float32[::1], raw, cells)
    results, repeated = (cells, table, numbers, cells), (cells, numbers, numbers, cells, table)
    compiled.compile((table, numbers, table, table, *signals, *results, cells, *repeated, *(numba.int64,) * 5))
    return compiled
