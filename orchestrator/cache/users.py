"""Which entries of the cache living processes need: each process has a file in `users/` that it keeps locked.

A lock ends with its process, however it ends. Whoever registers an entry holds the file `lock` together with others,
whoever throws entries away holds it alone: an entry that was registered before is seen, one after is unpacked anew.
Where a system has no `flock` nothing is known of other processes; it refuses to move a folder with loaded libraries.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

PATIENCE = 1.0  # s to wait for the lock alone; it is held for milliseconds
NEW, STILLBORN = (
    "new_",
    60.0,
)  # how the name of a file begins until it is locked, and after how many seconds it never is

_own: dict[Path, Register] = {}  # by cache folder
_guard = threading.Lock()


class Register:
    """This process's file in `users/`, locked as long as it lives."""

    def __init__(self, top: Path) -> None:
        """Raises OSError where the folder cannot be written to."""
        self.needed: list[str] = []
        users = top / "users"
        users.mkdir(mode=0o700, exist_ok=True)
        needed(top)  # removes the files of dead processes
        path = users / f"{NEW}{os.getpid()}_{os.urandom(6).hex()}"
        self.file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_APPEND, 0o600)
        if fcntl:
            fcntl.flock(self.file, fcntl.LOCK_EX)
            path.rename(users / path.name.removeprefix(NEW))  # locked under this name from the first instant
        self.identity = os.fstat(self.file)

    @property
    def lost(self) -> bool:
        """Has an FMU closed the file? Its number can be that of another file by now."""
        try:
            return not os.path.samestat(os.fstat(self.file), self.identity)
        except OSError:
            return True

    def add(self, entry: str) -> None:
        if entry not in self.needed:
            os.write(self.file, f"{entry}\n".encode())
            self.needed.append(entry)


@contextmanager
def lock(top: Path, alone: bool = False) -> Iterator[bool]:
    """Hold the cache's lock, with others or alone; gives False where it cannot be had alone within `PATIENCE`.

    Raises OSError where the folder cannot be written to.
    """
    file = os.open(top / "lock", os.O_RDWR | os.O_CREAT, 0o600)
    try:
        yield _locked(file, alone)
    finally:
        os.close(file)


def _locked(file: int, alone: bool) -> bool:
    if not fcntl:
        return True
    if not alone:
        fcntl.flock(file, fcntl.LOCK_SH)
        return True
    end = time.monotonic() + PATIENCE
    while True:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if time.monotonic() > end:
                return False
            time.sleep(0.01)
        else:
            return True


def need(top: Path, entry: str) -> None:
    """Say that this process needs an entry, `KIND/NAME`, until it ends; it may not be there yet.

    A cache that cannot be written to is passed over: nobody can throw anything away there.
    """
    with suppress(OSError), _guard:
        register = _own.get(top)
        if register is not None and entry in register.needed and not register.lost:
            return
        with lock(top):
            if register is None or register.lost:
                before = register.needed if register else []
                register = _own[top] = Register(top)
                for known in before:
                    register.add(known)
            register.add(entry)


def needed(top: Path) -> set[str]:
    """The entries that living processes need; files of dead ones are removed."""
    found: set[str] = set()
    users = top / "users"
    for path in sorted(users.iterdir()) if users.is_dir() else []:
        with suppress(OSError):
            if _alive(path):
                found.update(path.read_text(encoding="utf-8").splitlines())
            elif not path.name.startswith(NEW) or time.time() - path.stat().st_mtime > STILLBORN:
                path.unlink()
    return found


def _alive(path: Path) -> bool:
    """Does a process hold its file?"""
    if not fcntl:
        return False
    file = os.open(path, os.O_RDWR)
    try:
        fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(file)
    return False
