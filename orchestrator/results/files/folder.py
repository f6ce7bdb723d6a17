"""A results folder that holds something already: what a run may replace there, and what it may not."""

from __future__ import annotations

import json
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...errors import InputError
from .writing import MANIFEST

STUDIES = {"points.jsonl": "a sweep", "sweep.nc": "a sweep", "sweep.csv": "a sweep"}


def require_own(folder: Path, system: str, force: bool) -> list[str]:
    """The files of an earlier run of the same system in a folder, which the next one replaces.

    Raises InputError if the folder holds the results of another system or of a study, unless `force` is set.
    """
    older = _manifest(folder)
    if not force:
        if older and older.get("system") != system:
            raise _taken(folder, f"the system {older.get('system')}")
        for file, study in STUDIES.items() if not older else ():
            if (folder / file).exists():
                raise _taken(folder, study)
    return _files(older)


def files_of(folder: Path) -> list[str]:
    """The files in a folder that a run wrote there; none where no run did."""
    return _files(_manifest(folder))


def _files(manifest: dict[str, Any]) -> list[str]:
    return [name for name in manifest.get("files", ()) if isinstance(name, str) and Path(name).name == name]


def remove(folder: Path, files: Iterable[str]) -> None:
    """Remove an earlier run's files, so that none is taken for one of the next."""
    for name in files:
        with suppress(OSError):
            if not (folder / name).is_dir():
                (folder / name).unlink(missing_ok=True)


def _taken(folder: Path, whose: str) -> InputError:
    return InputError(
        f"{folder} holds the results of {whose}; choose another folder with --out, or replace them with --force"
    )


def _manifest(folder: Path) -> dict[str, Any]:
    """What an earlier run says of itself; empty if there was none."""
    try:
        found = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) and isinstance(found.get("files", []), list) else {}
