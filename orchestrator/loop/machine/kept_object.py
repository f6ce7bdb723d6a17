"""The compiled loop as an object beside Numba's files: a run that loads it needs LLVM alone, not Numba.

That is 60 MB and a second less. It is written where the loop is compiled, for the processor that is there.
"""

# mypy: disable-error-code="no-untyped-call, no-any-return, unused-ignore"
# llvmlite has no types.

from __future__ import annotations

import hashlib
import os
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ...cache.cache import place
from . import shipped, written
from .objects import KIND, Loaded, data_layout, here, loaded_from, machine_code, write_whole
from .wrapped import NOTHING_TO_FREE, text_of

CHOICE = "ROVBRUSH_LOOP"  # set to `compile`: the loop is Numba's, see `shipped.py`

IMPOSSIBLE = ".none"  # ends the name of what says that this version of Numba makes none: nobody tries again


@cache
def _path(digest: str) -> Path:
    """Of the object of sources with a hash: where Numba keeps its own, or in the user's cache."""
    name = f"loop_{hashlib.sha256(chr(0).join([digest, here()]).encode()).hexdigest()[:24]}"
    chosen, own = os.environ.get("NUMBA_CACHE_DIR"), Path(__file__).with_name("__pycache__")
    if chosen:
        return Path(chosen) / "rovbrush" / f"{name}.o"
    if (own / f"{name}.o").is_file() or os.access(own if own.is_dir() else own.parent, os.W_OK):
        return own / f"{name}.o"
    return place(KIND, name) / f"{name}.o"


def wanted(digest: str) -> bool:
    """Whether one can be loaded here, and is to be."""
    if shipped.switched_off() or os.environ.get(CHOICE) == "compile" or find_spec("llvmlite") is None:
        return False
    return not _path(digest).with_suffix(IMPOSSIBLE).exists()


def is_there(digest: str) -> bool:
    """Whether there is one to be loaded."""
    return wanted(digest) and _path(digest).is_file()


@cache
def loaded(digest: str) -> Loaded | None:
    """The loop of sources with a hash; None where there is none, or where it is damaged."""
    if not is_there(digest):
        return None
    found = loaded_from(_path(digest))
    if found is None:
        _path(digest).unlink(missing_ok=True)
    return found


def keep(digest: str, made: Any) -> None:
    """Write that of Numba's object of the loop, freshly compiled. What does not fit is left to Numba."""
    path = _path(digest)
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        content = _object_of(text_of(made))
    except RuntimeError:
        path.with_suffix(IMPOSSIBLE).touch()
    else:
        write_whole(path, content)


def keep_written(digest: str) -> bool:
    """Write that of the text which lies beside the sources; whether there was one that fits."""
    text = written.text(digest) if wanted(digest) else None
    if text is None:
        return False
    path = _path(digest)
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        write_whole(path, _object_of(text))
    except RuntimeError:
        return False  # of another version of LLVM: Numba compiles
    return path.is_file()


def _object_of(text: str) -> bytes:
    """Machine code of the loop's text, which is optimised. Raises RuntimeError where LLVM does not take it."""
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = llvm.get_process_triple(), data_layout()
    empty = f'target triple = "{module.triple}"\ntarget datalayout = "{module.data_layout}"\n'
    module.link_in(llvm.parse_assembly(f"{empty}define void @{NOTHING_TO_FREE}(ptr %array) {{ ret void }}\n"))
    return machine_code(module)
