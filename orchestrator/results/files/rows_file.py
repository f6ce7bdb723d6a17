"""A results file while it is written: tables are made and grow, and what was flushed is never lost.

A disk that is full is met before HDF5 writes, by reserving room, or kept from it by a `SafeFile`.
"""

from __future__ import annotations

import errno
import os
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .safe_file import SafeFile

if TYPE_CHECKING:
    from .hdf5 import Tables

COPIED = 1 << 20  # bytes at once
METADATA = 1 << 16  # bytes of the file's own books for every piece, and some for each column


def room_for(before: int, rows: int, columns: int, chunk: int) -> int:
    """Bytes that so many rows more may take of the disk, in whole chunks."""
    chunks = -(-(before + rows) // chunk) + before // -chunk
    return METADATA + columns * (8 * chunks * chunk + 2048)


class RowsFile:
    """`length`: bytes that were whole after the last `flush`. Errors are OSErrors."""

    def __init__(self, path: Path, new: bool = False) -> None:
        import h5py  # type: ignore[import-untyped]

        self.path, self.length, self.closed = path, 0, False
        self.disk = SafeFile(path, new)
        try:
            keys = {"track_order": True} if new else {"rdcc_nbytes": 0}  # what is written is not read again
            self.file = h5py.File(self.disk, "w" if new else "r+", **keys)
        except BaseException:
            self.disk.close()
            raise
        if not new:
            self.length = int(self.file.id.get_filesize())

    def create(self, group: str, period: str, complete: bool, chunk: int = 0) -> Tables:
        """Another table, to which variables are added; one that grows lies in chunks of so many rows."""
        from .hdf5 import Tables, set_text

        made = self.file.create_group(group, track_order=True)
        set_text(made.id, "period", period)
        made.attrs["complete"] = np.array([complete], dtype=np.int64)
        return Tables(made, chunk)

    def extend(self, group: str, name: str, first: int, values: np.ndarray) -> None:
        """Values of a variable that grows, from row `first` on; they are the last."""
        from .hdf5 import raw

        variable = self.file[group][name]
        variable.resize((first + len(values),))
        variable[first:] = raw(values)

    def cut(self, group: str, rows: int) -> None:
        """No more than the first rows of a table."""
        for variable in self.file[group].values():
            variable.resize((rows,))

    def values(self, group: str, name: str) -> np.ndarray:
        """All values of a variable, as they were given."""
        from .hdf5 import values_of

        return values_of(self.file[group][name])

    def flush(self) -> None:
        """Bring everything to the file."""
        self.file.flush()
        self.disk.require_good()
        self.length = int(self.file.id.get_filesize())

    def reserve(self, size: int) -> None:
        """Have the disk keep so many bytes for what comes. Raises OSError if it cannot."""
        if not hasattr(os, "posix_fallocate"):
            return
        try:
            os.posix_fallocate(self.disk.descriptor, self.length, size)
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
        """What was whole after the last `flush`."""
        at = 0
        with path.open("wb") as target:
            while at < self.length:
                part = self.disk.read_at(at, min(COPIED, self.length - at))
                if not part:
                    raise OSError(errno.EIO, os.strerror(errno.EIO), str(path))
                target.write(part)
                at += len(part)

    def copied(self, path: Path) -> RowsFile:
        """The same in another file."""
        try:
            self.copy(path)
            return RowsFile(path)
        except BaseException:
            with suppress(OSError):
                path.unlink(missing_ok=True)
            raise

    def close(self) -> None:
        """Close the file, without the room that was reserved."""
        if self.closed:
            return
        try:
            self.flush()
            self.file.close()
            self.disk.require_good()
            if self.disk.seek(0, os.SEEK_END) > self.length:
                self.disk.truncate(self.length)
            self.disk.require_good()
        finally:
            self.give_up()

    def give_up(self) -> None:
        """Leave the file as it is: what would still be written is not wanted."""
        if not self.closed:
            self.closed = True
            self.disk.refuse()
            with suppress(OSError, RuntimeError, ValueError, KeyError):
                self.file.close()
            self.disk.close()
