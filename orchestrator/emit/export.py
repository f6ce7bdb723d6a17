"""`rovbrush export SYSTEM --fmu` and `--c`: what is written, and what its user must know."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import InputError
from ..system.model import System
from .archive import write_fmu
from .folder import write_c

VERSIONS = ("2.0", "3.0")


@dataclass(frozen=True)
class Written:
    """The file or folder, what it is, and notes."""

    path: Path
    kind: str
    notes: tuple[str, ...] = ()


def export_fmu(system: System, path: Path | None, fmi: str = "2.0") -> Written:
    """Write the system as one native FMU. Raises InputError, FmuError, RunError."""
    if fmi not in VERSIONS:
        raise InputError(f"--fmi {fmi}: an FMU is written as {' or '.join(VERSIONS)}")
    target = path or Path(f"{system.name}.fmu")
    notes = write_fmu(system, target, fmi)
    return Written(target, f"one FMU of FMI {fmi}, {target.stat().st_size // 1000} kB", tuple(notes))


def export_c(system: System, folder: Path) -> Written:
    """Write the system as C. Raises InputError, FmuError."""
    return Written(folder, "a C library and a program", tuple(write_c(system, folder)))
