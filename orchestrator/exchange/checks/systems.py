"""A file of SSP or OSP: whether it can be read, and where it breaks its standard; then each of its FMUs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from ...errors import RovbrushError, counted
from ...system.file.reader import load_system
from ...system.formats import is_osp, is_ssp
from .chain import check_fmu
from .note_rows import note_rows
from .rows import Report, Row

STAGE = "system"


def check_file(path: Path, outside: Sequence[Path] = ()) -> Iterator[Report]:
    """The report of an FMU; of a system's file its own, then those of its FMUs. `outside`: see `load_system`."""
    if not (is_ssp(path) or is_osp(path)):
        yield check_fmu(path)
        return
    kind = "SSP" if is_ssp(path) else "OSP"
    try:
        system = load_system(str(path), outside=outside)
    except RovbrushError as error:
        found, _, mend = str(error).rpartition("; ")
        yield Report(path, kind, [Row(STAGE, "can be read", "error", found or mend, mend if found else "")])
        return
    size = f"{counted(len(system.components), 'component')}, {counted(len(system.connections), 'connection')}"
    yield Report(path, f"{kind}, {system.name}", [Row(STAGE, "can be read", "pass", size), *note_rows(system.breaches)])
    for fmu in {c.fmu.digest: c.fmu for c in system.components.values()}.values():
        if fmu.path.exists():
            yield check_fmu(fmu.path)
