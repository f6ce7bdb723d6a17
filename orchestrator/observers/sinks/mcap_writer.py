"""What all MCAP files have in common: they are begun, and finished also where something went wrong in between."""

from __future__ import annotations

from typing import Any

from ..layout import Layout, Rows
from ..sink import FILE_PATIENCE, FILE_ROOM


class McapWriter:
    """`begin` and `write` are what a kind of file adds; `writer` is that of the package mcap."""

    room, patience = FILE_ROOM, FILE_PATIENCE
    profile = ""

    def __init__(self, path: str) -> None:
        self.path = path
        self.writer: Any = None
        self._file: Any = None

    def open(self, layout: Layout) -> str:
        from mcap.writer import Writer

        self.layout = layout
        self._file = open(self.path, "wb")  # noqa: SIM115 (as long as the run)
        self.writer = Writer(self._file)
        self.writer.start(profile=self.profile, library="rovbrush")
        return self.begin(layout)

    def begin(self, layout: Layout) -> str:
        """The channels; what a person must know of them, or nothing."""
        raise NotImplementedError

    def write(self, rows: Rows) -> int:
        """See `Sink`."""
        raise NotImplementedError

    def close(self) -> None:
        if self._file is None:
            return
        try:
            if self.writer is not None:
                self.writer.finish()
        finally:
            self._file.close()
