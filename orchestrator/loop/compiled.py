"""The compiled life of the loop, and the name under which Numba keeps it.

Numba's cache on disk looks at the date of one file, `run.py`; other files of the loop may change behind its back.
So the name of what is compiled holds a hash of all of them: code compiled from other text is never taken.
"""

from __future__ import annotations

import ast
import hashlib
import subprocess
import sys
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

from . import run as loop

IN_CHILD = False  # set in the process that compiles for another
COMPILE = f"from {__name__.rpartition('.')[0]} import compiled; compiled.IN_CHILD = True; compiled.compiled_run()"


def loop_files(top: Path) -> list[Path]:
    """A file and all files of the package from which it or they import, in alphabetical order."""
    found: set[Path] = set()
    waiting = [top]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.ImportFrom) and node.level:
                    folder = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
                    names = [folder.with_suffix(".py"), *(folder / f"{alias.name}.py" for alias in node.names)]
                    waiting += [file for file in names if file.is_file()]
    return sorted(found)


def loop_hash(top: Path) -> str:
    """A hash of the texts of `loop_files`."""
    texts = [path.read_bytes() for path in loop_files(top)]
    return hashlib.sha256(b"\0".join(texts)).hexdigest()[:24]


@cache
def _named_run() -> tuple[str, Any]:
    """The loop, not compiled yet, and the name under which it is kept."""
    import numba

    from .compiled_files import CheckedCache

    name = f"run_{loop_hash(Path(loop.__file__))}"
    run = FunctionType(loop.run.__code__, vars(loop))
    run.__qualname__ = name
    compiled: Any = numba.njit(error_model="numpy")(run)
    compiled._cache = CheckedCache(run)
    return name, compiled


def _is_kept(name: str, compiled: Any) -> bool:
    return any(Path(compiled.stats.cache_path or ".").glob(f"*{name}*.nbi"))


def is_compiled() -> bool:
    """Whether the loop need not be compiled: it was, on this machine, or it is not to be."""
    return not numba_compiles() or _is_kept(*_named_run())


def numba_compiles() -> bool:
    """Whether the environment lets Numba compile; with NUMBA_DISABLE_JIT everything is plain Python."""
    import numba

    return not numba.config.DISABLE_JIT  # type: ignore[attr-defined]


@cache
def compiled_run() -> Any:
    """`run.run` under Numba. Its compiled form holds no address, so one cached compilation serves every system.

    What is not in the cache yet is compiled by a process of its own: the compiler's 100 MB end with it. Where the
    environment switches Numba off (NUMBA_DISABLE_JIT) it is the interpreter.
    """
    import numba

    if not numba_compiles():
        return loop.run
    name, compiled = _named_run()
    if not IN_CHILD and not _is_kept(name, compiled):
        # Should it fail, this process compiles for itself, and says what is wrong.
        subprocess.run([sys.executable, "-c", COMPILE], capture_output=True, check=False)
    table, cells, numbers, raw = numba.int64[:, ::1], numba.int64[::1], numba.float64[::1], numba.uint8[::1]
    signals = (numbers, cells, raw, numba.float32[::1], raw, cells)
    results, repeated = (cells, table, numbers, cells), (cells, numbers, numbers, numbers, cells, table)
    compiled.compile((table, numbers, table, table, *signals, *results, cells, *repeated, *(numba.int64,) * 5))
    return compiled
