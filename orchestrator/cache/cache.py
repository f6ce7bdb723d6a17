"""The user's cache folder: whom it must belong to, what is in it, and how it stays small.

    fmus/HASH/       an unpacked archive (`fmu/files/unpacked.py`)
    kernels/NAME/    a compiled kernel (`components/python/kernel_cache.py`, which knows this layout by convention)
    loops/NAME/      machine code of a plan (`loop/machine/objects.py`)
    servers/NAME/    what loads FMUs for Windows (`participant/windows/build.py`)
    users/, lock     what living processes need (`users.py`)
    moving/          what is being unpacked or thrown away just now

An entry is as old as its file `used`, or `.rovbrush/used`.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_cache_path

from ..errors import FmuError, InputError
from . import users

LIMIT = "2 GB"  # how much may stay, unless ROVBRUSH_CACHE_LIMIT says otherwise
UNITS = {"": 1, "B": 1, "kB": 10**3, "MB": 10**6, "GB": 10**9, "TB": 10**12}
# What may be thrown away; anything else in the folder is not ours. Bare files and __pycache__ are of older versions.
ENTRIES = {
    "fmus": r"[0-9a-f]{24}|unpacking-\w+",
    "kernels": r"\w+_[0-9a-f]{24}(\.py)?|__pycache__",
    "loops": r"\w+_[0-9a-f]{24}",
    "servers": r"win\d\d_[0-9a-f]{24}",
    "moving": r"\w+",
}

_room: dict[Path, int] = {}  # by cache folder: bytes that may still come before it is looked through again


@dataclass(frozen=True)
class Entry:
    """One unpacked archive or compiled kernel: its size in bytes, and when it was `used` last [s since 1970]."""

    kind: str
    path: Path
    size: int
    used: float
    needed: bool  # by a living process


def cache_folder() -> Path:
    """$ROVBRUSH_CACHE or the user's cache; plain ASCII, because some FMUs fail elsewhere.

    Raises FmuError if it cannot be made, or if others could have put something there.
    """
    chosen = os.environ.get("ROVBRUSH_CACHE")
    folder = Path(chosen).absolute() if chosen else user_cache_path("rovbrush")  # FMI takes it as a URI
    if not str(folder).isascii():
        raise FmuError(
            f"cache folder {folder}: FMUs cannot be loaded from a path beyond plain ASCII; "
            f"set ROVBRUSH_CACHE to another folder"
        )
    return _made(folder)


def place(kind: str, name: str) -> Path:
    """Where an entry is, or will be: this process needs it from now on. Raises FmuError as `cache_folder` does."""
    top = cache_folder()
    users.need(top, f"{kind}/{name}")
    entry = _made(top / kind) / name
    if entry.exists():
        check_private(entry)
    return entry


def _made(folder: Path) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        check_private(folder)
    except OSError as error:
        raise FmuError(
            f"cannot write to the cache folder {folder}: {error.strerror}; set ROVBRUSH_CACHE to another folder"
        ) from error
    return folder


def check_private(folder: Path) -> None:
    """Raises FmuError if a folder of the cache belongs to another user, or others may write to it."""
    if not hasattr(os, "geteuid"):
        return
    status = folder.stat()
    for owner in (folder.lstat().st_uid, status.st_uid):  # of a link, and of where it leads
        if owner != os.geteuid():
            raise FmuError(
                f"cache folder {folder} belongs to another user (uid {owner}), whose code would be run from it; "
                f"set ROVBRUSH_CACHE to a folder of your own"
            )
    if status.st_mode & 0o022:
        raise FmuError(
            f"other users can write to the cache folder {folder} (mode {status.st_mode & 0o777:o}), and their code "
            f"would be run from it; remove it, or `chmod go-w {folder}`, or set ROVBRUSH_CACHE to another folder"
        )


def mark_used(folder: Path) -> None:
    """An entry is in use now; the folder is where its file `used` belongs."""
    with suppress(OSError):
        (folder / "used").touch(mode=0o600)


@contextmanager
def workspace() -> Iterator[Path]:
    """An empty folder on the disk of the cache, gone in the end; what is made there is renamed to where it belongs."""
    folder = _made(place("moving", f"{os.getpid()}_{os.urandom(6).hex()}"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def limit() -> int:
    """How many bytes the cache may hold. Raises InputError for a setting that is no size."""
    text = os.environ.get("ROVBRUSH_CACHE_LIMIT") or LIMIT
    match = re.fullmatch(r"([0-9]{1,12}(?:\.[0-9]{1,12})?) ?([kMGT]?B|)", text.strip())
    if not match:
        raise InputError(f'ROVBRUSH_CACHE_LIMIT = {text!r} is no size; write for instance "{LIMIT}" or "500 MB"')
    return int(float(match[1]) * UNITS[match[2]])


def entries() -> list[Entry]:
    """What is in the cache, the latest used first."""
    top = cache_folder()
    needed = users.needed(top)
    found = [
        Entry(kind, path, size_of(path), used(path), f"{kind}/{path.name}" in needed)
        for kind, pattern in ENTRIES.items()
        for path in ((top / kind).iterdir() if (top / kind).is_dir() else ())
        if re.fullmatch(pattern, path.name) and not path.is_symlink()
    ]
    return sorted(found, key=lambda entry: (-entry.used, entry.path))


def used(entry: Path) -> float:
    """When an entry was used last [s since 1970]; 0 for one that has just gone."""
    for path in (entry / "used", entry / ".rovbrush" / "used", entry):
        with suppress(OSError):
            return path.stat().st_mtime
    return 0.0


def size_of(path: Path) -> int:
    """Bytes in a file, or in all files of a folder; what cannot be looked at, or has just gone, counts nothing."""
    with suppress(OSError):
        if not path.is_dir():
            return path.lstat().st_size
        with os.scandir(path) as found:
            return sum(
                size_of(Path(item)) if item.is_dir(follow_symlinks=False) else item.stat(follow_symlinks=False).st_size
                for item in found
            )
    return 0


def grew(size: int) -> None:
    """So many bytes have come; where they may be too many, the least recently used entries go. Raises InputError."""
    top = cache_folder()
    _room[top] = _room.get(top, 0) - size
    if _room[top] < 0:
        allowed = limit()
        left = sum(entry.size for entry in prune(allowed))
        _room[top] = max(allowed - left, allowed // 16)  # what is needed can exceed the limit: do not look each time


def prune(allowed: int) -> list[Entry]:
    """Throw entries away, the least recently used first, until `allowed` bytes are left, and what dead processes left.

    What living processes need stays. Returns the entries that are left.
    """
    top = cache_folder()
    with workspace() as bin_, users.lock(top, alone=True) as alone:
        left = entries()
        total = sum(entry.size for entry in left)
        for entry in reversed(left.copy()) if alone else ():  # else the next process that adds something prunes
            if not entry.needed and (total > allowed or entry.kind == "moving"):
                with suppress(OSError):
                    entry.path.rename(bin_ / f"{entry.kind}_{entry.path.name}")
                    left.remove(entry)
                    total -= entry.size
    return [entry for entry in left if entry.kind != "moving"]


def clear() -> tuple[int, list[Entry]]:
    """Throw everything away that no living process needs; returns the bytes that are gone, and what is left."""
    before = sum(entry.size for entry in entries())
    left = prune(-1)
    return before - sum(entry.size for entry in left), left
