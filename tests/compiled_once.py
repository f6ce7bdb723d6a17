"""Libraries that the FMUs of a session share: the same C sources are compiled once, whichever folder asks first."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from filelock import FileLock
from rovbrush.components.native import build
from rovbrush.components.native.compile import OPTIONS, Platform, compile_library


@contextmanager
def libraries_compiled_once(kept: Path) -> Iterator[None]:
    """Builds of FMUs take libraries from the folder `kept` and put new ones there.

    Only for what tests start from: a test that builds FMUs itself compiles them anew. `kept` is of one session, in
    which the compiler does not change.
    """
    kept.mkdir(exist_ok=True)

    def compiled(sources: Path, files: tuple[str, ...], target: Platform) -> bytes:
        library = kept / _key(sources, files, target)
        with FileLock(f"{library}.lock"):
            if not library.exists():
                made = library.with_suffix(".made")
                made.write_bytes(compile_library(sources, files, target))
                os.replace(made, library)
        return library.read_bytes()

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "compile_library", compiled)
        yield


def _key(sources: Path, files: tuple[str, ...], target: Platform) -> str:
    """Of all that decides about the bytes of a library."""
    found = hashlib.sha256(repr((OPTIONS, target, target.compiler(), files)).encode())
    for path in sorted(path for path in sources.rglob("*") if path.is_file()):
        content = path.read_bytes()
        found.update(f"\n{path.relative_to(sources).as_posix()} {len(content)}\n".encode() + content)
    return found.hexdigest()
