"""Where compiled kernels are kept, so that a damaged file is noticed and another user's is never run.

The folder and its layout are those of the program that runs the FMUs, by convention: an entry `kernels/NAME/` with
`kernel.py`, Numba's files and `used`, which is as old as the last use; what a process needs stands in a file of its own
in `users/`, locked while the process lives; who writes there holds the file `lock` together with others.
"""

# mypy: disable-error-code="no-untyped-call"
# Numba's cache has no types.

from __future__ import annotations

import atexit
import hashlib
import io
import os
import shutil
import tempfile
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from numba.core.caching import FunctionCache, IndexDataCacheFile

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
    try:
        top = _private(_cache_folder())
        _need(top, f"kernels/{name}")
        folder = _private(_private(top / "kernels") / name)
        (folder / "used").touch(mode=0o600)
        return _written(folder, text)
    except DistrustedError:
        raise
    except OSError:
        folder = Path(tempfile.mkdtemp(prefix="rovbrush_"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        return _written(folder, text)


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


class _CheckedFile(IndexDataCacheFile):
    """Numba's files, each with the hash of its content behind it: what is damaged is compiled anew.

    Numba numbers the files of a function: two processes that compile it at one time for different types could take the
    same number, each believing the file its own. Here no two files have the same name.
    """

    def _load_index(self) -> Any:
        return super()._load_index() if _whole(self._index_path) else {}

    def _load_data(self, name: str) -> Any:
        if not _whole(self._data_path(name)):
            raise FileNotFoundError(name)  # which Numba takes for a file that somebody has removed
        return super()._load_data(name)

    def _data_name(self, number: int) -> str:
        return str(super()._data_name(number)).replace(".nbc", f"_{uuid.uuid4().hex[:12]}.nbc")

    @contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[io.BytesIO]:
        content = io.BytesIO()
        yield content
        with super()._open_for_write(filepath) as file:
            file.write(content.getvalue() + hashlib.sha256(content.getvalue()).digest())


def _whole(path: str) -> bool:
    """Is a file there, and the hash at its end that of what stands before it?"""
    try:
        content = Path(path).read_bytes()
    except OSError:
        return False
    return hashlib.sha256(content[:-DIGEST]).digest() == content[-DIGEST:]


class CheckedCache(FunctionCache):
    """Numba's cache of one function, by `_CheckedFile`."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._cache_file = _CheckedFile(
            cache_path=self._cache_path,
            filename_base=self._impl.filename_base,
            source_stamp=self._impl.locator.get_source_stamp(),
        )
