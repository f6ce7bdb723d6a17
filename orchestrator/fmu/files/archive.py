"""Archives from strangers: what their entries may be called, how much they may hold, and how they are unpacked."""

from __future__ import annotations

import hashlib
import os
import stat
import struct
import sys
import zipfile
import zlib
from calendar import timegm
from collections.abc import Iterator
from contextlib import contextmanager
from os import utime
from pathlib import Path

from ...errors import FmuError
from ..tolerant.rules import BACKSLASH, TWICE, Notes
from .places import absent

LARGEST = 2 << 30  # bytes unpacked; guards against zip bombs
MOST = 50_000  # entries
LONGEST, LONGEST_PART = 1000, 255  # bytes in an entry's name, and between two slashes of it
METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}  # those that FMI and SSP allow
BLOCK = 1 << 20
OURS = ".rovbrush"  # the folder beside the files of an unpacked archive in which we keep what we know of them
CASELESS = sys.platform in ("win32", "darwin")  # there `A` and `a` are one file

Contents = dict[str, zipfile.ZipInfo]  # entries by their path; that of a folder ends with a slash


@contextmanager
def opened(path: Path, kind: str = "FMU", notes: Notes | None = None) -> Iterator[tuple[zipfile.ZipFile, Contents]]:
    """An archive with its entries, checked. `kind` is what messages call it; `notes`: where it breaks the standard.

    Raises FmuError for a missing or corrupt file, here and while it is read; for entries that leave the folder, links,
    two different entries for one file, and for more than may be unpacked.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            yield archive, _contents(f"{kind} {path}", archive, notes or Notes())
    except (
        zipfile.BadZipFile,
        zipfile.LargeZipFile,
        EOFError,
        NotImplementedError,
        RuntimeError,
        ValueError,
        OverflowError,
        struct.error,
        zlib.error,
    ) as error:
        raise FmuError(f"{kind} {path} is not a readable zip archive ({error}); get or build it again") from error


def content_hash(path: Path, kind: str = "FMU") -> str:
    """SHA-256 of a file, as hexadecimal text. Raises FmuError where there is none to read."""
    if not os.path.isfile(path):  # a name that no file can have, too
        raise absent(path, kind)
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise FmuError(f"{kind} {path} cannot be read: {error.strerror}") from error


def extract(archive: zipfile.ZipFile, entry: zipfile.ZipInfo, target: Path) -> str:
    """Write one entry to a file, with its date and, if it may be executed, the right to; returns its SHA-256."""
    digest = hashlib.sha256()
    target.parent.mkdir(parents=True, exist_ok=True)
    with archive.open(entry) as source, target.open("xb") as file:
        while block := source.read(BLOCK):
            digest.update(block)
            file.write(block)
    if entry.external_attr >> 16 & 0o111:
        target.chmod(0o755)
    utime(target, (date_of(entry), date_of(entry)))
    return digest.hexdigest()


def date_of(entry: zipfile.ZipInfo) -> int:
    """The date that an unpacked file gets [s since 1970]: whoever unpacks it, it is the same."""
    try:
        return timegm((*entry.date_time, 0, 0, 0))
    except ValueError:  # month 0, hour 31 and the like
        return 0


def _contents(archive: str, opened: zipfile.ZipFile, notes: Notes) -> Contents:
    entries = opened.infolist()
    if len(entries) > MOST:
        raise FmuError(f"{archive} has {len(entries)} entries, more than {MOST}; pack it with fewer files")
    if sum(entry.file_size for entry in entries) > LARGEST:
        raise FmuError(f"{archive} would unpack to more than {LARGEST >> 30} GiB; leave out what is not needed to run")
    found: Contents = {}
    for entry in entries:
        path = _checked(archive, entry)
        if "\\" in entry.filename:
            notes.add(BACKSLASH, entry.filename)
        if path and found.setdefault(path, entry) is not entry and not path.endswith("/"):
            if not _alike(opened, found[path], entry):
                raise FmuError(f"{archive}: entry '{path}' is there twice with different contents; pack one of them")
            notes.add(TWICE, path)
    files = {_key(path) for path in found if not path.endswith("/")}
    if len(files) < sum(not path.endswith("/") for path in found):
        raise FmuError(f"{archive} has entries whose names differ in upper and lower case only; rename one of them")
    for path in map(_key, found):
        parts = path.rstrip("/").split("/")
        above = ("/".join(parts[:n]) for n in range(1, len(parts) + path.endswith("/")))
        inside = next((name for name in above if name in files), None)
        if inside:
            raise FmuError(f"{archive}: entry '{inside}' is a file and a folder; rename one of them")
    return found


def _alike(archive: zipfile.ZipFile, a: zipfile.ZipInfo, b: zipfile.ZipInfo) -> bool:
    """Whether two entries have the same content."""
    if (a.file_size, a.CRC) != (b.file_size, b.CRC):
        return False
    with archive.open(a) as one, archive.open(b) as two:
        while block := one.read(BLOCK):
            if two.read(len(block)) != block:
                return False
    return True


def _key(path: str) -> str:
    return path.casefold() if CASELESS else path


def _checked(archive: str, entry: zipfile.ZipInfo) -> str:
    """The path of an entry without `.` and empty parts; empty for the folder of the archive itself."""
    name = entry.filename.replace("\\", "/")
    shown = f"{archive}: entry '{name if len(name) < 100 else name[:100] + '...'}'"
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if name.startswith("/") or ".." in parts or ":" in name:
        raise FmuError(f"{shown} would leave the unpack folder; pack it with paths inside the archive")
    folder = name.endswith("/")
    nameless = not name or (not parts and not folder)
    if nameless or parts[:1] == [OURS] or any(ord(letter) < 32 or letter == "\x7f" for letter in name):
        raise FmuError(f"{shown} has a name that no file may have; rename it")
    size = len(name.encode("utf-8", "surrogatepass"))
    if size > LONGEST or any(len(part.encode("utf-8", "surrogatepass")) > LONGEST_PART for part in parts):
        raise FmuError(f"{shown} has too long a name; rename it")
    mode = entry.external_attr >> 16
    if stat.S_ISLNK(mode):
        raise FmuError(f"{shown} is a symbolic link, which can lead anywhere; pack the file itself")
    if stat.S_IFMT(mode) not in (0, stat.S_IFREG, stat.S_IFDIR):
        raise FmuError(f"{shown} is no file and no folder; leave it out")
    if entry.compress_type not in METHODS:
        raise FmuError(f"{shown} is compressed by a method that FMI does not allow; pack it with deflate")
    return "/".join(parts) + ("/" if folder and parts else "")
