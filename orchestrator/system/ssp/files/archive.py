"""Where the files of an SSP are: a .ssp archive, unpacked as safely as an FMU, a folder, or that of a .ssd file."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path
from urllib.parse import unquote, urlsplit

from ....errors import InputError, nearest, shown
from ....fmu.files.unpacked import unpack
from ....fmu.tolerant.rules import Notes
from .rules import BACKSLASH, CASE, STRUCTURE

SUFFIXES = (".ssp", ".ssd")
STRUCTURE_FILE = "SystemStructure.ssd"


@dataclass(frozen=True)
class Archive:
    """The structure description, and where its relative sources start. Nothing above `root` is opened."""

    path: Path  # as it was given
    root: Path
    structure: Path
    name: str  # what messages call `root`; empty for a folder
    packed: bool
    allowed: tuple[Path, ...] = ()  # folders elsewhere whose files may be opened

    @classmethod
    def open(cls, path: Path, allowed: tuple[Path, ...] = (), notes: Notes | None = None) -> Archive:
        """A .ssp, a .ssd, or the folder of an unpacked .ssp; `vehicle.ssp#other.ssd` for another structure in it.

        Raises FmuError for a corrupt or unsafe archive, InputError for a missing file.
        """
        package, _, variant = str(path).partition("#")
        if not os.path.exists(path) and variant and package.lower().endswith(".ssp"):
            path = Path(package)
        else:
            variant = ""
        if os.path.isdir(path):
            return cls(path, path, _structure(path, path.name, notes), "", False, allowed)
        if not os.path.isfile(path):
            raise InputError(f"system file {path} does not exist")
        if path.suffix.lower() == ".ssd":
            return cls(path, path.parent, path, "", False, allowed)
        folder, _ = unpack(path, "SSP")
        return cls(path, folder, _structure(folder, path.name, notes, variant), path.name, True, allowed)

    @property
    def folder(self) -> Path:
        """From which relative sources start."""
        return self.structure.parent

    def others(self) -> list[str]:
        """The names of further structure descriptions beside this one."""
        return sorted(path.name for path in self.folder.glob("*.ssd") if path.name != self.structure.name)

    def nested(self, file: Path, fragment: str, notes: Notes) -> Archive:
        """A .ssp or .ssd in this one. Its sources may name files of this one too. Raises FmuError or InputError."""
        if file.suffix.lower() == ".ssp" or file.is_dir():
            path = Path(f"{file}#{fragment}") if fragment else file
            return replace(Archive.open(path, (*self.allowed, self.root), notes), name=self.shown(file))
        return replace(self, structure=file)

    def shown(self, file: Path) -> str:
        """A file of the archive as messages call it: `vehicle.ssp/resources/motor.ssv`."""
        try:
            inside = file.relative_to(self.root).as_posix()
        except ValueError:
            return str(file)
        return f"{self.name}/{inside}" if self.name else inside

    def resolve(self, source: str, label: str, notes: Notes, base: Path | None = None) -> Path:
        """The file, or the folder of an unpacked FMU, that a URI names, from `base` or where the structure is.

        Nothing remote is fetched, and no file outside is opened but from folders that are allowed. Raises InputError.
        """
        root, folder = (base, base) if base else (self.root, self.folder)
        text = _local(source, label)
        try:
            for candidate in (source, text, text.replace("\\", "/")):
                file = (folder / candidate).resolve()
                if file.is_relative_to(root.resolve()) and is_there(file):
                    if candidate != source and "\\" in source:
                        notes.add(BACKSLASH, source)
                    return root / file.relative_to(root.resolve())
            return self._elsewhere(source, (folder / text.replace("\\", "/")), root, label, notes)
        except (OSError, ValueError, RuntimeError) as error:  # NUL, a name too long, links in a circle
            raise InputError(f"{label}: source '{shown(source)}' is no file: {error}") from None

    def _elsewhere(self, source: str, path: Path, root: Path, label: str, notes: Notes) -> Path:
        """What is inside in other letters, or outside and allowed."""
        target = path.resolve()
        if target.is_relative_to(root.resolve()):
            files = {p.relative_to(root).as_posix(): p for p in root.rglob("*") if p.suffix == target.suffix}
            wanted = target.relative_to(root.resolve()).as_posix()
            alike = [p for name, p in files.items() if name.lower() == wanted.lower()]
            if len(alike) == 1:
                notes.add(CASE, source)
                return alike[0]
            raise InputError(
                f"{label}: there is no file '{shown(source)}' in {self.name or self.path.name}{nearest(wanted, files)}"
            )
        absolute = os.path.isabs(_local(source, label).replace("\\", "/"))
        if self.packed and root == self.root and not absolute:  # as if it were unpacked to a folder of its name
            inside = os.path.relpath(path, self.root)
            target = Path(os.path.normpath(self.path.absolute() / inside))
        if not any(target.is_relative_to(folder.resolve()) for folder in self.allowed):
            raise InputError(
                f"{label}: source '{shown(source)}' leaves the folder of the SSP; put the file inside it or, if you "
                f"trust it, say --allow-outside {target.parent}"
            )
        if not is_there(target):
            raise InputError(f"{label}: there is no file {target}")
        return target


def is_there(file: Path) -> bool:
    """Whether a path is a file, or a folder that was an archive."""
    return os.path.isfile(file) or any(os.path.isfile(file / name) for name in ("modelDescription.xml", STRUCTURE_FILE))


def _local(source: str, label: str) -> str:
    """The path of a URI on this machine. Raises InputError."""
    try:
        uri = urlsplit(source)
    except ValueError as error:
        raise InputError(f"{label}: source '{shown(source)}' is no address of a file: {error}") from None
    if uri.scheme == "file" and uri.netloc in ("", "localhost"):
        return unquote(uri.path)
    if len(uri.scheme) == 1:
        raise InputError(
            f"{label}: source '{shown(source)}' is on a drive of another machine; put the file into the SSP"
        )
    if uri.scheme or uri.netloc:
        raise InputError(
            f"{label}: source '{shown(source)}' is not inside the SSP; nothing is fetched from elsewhere: put the file "
            f"there"
        )
    if uri.fragment or not uri.path:
        raise InputError(f"{label}: source '{shown(source)}' refers to a part of a file, and none is needed here")
    return unquote(uri.path)


def _structure(folder: Path, name: str, notes: Notes | None, wanted: str = "") -> Path:
    """The structure description of a package, or the one that is wanted. Raises InputError."""
    if not wanted and (folder / STRUCTURE_FILE).is_file():
        return folder / STRUCTURE_FILE
    found: list[Path] = []
    for pattern in ("*.[sS][sS][dD]", "*/*.[sS][sS][dD]"):  # the last: zipped with its folder
        found += sorted(folder.glob(pattern))
        default = [path for path in found if path.name.lower() == (wanted or STRUCTURE_FILE).lower()]
        if len(default or found) == 1 and (default or not wanted):
            (only,) = default or found
            if not wanted:
                (notes or Notes()).add(STRUCTURE, f"{only.relative_to(folder).as_posix()} in {name}")
            return only
    names = [path.relative_to(folder).as_posix() for path in found]
    if wanted:
        raise InputError(f"{name} has no structure '{shown(wanted)}'{nearest(wanted, names)}")
    if found:
        raise InputError(f"{name} has no {STRUCTURE_FILE}; of {', '.join(names)}, say which: {name}#{found[0].name}")
    raise InputError(f"{name} has no {STRUCTURE_FILE}; it is no SSP, or not a complete one")
