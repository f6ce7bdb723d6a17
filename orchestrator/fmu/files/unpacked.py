"""Archives unpacked in the cache, each under the hash of its content: made once, looked at before each use, mended.

    HASH/...                          the files of the archive
    HASH/.rovbrush/manifest.json      a hash of the next line; in it for each file its size, date and SHA-256

Date and size of every file are compared with the manifest before a use; where one differs, its hash decides. A damaged
file is unpacked again and put in place by renaming: processes that have the old one open keep it. Files that are not in
the manifest are left alone (Python keeps compiled modules beside their source).
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...cache import cache
from ...errors import FmuError
from .archive import OURS, content_hash, date_of, extract, opened
from .folder import pack_folder

KEPT = 24  # hexadecimal digits of the hash in the name of the folder
MANIFEST = f"{OURS}/manifest.json"

Manifest = dict[str, Any]  # "archive": name, "sha256": hash, "files": {path: [size, date, hash]}, "folders": [path]


def unpack(path: Path, kind: str = "FMU") -> tuple[Path, str]:
    """Unpack an archive unless its content is in the cache already; returns (folder, content hash).

    `kind` is what messages call the archive: an SSP is unpacked in the same way. The folder of an FMU that is unpacked
    already is packed first, and its archive kept beside what was unpacked: see `archive_of`.

    Raises FmuError for what `archive.opened` refuses, and for a cache folder that cannot be used.
    """
    if not os.path.isdir(path):
        return _unpacked(path, kind)
    if not (path / "modelDescription.xml").is_file():
        raise FmuError(
            f"{kind} {path} is a folder without modelDescription.xml; give the .fmu file, or the folder that it was "
            f"unpacked to"
        )
    with cache.workspace() as work:
        packed = pack_folder(path, work / f"{path.name}.fmu")
        try:
            entry, digest = _unpacked(packed, kind)
        except FmuError as error:
            raise FmuError(str(error).replace(str(packed), str(path))) from error
        kept = archive_of(path, entry)
        if not kept.is_file() or kept.stat().st_size != packed.stat().st_size:
            packed.replace(kept)
    return entry, digest


def archive_of(path: Path, entry: Path) -> Path:
    """The archive of an FMU that is unpacked in `entry`: itself, or the one that was made of its folder."""
    return entry / OURS / "packed.fmu" if path.is_dir() else path


def _unpacked(path: Path, kind: str) -> tuple[Path, str]:
    digest = content_hash(path, kind)
    entry = cache.place("fmus", digest[:KEPT])
    try:
        manifest = _manifest(entry, digest)
        damaged = None if manifest is None else _damaged(entry, manifest)
        if damaged is None or damaged:
            size = _put(path, kind, entry, digest, damaged)
            cache.grew(size)
    except OSError as error:
        raise FmuError(f"{kind} {path} cannot be unpacked to {entry}: {error.strerror or error}") from error
    cache.mark_used(entry / OURS)
    return entry, digest


def _manifest(entry: Path, digest: str) -> Manifest | None:
    """What should be in an entry; None if that is not known."""
    try:
        check, _, text = (entry / MANIFEST).read_text(encoding="utf-8").partition("\n")
    except (OSError, UnicodeDecodeError):
        return None
    if check != hashlib.sha256(text.encode()).hexdigest():
        return None
    found: Manifest = json.loads(text)
    return found if found["sha256"] == digest else None


def _damaged(entry: Path, manifest: Manifest) -> list[str]:
    """The files and folders that are not as they were when they were unpacked."""
    wrong = [name for name in manifest["folders"] if not (entry / name).is_dir()]
    for name, (size, date, digest) in manifest["files"].items():
        file = entry / name
        try:
            status = file.lstat()
            if (status.st_size, status.st_mtime) == (size, date) and stat.S_ISREG(status.st_mode):
                continue
            if not stat.S_ISREG(status.st_mode) or status.st_size != size or _hash(file) != digest:
                wrong.append(name)
                continue
        except OSError:
            wrong.append(name)
            continue
        with suppress(OSError):  # only its date had changed
            os.utime(file, (date, date))
    return wrong


def _hash(file: Path) -> str:
    with file.open("rb") as opened_file:
        return hashlib.file_digest(opened_file, "sha256").hexdigest()


def _put(path: Path, kind: str, entry: Path, digest: str, names: list[str] | None) -> int:
    """Unpack an archive, or only some of its entries, to an entry of the cache; returns the bytes."""
    with cache.workspace() as work:
        new, size, wanted = work / "new", 0, None if names is None else set(names)
        new.mkdir(mode=0o700)
        manifest: Manifest = {"archive": path.name, "sha256": digest, "files": {}, "folders": []}
        with opened(path, kind) as (archive, contents):
            for name, info in contents.items():
                if wanted is not None and name not in wanted:
                    continue
                if name.endswith("/"):
                    (new / name).mkdir(parents=True, exist_ok=True)
                    manifest["folders"].append(name)
                else:
                    file_digest = extract(archive, info, new / name)
                    manifest["files"][name] = [info.file_size, date_of(info), file_digest]
                    size += info.file_size
        if wanted is None:
            text = json.dumps(manifest)
            check = hashlib.sha256(text.encode()).hexdigest()
            (new / OURS).mkdir()
            (new / MANIFEST).write_text(f"{check}\n{text}", encoding="utf-8")
        _into_place(new, entry, work)
    return size


def _into_place(new: Path, entry: Path, work: Path) -> None:
    """Rename a new entry to where it belongs, or its files one by one where there is one that is in use or damaged."""
    with suppress(OSError):
        new.rename(entry)
        return
    files = sorted(new.rglob("*"), key=lambda file: file == new / MANIFEST)  # it comes last
    try:
        for file in files:
            target = entry / file.relative_to(new)
            if file.is_dir():
                target.mkdir(exist_ok=True)
            else:
                file.replace(target)
    except OSError:  # a file where a folder belongs, or the like
        with suppress(OSError):
            entry.rename(work / "damaged")
            new.rename(entry)
            return
        raise
