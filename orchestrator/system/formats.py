"""The files that a system can come from, and who reads each."""

from __future__ import annotations

import os
from pathlib import Path

from ..toml.file import TomlFile
from .one_fmu import FmuFile, is_fmu

STRUCTURES = ("SystemStructure.ssd", "OspSystemStructure.xml")  # what a folder can hold
ENDINGS = (".toml", ".ssp", ".ssd", ".xml", ".fmu")


def is_system_file(name: str) -> bool:
    """Whether a name is the path of a file, or of a folder, and not the name of a shipped system."""
    path = Path(name)
    named = path.suffix.lower() in ENDINGS or is_ssp(path)
    return named or is_fmu(path) or any(os.path.isfile(path / structure) for structure in STRUCTURES)


def is_ssp(path: Path) -> bool:
    """Whether a path is that of an SSP: a .ssp, a .ssd, `vehicle.ssp#variant.ssd`, or the folder of an unpacked one."""
    package = str(path).partition("#")[0].lower()
    return package.endswith((".ssp", ".ssd")) or os.path.isfile(path / STRUCTURES[0])


def is_osp(path: Path) -> bool:
    """Whether a path is that of an OspSystemStructure.xml, or of the folder of one."""
    return path.suffix.lower() == ".xml" or os.path.isfile(path / STRUCTURES[1])


def opened(
    path: Path, step: str = "", stop: str = "", outside: tuple[Path, ...] = (), start: str = ""
) -> TomlFile:  # fmt: skip
    """The data of a file that `is_system_file`. Raises InputError or FmuError.

    `step`, `stop`, `start`: for what an SSP of another tool leaves open, or an FMU alone; `outside`: folders elsewhere
    from which an SSP may take files.
    """
    if is_ssp(path):
        from .ssp.read import SspFile

        return SspFile(path, step, stop, outside, start)
    if is_osp(path):
        from .osp.read import OspFile

        return OspFile(path, step, stop, start)
    if is_fmu(path):
        return FmuFile(path, step, stop, start)
    return TomlFile(path)
