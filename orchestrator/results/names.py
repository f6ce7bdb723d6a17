"""What is in the file of a run or a sweep, by name, without its numbers: quickly, for the tab key of a shell."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any


def names_in(path: Path) -> Iterator[tuple[str, str]]:
    """The signals of a result.nc, or the figures of merit of a sweep.nc, each with its description and unit.

    Raises what HDF5 raises for a file that is none of ours.
    """
    import h5py  # type: ignore[import-untyped]

    from .files.hdf5 import EVENTS

    with h5py.File(path, "r") as file:
        tables = [group for name, group in file.items() if isinstance(group, h5py.Group) and name != EVENTS]
        for table in tables or [file]:
            yield from _variables(table)


def _variables(table: Any) -> Iterator[tuple[str, str]]:
    """Those that are no coordinates."""
    from .files.hdf5 import OWN_NAME, texts_of

    found = {str(name): texts_of(stored) for name, stored in table.items() if "CLASS" not in stored.attrs}
    beside = {name for texts in found.values() for name in texts.get("coordinates", "").split()}
    for name, texts in found.items():
        if name not in beside | {"time", "error"}:
            yield texts.get(OWN_NAME, name), f"{texts.get('long_name', '')} {texts.get('units', '')}".strip()
