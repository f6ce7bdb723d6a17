"""All algorithms, and that of a system with its settings. A new one is a file here and a line in ALGORITHMS."""

from __future__ import annotations

from typing import Any

from ...errors import InputError, nearest
from ...system.model import System
from ...system.schema.checked import checked
from ...system.schema.keys.system import KEYS
from ...toml.file import TomlFile
from .adaptive import Adaptive
from .base import Algorithm
from .ecco import Ecco
from .gauss_seidel import GaussSeidel
from .iterated import Iterated
from .jacobi import Jacobi

ALGORITHMS: tuple[type[Algorithm], ...] = (GaussSeidel, Jacobi, Iterated, Ecco, Adaptive)


def algorithm_of(system: System) -> Algorithm:
    """The algorithm that a system names. Raises InputError for an unknown one, and for wrong settings of any."""
    known = {kind.name: kind for kind in ALGORITHMS}
    if system.algorithm not in known:
        raise _fail(system, f"unknown algorithm '{system.algorithm}'{nearest(system.algorithm, known)}", "algorithm")
    headings = {kind.heading: kind for kind in ALGORITHMS if kind.heading}
    found = {}
    for heading, table in system.settings.items():
        if heading not in headings:
            raise _fail(system, f"unknown key '{heading}'{nearest(heading, (*KEYS, *headings))}", heading)
        if not isinstance(table, dict):
            raise _fail(system, f"{heading} must be a table", heading)
        kind = headings[heading]
        file = _file(system)
        where = "" if file else f"({system.path.name})"
        found[kind.name] = kind(checked(kind.Settings, table, heading, file, heading, where))
    return found.get(system.algorithm) or known[system.algorithm](known[system.algorithm].Settings())


def settings_tables() -> dict[str, type[Any]]:
    """The declared settings of all algorithms, by the headings of their tables."""
    return {kind.heading: kind.Settings for kind in ALGORITHMS if kind.heading}


def algorithm_names() -> tuple[str, ...]:
    """What `algorithm` in a system file can be; the first where it says nothing."""
    return tuple(kind.name for kind in ALGORITHMS)


def _file(system: System) -> TomlFile | None:
    """Where the system comes from, if that has lines."""
    return TomlFile(system.path) if system.path.suffix == ".toml" and system.path.is_file() else None


def _fail(system: System, message: str, needle: str) -> InputError:
    file = _file(system)
    return file.fail(message, needle) if file else InputError(f"{message} ({system.path.name})")
