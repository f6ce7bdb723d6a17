"""Where compiled kernels are kept, so that a damaged file is noticed and another user's is never run.

The folder and its layout are those of the program that runs the FMUs, by convention: an entry `kernels/NAME/` with
`kernel.o`, or `kernel.py` and Numba's files (`numba_files.py`), and `used`, which is as old as the last use; what a
process needs stands in a file of its own in `users/`, locked while the process lives; who writes there holds the file
`lock` together with others.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import shutil
import tempfile
import uuid
from contextlib import suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

DIGEST = hashlib.sha256().digest_size


class DistrustedError(OSError):
    """A folder of the cache is not this user's alone."""


def stored(name: str, text: str) -> Path:
    """The file of a kernel in the cache, with exactly this text; in a folder of this process where there is no cache.

    Raises DistrustedError for a cache folder that belongs to another user, or that others can write to.
    """
    return _written(entry_folder(name), text)


def entry_folder(name: str) -> Path:
    """The folder of an entry in the cache, in use from now on; one of this process where there is no cache.

    Raises DistrustedError as `stored` does.
    """
    try:
        top = _private(_cache_folder())
        _need(top, f"kernels/{name}")
        folder = _private(_private(top / "kernels") / name)
        (folder / "used").touch(mode=0o600)
        return folder
    except DistrustedError:
        raise
    except OSError:
        folder = Path(tempfile.mkdtemp(prefix="rovbrush_"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        return folder


def _cache_folder() -> Path:
    own = os.environ.get("ROVBRUSH_CACHE")
    if own:
        return Path(own).absolute()
    shared = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    return (Path(shared).absolute() if shared else Path.home() / ".cache") / "rovbrush"


def _private(folder: Path) -> Path:
    """The folder, made if need be, that only this user writes to."""
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    status = folder.stat()
    if hasattr(os, "geteuid") and {status.st_uid, folder.lstat().st_uid} != {os.geteuid()}:
        raise DistrustedError(
            f"cache folder {folder} belongs to another user (uid {status.st_uid}), whose code would be run from it; "
            f"set ROVBRUSH_CACHE to a folder of your own"
        )
    if hasattr(os, "geteuid") and status.st_mode & 0o022:
        raise DistrustedError(
            f"other users can write to the cache folder {folder} (mode {status.st_mode & 0o777:o}), and their code "
            f"would be run from it; remove it, or `chmod go-w {folder}`, or set ROVBRUSH_CACHE to another folder"
        )
    return folder


def _need(top: Path, entry: str) -> None:
    """Say that this process needs an entry until it ends, so that nobody throws it away."""
    if not fcntl:  # there a folder is not moved while a library in it is loaded
        return
    users = _private(top / "users")
    name = f"{os.getpid()}_{uuid.uuid4().hex[:12]}"
    with (top / "lock").open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_SH)
        file = os.open(users / f"new_{name}", os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)  # open until the process ends
        fcntl.flock(file, fcntl.LOCK_EX)
        os.write(file, f"{entry}\n".encode())
        (users / f"new_{name}").rename(users / name)


def _written(folder: Path, text: str) -> Path:
    """The file `kernel.py` in a folder, with exactly this text."""
    path = folder / "kernel.py"
    if not path.is_file() or path.read_bytes() != text.encode():
        temporary = path.with_name(f"kernel.{uuid.uuid4().hex[:12]}.tmp")
        temporary.write_bytes(text.encode())
        temporary.replace(path)
    return path


def keep(path: Path, content: bytes) -> None:
    """Write a file of the cache with the hash of its content behind it; where that fails nothing is kept."""
    temporary = path.with_name(f"{path.name}.{uuid.uuid4().hex[:12]}.tmp")
    with suppress(OSError):
        temporary.write_bytes(content + hashlib.sha256(content).digest())
        temporary.replace(path)


def kept(path: Path) -> bytes | None:
    """What `keep` wrote; None where it is not there, or damaged."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    return content[:-DIGEST] if hashlib.sha256(content[:-DIGEST]).digest() == content[-DIGEST:] else None
