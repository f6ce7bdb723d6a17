"""C libraries for tests: the same sources under the same options are compiled once, for all workers and sessions."""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

from filelock import FileLock
from rovbrush.orchestrator.studies.bench.fmus import native


def kept_folder() -> Path:
    """Where they are; known when pytest is configured."""
    return Path(os.environ.get("ROVBRUSH_CACHE", tempfile.gettempdir())).absolute().parent / "compiled_for_tests"


def remember_libraries() -> None:
    """What the project itself compiles for benchmarks and tests (`bench/fmus/native.py`) is remembered, too."""
    really = native.compiled

    def compiled(command: Sequence[str], sources: Sequence[Path]) -> bytes:
        return compiled_once(command, sources, lambda library: library.write_bytes(really(command, sources)))

    native.compiled = compiled


def compiled_once(command: Sequence[str], sources: Sequence[Path], compile_to: Callable[[Path], object]) -> bytes:
    """The library that `compile_to` makes of `sources`, or made before; `command`: compiler and options."""
    digest = hashlib.sha256("\0".join(command).encode())
    included = {header for source in sources for header in source.parent.glob("*.[hc]")}
    included |= {header for part in command if part.startswith("-I") for header in Path(part[2:]).glob("*.h")}
    for source in (*sources, *sorted(included)):
        digest.update(f"{source.name} {_digest(source, source.stat().st_mtime_ns)} ".encode())
    folder = kept_folder()
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder / f"{digest.hexdigest()[:24]}.library"
    if not kept.exists():
        with FileLock(kept.with_suffix(".lock")):
            if not kept.exists():
                made = kept.with_suffix(".new")
                compile_to(made)
                made.replace(kept)
    return kept.read_bytes()


@cache
def _digest(path: Path, _: int) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
