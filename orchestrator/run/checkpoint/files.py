"""The files of a checkpoint: hashed, checked, and found again where a process was killed while it renamed them."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...files import is_alive

FORMAT = 3
NAME, HEAD, SEAL, ARRAYS, ROWS = "checkpoint", "checkpoint.json", "checkpoint.sha256", "arrays.npz", "rows.nc"
EVENTS = "events.rows"
LEFT = re.compile(rf"\.{NAME}\.(?P<pid>\d+)\.(?:tmp|old)")


class CheckpointDamagedError(Exception):
    """A checkpoint is not what was written."""


def seal(folder: Path, head: Mapping[str, Any]) -> None:
    """Write the head of a checkpoint whose other files are there, and bring all to disk. Raises OSError."""
    files = {path.name: _hash(path) for path in sorted(folder.iterdir())}
    text = json.dumps({"format": FORMAT, **head, "files": files}, indent=1) + "\n"
    (folder / HEAD).write_text(text, encoding="utf-8")
    (folder / SEAL).write_text(f"{_hash(folder / HEAD)}  {HEAD}\n", encoding="utf-8")
    for path in (*folder.iterdir(), folder):
        descriptor = os.open(path, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def read_head(folder: Path) -> dict[str, Any]:
    """The head of a checkpoint, all of whose files are as they were written. Raises CheckpointDamagedError, OSError."""
    if not (folder / SEAL).exists() and (folder / HEAD).exists():
        raise CheckpointDamagedError(f"{SEAL} is missing (an earlier version of rovbrush wrote none)")
    if _hash(folder / SEAL) != hashlib.sha256(f"{_hash(folder / HEAD)}  {HEAD}\n".encode()).hexdigest():
        raise CheckpointDamagedError(f"{HEAD} is not what was written")
    head: dict[str, Any] = json.loads((folder / HEAD).read_text(encoding="utf-8"))
    if head["format"] != FORMAT:
        raise CheckpointDamagedError(f"it has format {head['format']}, this version of rovbrush reads {FORMAT}")
    for name, digest in head["files"].items():
        if Path(name).name != name or _hash(folder / name) != digest:
            raise CheckpointDamagedError(f"{name} is not what was written")
    return head


def found_in(folder: Path) -> Path | None:
    """The checkpoint in a results folder, None if there is none. One under a temporary name gets its own back."""
    target = folder / NAME
    if not target.exists() and folder.is_dir():
        for left in _left(folder):
            if _is_whole(left):
                try:
                    left.rename(target)
                except OSError:  # it can be read where it is
                    return left
                break
    return target if (target / HEAD).exists() or (target / SEAL).exists() else None


def _left(folder: Path) -> list[Path]:
    """What processes that are no more left of checkpoints; the latest first."""
    found = [(path, LEFT.fullmatch(path.name)) for path in folder.iterdir()]
    dead = [path for path, match in found if match and not is_alive(int(match["pid"]))]
    return sorted(dead, key=lambda path: (path.suffix == ".tmp", path.stat().st_mtime_ns), reverse=True)


def _is_whole(folder: Path) -> bool:
    try:
        read_head(folder)
    except (CheckpointDamagedError, OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return False
    return True


def _hash(path: Path) -> str:
    """Of a file; a pipe or a device is none. Raises OSError."""
    if not path.is_file():
        raise CheckpointDamagedError(f"{path.name} is {'no file' if path.exists() else 'missing'}")
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
