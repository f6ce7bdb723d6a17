"""Where the files of an SSP are: a .ssp archive, unpacked as safely as an FMU, or the folder of a .ssd file."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlsplit

from ...errors import InputError, shown
from ...fmu.unpacked import unpack

SUFFIXES = (".ssp", ".ssd")
STRUCTURE = "SystemStructure.ssd"


@dataclass(frozen=True)
class Archive:
    """The folder that relative sources start from, and the structure description in it."""

    path: Path
    folder: Path
    structure: Path

    @classmethod
    def open(cls, path: Path) -> Archive:
        """Raises FmuError for a corrupt or unsafe archive, InputError for a missing file."""
        if not path.is_file():
            raise InputError(f"system file {path} does not exist")
        if path.suffix == ".ssd":
            return cls(path, path.parent, path)
        folder, _ = unpack(path, "SSP")
        if not (folder / STRUCTURE).is_file():
            raise InputError(f"{path.name} has no {STRUCTURE}; it is no SSP, or not a complete one")
        return cls(path, folder, folder / STRUCTURE)

    def shown(self, file: Path) -> str:
        """A file of the archive as messages call it: `vehicle.ssp/resources/motor.ssv`."""
        if self.path.suffix == ".ssd":
            return file.name
        return f"{self.path.name}/{file.relative_to(self.folder).as_posix()}"

    def resolve(self, source: str, label: str, base: Path | None = None) -> Path:
        """The file that a relative URI names, from `base` or the archive's folder. Raises InputError.

        Nothing remote is fetched, and no file outside is opened.
        """
        try:
            uri = urlsplit(source)
        except ValueError as error:
            raise InputError(f"{label}: source '{shown(source)}' is no address of a file: {error}") from None
        if uri.scheme or uri.netloc:
            raise InputError(f"{label}: source '{source}' is not inside the SSP; nothing is fetched from elsewhere")
        if uri.fragment or not uri.path:
            raise InputError(f"{label}: source '{source}' refers to a part of a file, which is not supported")
        folder = base or self.folder
        try:
            file = (folder / unquote(uri.path)).resolve()
        except (OSError, ValueError, RuntimeError) as error:  # NUL, a name too long, links in a circle
            raise InputError(f"{label}: source '{shown(source)}' is no file: {error}") from None
        if not file.is_relative_to(folder.resolve()):
            raise InputError(f"{label}: source '{source}' leaves the folder of the SSP; put the file inside it")
        if not os.path.isfile(file):  # False for a name too long as well
            raise InputError(f"{label}: there is no file '{shown(source)}' in {self.path.name}")
        return folder / file.relative_to(folder.resolve())
