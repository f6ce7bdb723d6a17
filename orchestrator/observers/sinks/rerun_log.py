"""Rerun (rerun.io): a file `.rrd`, or a viewer that is open. Each number is a scalar, `/motor/i`, over the time `time`.

Texts are left out.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ...errors import RunError
from ..asked import address_of, file_of
from ..layout import Layout, Rows
from ..sink import FILE_PATIENCE, FILE_ROOM, LIVE_PATIENCE, LIVE_ROOM

FLUSH = 2.0  # s that a viewer has to take what is left


class RerunLog:
    """`path` of a file, or `url` of a viewer."""

    def __init__(self, path: str = "", url: str = "") -> None:
        self.path, self.url = path, url
        self.room = FILE_ROOM if path else LIVE_ROOM
        self.patience = FILE_PATIENCE if path else 2 * FLUSH + LIVE_PATIENCE
        self._recording: Any = None
        self._paths: list[list[tuple[int, str]]] = []

    def open(self, layout: Layout) -> str:
        import rerun

        if self.path:
            open(self.path, "wb").close()  # what the system refuses is said here
        self._recording = rerun.RecordingStream("rovbrush", recording_id=layout.system)
        if self.path:
            self._recording.save(self.path)
        else:
            self._recording.connect_grpc(self.url)
        self._paths = [
            [(k, f"{c.component}/{c.variable}") for k, c in enumerate(table.columns) if c.kind != "string"]
            for table in layout.tables
        ]
        return f"rerun at {self.url}" if self.url else ""

    def write(self, rows: Rows) -> int:
        import rerun

        for k, path in self._paths[rows.table]:
            scalars = rerun.Scalars.columns(scalars=rows.values[k].astype(np.float64))
            times = rerun.TimeColumn("time", duration=rows.times)
            rerun.send_columns(path, [times], scalars, recording=self._recording, strict=True)
        return 0

    def close(self) -> None:
        if self._recording is None:
            return
        recording, self._recording = self._recording, None
        try:
            recording.flush(timeout_sec=FILE_PATIENCE if self.path else FLUSH)
        except Exception as error:
            raise RunError(f"not all has arrived at {self.path or self.url}: {error}") from None
        finally:
            recording.disconnect()


def sink_of(where: str, label: str) -> RerunLog:
    """A file that ends with .rrd, or the `host:port` of a viewer."""
    if where.endswith(".rrd"):
        return RerunLog(path=str(file_of(where, label)))
    host, port = address_of(where, label)
    return RerunLog(url=f"rerun+http://{host}:{port}/proxy")
