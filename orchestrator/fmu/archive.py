"""Safe unpacking of FMUs from strangers, into a per-user cache folder named by the content hash."""

from __future__ import annotations

import hashlib
import os
import shutil
import stat
import tempfile
import zipfile
import zlib
from collections import Counter
from pathlib import Path, PurePosixPath

from platformdirs import user_cache_path

from ..errors import FmuError

LARGEST = 2 << 30  # bytes unpacked; guards against zip bombs


def cache_folder() -> Path:
    """Where FMUs are unpacked: $ROVBRUSH_CACHE or the user's cache; plain ASCII, because some FMUs fail elsewhere."""
    chosen = os.environ.get("ROVBRUSH_CACHE")
    folder = Path(chosen).absolute() if chosen else user_cache_path("rovbrush")  # FMI takes it as a URI
    if not str(folder).isascii():
        raise FmuError(
            f"cache folder {folder}: FMUs cannot be loaded from a path beyond plain ASCII; "
            f"set ROVBRUSH_CACHE to another folder"
        )
    return folder


def content_hash(path: Path) -> str:
    """SHA-256 of the file, as hexadecimal text."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def unpack(path: Path, kind: str = "FMU") -> tuple[Path, str]:
    """Unpack an FMU unless its content is in the cache already; returns (folder, content hash).

    `kind` is what messages call the archive: an SSP is unpacked in the same way.

    Raises FmuError for a missing or corrupt file, for entries that leave the folder, links and oversized archives.
    """
    if not path.is_file():
        raise FmuError(f"FMU {path} does not exist; build the project's own with `rovbrush build`")
    digest = content_hash(path)
    folder = cache_folder() / "fmus" / digest[:24]
    if folder.is_dir():
        return folder, digest
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        temporary = Path(tempfile.mkdtemp(prefix="unpacking-", dir=folder.parent))
    except OSError as error:
        raise FmuError(
            f"cannot write to the cache folder {folder.parent}: {error.strerror}; set ROVBRUSH_CACHE to another folder"
        ) from error
    try:
        with zipfile.ZipFile(path) as archive:
            for entry in archive.infolist():
                _check_entry(f"{kind} {path}", entry)
            twice = [name for name, count in Counter(archive.namelist()).items() if count > 1]
            if twice:
                raise FmuError(f"{kind} {path}: entry '{twice[0]}' is there twice; refused")
            if sum(entry.file_size for entry in archive.infolist()) > LARGEST:
                raise FmuError(f"{kind} {path} would unpack to more than {LARGEST >> 30} GiB; refused")
            archive.extractall(temporary)
        try:
            temporary.rename(folder)
        except OSError:
            if not folder.is_dir():  # otherwise another process has just put the same content there
                raise
    except (
        zipfile.BadZipFile,
        zipfile.LargeZipFile,
        EOFError,
        NotImplementedError,
        RuntimeError,
        ValueError,
        zlib.error,
    ) as error:
        raise FmuError(f"{kind} {path} is not a readable zip archive ({error}); get or build it again") from error
    except OSError as error:
        raise FmuError(f"{kind} {path} cannot be unpacked to {folder.parent}: {error.strerror or error}") from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
    return folder, digest


def _check_entry(archive: str, entry: zipfile.ZipInfo) -> None:
    parts = PurePosixPath(entry.filename)
    if parts.is_absolute() or ".." in parts.parts or "\\" in entry.filename or ":" in entry.filename:
        raise FmuError(f"{archive}: entry '{entry.filename}' would leave the unpack folder; refused")
    if stat.S_ISLNK(entry.external_attr >> 16):
        raise FmuError(f"{archive}: entry '{entry.filename}' is a symbolic link; refused")
