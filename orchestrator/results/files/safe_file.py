"""A file for HDF5 to write to, which ends the process where a disk refuses: it does not see that here."""

from __future__ import annotations

import errno
import io
import os
from pathlib import Path
from typing import Any

FLAGS = os.O_RDWR | getattr(os, "O_BINARY", 0)


class SafeFile(io.RawIOBase):
    """Takes whatever is written. What the disk refused is in `error`; nothing that comes after it is written.

    The descriptor is looked at before it is used: where an FMU has closed it, or put another file in its place, the
    file is opened anew by its path. A file that was removed lives on as long as its descriptor.
    """

    def __init__(self, path: Path, new: bool) -> None:
        super().__init__()
        self.path = path
        self.error: OSError | None = None
        self._at = 0
        self._descriptor = os.open(path, FLAGS | (os.O_CREAT | os.O_TRUNC if new else 0), 0o666)
        self._identity = identity(self._descriptor)

    @property
    def descriptor(self) -> int:
        """A descriptor that leads to the file. Raises OSError if there is none."""
        if identity(self._descriptor) != self._identity:
            found = os.open(self.path, FLAGS)
            if identity(found) != self._identity:
                os.close(found)
                raise OSError(errno.EBADF, os.strerror(errno.EBADF), str(self.path))
            self._descriptor = found
        return self._descriptor

    def refuse(self) -> None:
        """Drop whatever is written from now on."""
        self.error = self.error or OSError(errno.EBADF, os.strerror(errno.EBADF), str(self.path))

    def require_good(self) -> None:
        """Raise the OSError that befell the file."""
        if self.error:
            raise self.error

    def write(self, data: Any) -> int:
        rest = memoryview(data).cast("B")
        size = len(rest)
        try:
            at = self._at
            while rest and not self.error:
                os.lseek(self.descriptor, at, os.SEEK_SET)
                done = os.write(self._descriptor, rest)
                rest, at = rest[done:], at + done
        except OSError as error:
            self.error = error
        self._at += size
        return size

    def readinto(self, data: Any) -> int:
        buffer = memoryview(data).cast("B")
        try:
            part = self.read_at(self._at, len(buffer))
        except OSError as error:
            self.error, part = self.error or error, b""
        buffer[: len(part)] = part
        self._at += len(part)
        return len(part)

    def read_at(self, at: int, size: int) -> bytes:
        """At most so many bytes from a place. Raises OSError."""
        os.lseek(self.descriptor, at, os.SEEK_SET)
        return os.read(self._descriptor, size)

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        begin = {os.SEEK_SET: 0, os.SEEK_CUR: self._at}.get(whence)
        self._at = offset + (self._size() if begin is None else begin)
        return self._at

    def _size(self) -> int:
        try:
            return os.fstat(self.descriptor).st_size
        except OSError as error:
            self.error = self.error or error
            return self._at

    def tell(self) -> int:
        return self._at

    def truncate(self, size: int | None = None) -> int:
        wanted = self._at if size is None else size
        try:
            if not self.error:
                os.ftruncate(self.descriptor, wanted)
        except OSError as error:
            self.error = error
        return wanted

    def readable(self) -> bool:
        return True

    def writable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def close(self) -> None:
        if not self.closed and identity(self._descriptor) == self._identity:
            os.close(self._descriptor)
        super().close()


def identity(descriptor: int) -> tuple[int, int] | None:
    """Which file a descriptor leads to; None if to none."""
    try:
        found = os.fstat(descriptor)
    except OSError:
        return None
    return found.st_dev, found.st_ino
