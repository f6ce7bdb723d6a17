"""Files and folders: made whole or not at all, and read with errors that say which."""

from __future__ import annotations

import csv
import json
import math
import os
import re
import shlex
import shutil
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from .errors import InputError, RunError


def prepare_folder(folder: Path, option: str = "--out") -> None:
    """Create the output folder and prove that it can be written to, before anything is computed. Raises InputError.

    `option` is the one to choose another folder with.
    """
    probe = folder / f".probe.{os.getpid()}.tmp"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.write_bytes(b"")
        probe.unlink()
    except OSError as error:
        raise InputError(
            f"cannot write to the output folder {folder}: {error.strerror}; choose another with {option}"
        ) from error


TEMPORARY = re.compile(r"\.(?P<stem>.+)\.(?P<pid>\d+)\.(?:tmp|old)(?:\.\w+)?")  # what a process leaves that is killed


def sweep_up(folder: Path) -> list[str]:
    """Remove what processes that are no more left half-written in a folder; the names."""
    swept = []
    for path in sorted(folder.iterdir()) if folder.is_dir() else []:
        found = TEMPORARY.fullmatch(path.name)
        if found and not is_alive(int(found["pid"])):
            with suppress(OSError):
                if path.is_dir() and not path.is_symlink():
                    shutil.rmtree(path)
                else:
                    path.unlink()
                swept.append(path.name)
    return swept


def is_alive(pid: int) -> bool:
    """Whether a process of this number is at work: one that has ended and waits to be collected is not."""
    try:
        os.kill(pid, 0)
        if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] in ("Z", "X"):
            return False
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:  # another user's, or no /proc here
        return True
    return True


def reason(error: BaseException) -> str:
    """Why a file could not be written, in the system's own words where it gave any."""
    number = getattr(error, "errno", None)
    if number:
        return os.strerror(number)
    said = re.search(r"error message = '([^']+)'", str(error))  # as HDF5 hands it on
    return said[1] if said else str(error) or type(error).__name__


def write_file(path: Path, write: Callable[[Path], Any]) -> Path:
    """Let `write` fill a temporary file, then rename it. Raises RunError if the disk refuses (HDF5: a RuntimeError)."""
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.tmp{path.suffix}")
    try:
        write(temporary)
        temporary.replace(path)
    except (OSError, RuntimeError) as error:
        raise RunError(f"cannot write {path}: {reason(error)}; nothing was left half-written") from error
    finally:
        with suppress(OSError):  # a read-only disk would hide the error above
            temporary.unlink(missing_ok=True)
    return path


def write_json(path: Path, content: Any) -> None:
    """JSON with sorted-by-insertion keys; numbers that are none in JSON become the texts "nan", "inf" and "-inf"."""
    path.write_text(json.dumps(plain(content), indent=1, allow_nan=False) + "\n", encoding="utf-8")


def plain(content: Any) -> Any:
    """Content without numbers that JSON does not have; bytes are hexadecimal."""
    if isinstance(content, bytes):
        return content.hex()
    if isinstance(content, Mapping):
        return {key: plain(value) for key, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [plain(value) for value in content]
    return str(content) if isinstance(content, float) and not math.isfinite(content) else content


def typed(path: Path | str) -> str:
    """A path, or another word of a command, as it is typed: in quotes where it has spaces."""
    if os.name == "nt":
        return f'"{path}"' if " " in str(path) else str(path)
    return shlex.quote(str(path))


def csv_rows(path: Path) -> list[list[str]]:
    """The rows of a CSV file but empty ones. Raises InputError if it cannot be read."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            return [row for row in csv.reader(file) if row]
    except (OSError, ValueError, csv.Error) as error:
        raise InputError(f"{path} cannot be read: {error}") from error
