"""An FMU that somebody has unpacked: its folder packed again, so that it is checked and kept like any archive."""

from __future__ import annotations

import os
import zipfile
from pathlib import Path

from ...errors import FmuError
from .archive import LARGEST, MOST

DATE = (1980, 1, 1, 0, 0, 0)  # of every entry: the same content is the same archive
EXECUTABLE = 0o111


def pack_folder(folder: Path, target: Path) -> Path:
    """Pack the files of a folder, in their order. Raises FmuError for one that holds links, or more than may be."""
    files, size = [], 0
    for place, folders, names in os.walk(folder):
        folders.sort()
        for name in [*folders, *sorted(names)]:
            file = Path(place) / name
            if file.is_symlink() or not (file.is_file() or file.is_dir()):
                raise FmuError(f"FMU {folder}: '{file.relative_to(folder)}' is a link or a device; put the file there")
            if file.is_file():
                files.append(file)
                size += file.stat().st_size
        if len(files) > MOST or size > LARGEST:
            raise FmuError(f"FMU {folder} holds more than {MOST} files or {LARGEST >> 30} GiB; leave out what it can")
    with zipfile.ZipFile(target, "w", zipfile.ZIP_STORED) as archive:
        for file in sorted(files):
            entry = zipfile.ZipInfo(file.relative_to(folder).as_posix(), DATE)
            entry.external_attr = (0o100644 | (file.stat().st_mode & EXECUTABLE)) << 16
            with archive.open(entry, "w") as into:
                into.write(file.read_bytes())
    return target
