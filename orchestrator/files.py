"""Files and folders: made whole or not at all, and read with errors that say which."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Callable
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


def write_file(path: Path, write: Callable[[Path], Any]) -> Path:
    """Let `write` fill a temporary file, then rename it. Raises RunError if the disk refuses."""
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.tmp{path.suffix}")
    try:
        write(temporary)
        temporary.replace(path)
    except OSError as error:
        raise RunError(f"cannot write {path}: {error.strerror or error}; nothing was left half-written") from error
    finally:
        with suppress(OSError):  # a read-only disk would hide the error above
            temporary.unlink(missing_ok=True)
    return path


def write_json(path: Path, content: Any) -> None:
    """JSON with sorted-by-insertion keys; refuses NaN, which is no JSON."""
    path.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def csv_rows(path: Path) -> list[list[str]]:
    """The rows of a CSV file but empty ones. Raises InputError if it cannot be read."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            return [row for row in csv.reader(file) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{path} cannot be read: {error}") from error
