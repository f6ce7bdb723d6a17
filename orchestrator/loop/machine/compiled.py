"""The loop as machine code, and the name under which Numba keeps what it compiles.

Numba's cache on disk looks at the date of one file; other files may change behind its back. So the name of what is
compiled holds a hash of all of them: code compiled from other text is never taken.
"""

from __future__ import annotations

import ast
import hashlib
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import FunctionType
from typing import Any

from .. import run as loop
from . import kept_object, shipped, written
from .frame import Loop
from .wrapped import ENTRY as NAME
from .wrapped import ONE

ENTRY = Path(__file__).with_name("entry.py")  # what the loop is compiled from
IN_CHILD = False  # set in the process that compiles for another
COMPILE = f"from {__name__.rpartition('.')[0]} import compiled; compiled.IN_CHILD = True; compiled.{{}}()"
OPTIONS = {"error_model": "numpy"}


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
def own_hash() -> str:
    """That of the loop."""
    return loop_hash(ENTRY)


class Kept:
    """A function that Numba compiles to one of C, and keeps under a name that holds a hash of its sources."""

    def __init__(self, function: Callable[..., int], digest: str, **options: Any) -> None:
        from .kept import CheckedCache

        self._named = FunctionType(function.__code__, vars(sys.modules[function.__module__]))
        self._named.__qualname__ = f"{function.__name__}_{digest}"
        self._files, self._options = CheckedCache(self._named), OPTIONS | options

    @property
    def is_there(self) -> bool:
        """Whether it was compiled before."""
        return any(Path(self._files.cache_path).glob(f"*{self._named.__qualname__}*.nbi"))

    def compiled(self, signature: Any, anew: bool = False) -> Any:
        """Numba's object: its `address` is that of the function as long as it lives. `anew`: not what is kept."""
        from numba.core.ccallback import CFunc
        from numba.core.sigutils import normalize_signature

        normal = normalize_signature(signature)  # type: ignore[no-untyped-call]
        made: Any = CFunc(self._named, normal, {}, self._options)
        if not anew:
            made._cache = self._files
        made.compile()
        return made


@cache
def _kept_loop() -> Kept:
    from .entry import entry

    return Kept(entry, own_hash())


def is_compiled() -> bool:
    """Whether the loop need not be compiled: it came with the package, it was before, its text is there, or it is not
    to be."""
    if shipped.library(own_hash()) or kept_object.is_there(own_hash()) or _is_written():
        return True
    return not numba_compiles() or (not kept_object.wanted(own_hash()) and _kept_loop().is_there)


def _is_written() -> bool:
    """Whether the loop's text lies beside its sources, of which an object is made in a second."""
    return kept_object.wanted(own_hash()) and written.text(own_hash()) is not None


def begin() -> subprocess.Popen[bytes] | None:
    """A process that compiles the loop, to be waited for; None where there is nothing to compile, or no compiler."""
    here = shipped.library(own_hash()) or kept_object.is_there(own_hash())
    if here or (not _is_written() and (find_spec("numba") is None or is_compiled())):
        return None
    command = [sys.executable, "-c", COMPILE.format("make")]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def numba_compiles() -> bool:
    """Whether the environment lets Numba compile; with NUMBA_DISABLE_JIT everything is plain Python."""
    if shipped.switched_off():
        return False
    import numba

    return not numba.config.DISABLE_JIT  # type: ignore[attr-defined]


def require_loop() -> None:
    """Raises InputError where there is neither a library nor what compiles the loop."""
    if shipped.library(own_hash()) or find_spec("numba") is not None or shipped.switched_off() or _is_written():
        return
    if not kept_object.is_there(own_hash()):
        raise shipped.nothing_compiles()


def make() -> None:
    """Keep the loop's object: of its text where that is written, else of what Numba compiles."""
    if kept_object.is_there(own_hash()) or not kept_object.keep_written(own_hash()):
        compiled_loop()


@cache
def compiled_loop() -> Any:
    """`entry.entry` under Numba. It holds no address of a system, so one compilation serves all of them.

    What is not in the cache yet is compiled by a process of its own: the compiler's 100 MB end with it. It leaves an
    object too, with which later runs need no Numba.
    """
    from .entry import SIGNATURE

    if not IN_CHILD and not _kept_loop().is_there:
        _compile_apart("compiled_loop")
    if not IN_CHILD or kept_object.is_there(own_hash()):
        return _kept_loop().compiled(SIGNATURE)
    made = _kept_loop().compiled(SIGNATURE, anew=_kept_loop().is_there)  # what Numba has kept has no text
    kept_object.keep(own_hash(), made)
    return made


def _compile_apart(how: str = "make") -> None:
    """In a process of its own. Should it fail, this process compiles for itself, and says what is wrong."""
    subprocess.run([sys.executable, "-c", COMPILE.format(how)], capture_output=True, check=False)


def compiled_run(waits: bool = False) -> Callable[..., int]:
    """`run.run` as machine code, for one session: from the library that came with the package, from what Numba has
    compiled before, or compiled now.

    `waits`: other threads go on while it runs. Where the environment switches Numba off (NUMBA_DISABLE_JIT) it is the
    interpreter. Raises InputError where there is neither.
    """
    if shipped.switched_off():
        return loop.run
    if library := shipped.library(own_hash()):
        one = library.address_of(ONE) if library.has(ONE) else 0
        return Loop(library.address, library, waits, one=one)
    require_loop()
    if not kept_object.is_there(own_hash()) and _is_written():
        _compile_apart()
    if not kept_object.is_there(own_hash()):
        if not numba_compiles():
            return loop.run
        if kept_object.wanted(own_hash()):
            _compile_apart()
    if found := kept_object.loaded(own_hash()):
        return Loop(found.address(NAME), found, waits, one=found.address(ONE))
    made = compiled_loop()
    return Loop(made.address, made, waits)
