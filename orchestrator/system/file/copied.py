"""A shipped system, or sweep, as files of one's own: with all that it refers to, so that it runs where it lies."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...errors import InputError, RunError, listed, nearest
from ...files import prepare_folder, reason
from ...toml.file import TomlFile
from .shipped import SCHEMAS, SWEEPS, SYSTEMS, shipped_systems

SCHEMA = re.compile(r"\A#:schema \S*?(\w+\.schema\.json)")


def copy_shipped(name: str, folder: Path) -> list[Path]:
    """Copy a shipped system or sweep into a folder; the files, its own first.

    Raises InputError for an unknown name, for a folder that cannot be written to, and if one of the files is there
    already with another content: nothing is written then.
    """
    source = _named(name)
    files = {path.name: path.read_text(encoding="utf-8") for path in (source, *_beside(source))}
    for own, text in list(files.items()):
        if found := SCHEMA.match(text):
            files[own] = f"#:schema {found[1]}{text[found.end() :]}"
            files[found[1]] = (SCHEMAS / found[1]).read_text(encoding="utf-8")
    prepare_folder(folder, "--to")
    taken = [own for own, text in files.items() if not _is_free(folder / own, text)]
    if taken:
        raise InputError(
            f"{folder} holds {listed(taken)} already, which {'is' if len(taken) == 1 else 'are'} not written over; "
            "choose another folder with --to"
        )
    return [_written(folder / own, text) for own, text in files.items()]


def _named(name: str) -> Path:
    """The file of a shipped system or sweep. Raises InputError."""
    sweeps = sorted(path.stem for path in SWEEPS.glob("*.toml"))
    known = [*shipped_systems(), *sweeps]
    if name not in known:
        raise InputError(f"--copy: no shipped system or sweep '{name}'{nearest(name, known)}")
    return (SWEEPS if name in sweeps else SYSTEMS) / f"{name}.toml"


def _beside(source: Path) -> list[Path]:
    """The files that a file refers to, in its folder: parameter sets by their names, tables, contents."""
    found = []
    for text in dict.fromkeys(_texts(TomlFile(source).data)):
        plain = text.removeprefix("file:")
        for name in (plain, f"{plain}.toml"):
            path = source.parent / name
            if (
                Path(name).name == name
                and os.path.isfile(path)
                and path != source
                and "[components." not in _text(path)
            ):
                found.append(path)
    return found


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")


def _texts(data: Any) -> Iterator[str]:
    """All texts in what a TOML file says."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict):
        for value in data.values():
            yield from _texts(value)
    elif isinstance(data, list):
        for value in data:
            yield from _texts(value)


def _is_free(path: Path, text: str) -> bool:
    """Whether nothing is there, or just this already: two systems may share a parameter set."""
    try:
        return not os.path.lexists(path) or path.read_text(encoding="utf-8") == text
    except (OSError, ValueError):
        return False


def _written(path: Path, text: str) -> Path:
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:  # the same text
        pass
    except OSError as error:
        raise RunError(f"cannot write {path}: {reason(error)}") from error
    return path
