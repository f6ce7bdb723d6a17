"""A netCDF file that is being written, held by descriptors that nobody else is to have.

An FMU may close descriptors that are not its own, or change the working directory; somebody may remove the folder.
What was flushed is found again in each case: by the path, or by a descriptor of a file that has no path any more.
"""

from __future__ import annotations

import errno
import os
from contextlib import suppress
from pathlib import Path
from typing import Any

NO_CACHE = 0  # bytes: what is written is not read again
COPIED = 1 << 20  # bytes at once
METADATA = 1 << 16  # bytes of the file's own books for every piece, and some for each column
GIVEN_UP: list[Any] = []  # files that must never be closed: their descriptors are somebody else's now


def room_for(before: int, rows: int, columns: int, chunk: int) -> int:
    """Bytes that so many rows more may take of the disk, in whole chunks."""
    chunks = -(-(before + rows) // chunk) + before // -chunk
    return METADATA + columns * (8 * chunks * chunk + 2048)


class OwnFile:
    """`tables`: its groups, by name; `length`: bytes that were whole after the last `flush`."""

    def __init__(self, path: Path, mode: str = "a") -> None:
        import h5netcdf  # type: ignore[import-untyped]
        import h5py  # type: ignore[import-untyped]

        self.path = path
        self.file = h5py.File(path, mode, rdcc_nbytes=NO_CACHE)
        self.tables = h5netcdf.File(self.file, mode)
        self._descriptor = int(self.file.id.get_vfd_handle())
        self._spare = os.open(path, os.O_RDWR if mode == "a" else os.O_RDONLY)
        self._identity = _identity(self._spare)
        self.closed = False
        self.length = int(self.file.id.get_filesize())

    @property
    def is_own(self) -> bool:
        """Whether the descriptor still leads to the file."""
        return not self.closed and _identity(self._descriptor) == self._identity

    def flush(self) -> None:
        """Bring everything to the file."""
        self.file.flush()
        self.length = int(self.file.id.get_filesize())

    def reserve(self, size: int) -> None:
        """Have the disk keep so many bytes for what comes. Raises OSError if it cannot."""
        if not hasattr(os, "posix_fallocate") or _identity(self._spare) != self._identity:
            return
        try:
            os.posix_fallocate(self._spare, self.length, size)
        except OSError as error:
            if error.errno in (errno.ENOSPC, errno.EFBIG, errno.EDQUOT):
                raise  # any other: this file system cannot reserve

    def chunk(self, group: str) -> int:
        """How many rows of a table lie together."""
        return int(self.file[group]["time"].chunks[0])

    def mark_complete(self, group: str) -> None:
        """Say of a table that the run reached its stop: in place, which takes no room."""
        attributes = self.file[group].attrs
        attributes.modify("complete", attributes["complete"].dtype.type(1))

    def copy(self, path: Path) -> None:
        """What was whole after the last `flush`. Raises OSError."""
        source = self._spare if _identity(self._spare) == self._identity else self._descriptor
        if _identity(source) != self._identity:
            source = os.open(self.path, os.O_RDONLY)
        with path.open("wb") as target:
            at = 0
            while at < self.length:
                part = os.pread(source, min(COPIED, self.length - at), at)
                if not part:
                    raise OSError(errno.EIO, os.strerror(errno.EIO), str(path))
                target.write(part)
                at += len(part)

    def copied(self, path: Path) -> OwnFile:
        """The same in another file."""
        try:
            self.copy(path)
            return OwnFile(path)
        except BaseException:
            with suppress(OSError):
                path.unlink(missing_ok=True)
            raise

    def close(self) -> None:
        """Close the file, without the room that was reserved."""
        if self.closed:
            return
        if not self.is_own:
            self.give_up()
            return
        self.closed = True
        self.file.flush()
        length = int(self.file.id.get_filesize())
        self.tables.close()
        self.file.close()
        if self._identity == _identity(self._spare):
            if os.fstat(self._spare).st_size > length:
                os.ftruncate(self._spare, length)
            os.close(self._spare)

    def give_up(self) -> None:
        """Leave the file alone: what it would still write is not wanted, or would go to somebody else's file."""
        if not self.closed:
            self.closed = True
            GIVEN_UP.append((self.tables, self.file))
            if _identity(self._spare) == self._identity:
                os.close(self._spare)


def _identity(descriptor: int) -> tuple[int, int] | None:
    """Which file a descriptor leads to; None if to none."""
    try:
        found = os.fstat(descriptor)
    except OSError:
        return None
    return found.st_dev, found.st_ino
