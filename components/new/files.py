"""A folder that is written whole or not at all, and names that it may have."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Callable
from pathlib import Path

from ..errors import NewComponentError


def write_whole(target: Path, fill: Callable[[Path], object]) -> Path:
    """Let `fill` write into a hidden folder beside `target`, then give it that name.

    Raises NewComponentError if something is there already, or the disk refuses.
    """
    require_free(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".{target.name}_", dir=target.parent) as temporary:
            made = Path(temporary) / target.name
            made.mkdir()
            fill(made)
            made.rename(target)
    except OSError as error:
        raise NewComponentError(f"cannot write {target}: {error.strerror}; see --folder") from error
    return target


def require_free(target: Path) -> None:
    """Nothing is there yet. Raises NewComponentError."""
    if os.path.lexists(target):
        raise NewComponentError(f"{target} exists; choose another name, or another place with --folder")
    if target.parent.exists() and not target.parent.is_dir():
        raise NewComponentError(f"{target.parent} is no folder; choose another place with --folder")


def require_name(name: str, what: str, example: str) -> None:
    """A name is a Python module's and an FMI modelIdentifier, which is a C identifier. Raises NewComponentError."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name) or len(name) > 64:
        raise NewComponentError(
            f"'{name}' is no name for a {what}: a letter, then letters, digits and _, 64 at most, as `{example}`"
        )
