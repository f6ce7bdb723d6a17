"""The points of a sweep on disk while it runs, points.jsonl; `table` makes sweep.nc and sweep.csv of them.

The first line of points.jsonl is the design, each further line a finished point, in the order of finishing. It is
only ever appended to, so that whatever ends a sweep costs at most the points under way.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO

from ...environment import changes
from ...errors import InputError, RunError, counted
from ...system.model import System
from .design.design import Design

FILE = "points.jsonl"
CONTENT = "content of system file and FMUs"
MADE_WITH = "made with"


def header(
    system: System, digest: str, design: Design, units: Mapping[str, str], made_with: Mapping[str, str]
) -> dict[str, Any]:
    """What tells a sweep from another, as it stands in the first line; `made_with`: see `environment`."""
    return {
        "system": system.name, **({"start_time_s": float(system.start)} if system.start else {}),
        "stop_s": float(system.stop), "design": design.kind, "seed": design.seed, "points": len(design),
        **{f"vary {axis.name}": list(axis.values) for axis in design.axes},
        "figures of merit": dict(units), CONTENT: digest, MADE_WITH: dict(made_with),
    }  # fmt: skip


class Points:
    """The records of a folder, by point; opened for appending."""

    def __init__(self, folder: Path, head: Mapping[str, Any], force: bool = False) -> None:
        """Raises InputError where the folder holds another sweep.

        With `force` also points that other versions, or another processor, have computed are taken.
        """
        self.path, self.force = folder / FILE, force
        self.records: dict[int, dict[str, Any]] = {}
        self.made_with: list[dict[str, str]] = []  # the versions and processors of the points, in turn
        try:
            keep = self._read(head) if self.path.is_file() else 0
            self.file: BinaryIO = self.path.open("ab", buffering=0)
            if keep:
                os.truncate(self.path, keep)  # a line that was cut short by a sudden end
                if self.made_with[-1] != head[MADE_WITH]:
                    self._write({MADE_WITH: head[MADE_WITH]})
                    self.made_with.append(head[MADE_WITH])
            else:
                with suppress(OSError):  # a device has no length
                    os.truncate(self.path, 0)
                self._write(head)
                self.made_with = [head[MADE_WITH]]
        except OSError as error:
            raise InputError(f"cannot write {self.path}: {error.strerror or error}; choose another --out") from error

    def _read(self, head: Mapping[str, Any]) -> int:
        """Take the records of an earlier part of the same sweep; the number of bytes that are complete lines."""
        content = self.path.read_bytes()
        keep = content.rfind(b"\n") + 1
        lines = content[:keep].splitlines()
        if not lines:
            return 0
        try:
            before, *records = (json.loads(line) for line in lines)
            self.made_with = [dict(before.get(MADE_WITH, {}))]
            self.made_with += [dict(record[MADE_WITH]) for record in records if MADE_WITH in record]
            self.records = {int(record.pop("point")): record for record in records if MADE_WITH not in record}
        except (ValueError, KeyError, AttributeError, TypeError):
            raise InputError(f"{self.path} is not a file of points; choose another --out, or remove it") from None
        now = json.loads(json.dumps(head))
        changed = [key for key in {**before, **now} if before.get(key) != now.get(key) and key != MADE_WITH]
        changed = [key for key in changed if key != CONTENT] or changed  # it tells less than any other
        if changed:
            what = "; ".join(f"{key}: {_short(before.get(key))}, now {_short(now.get(key))}" for key in changed)
            raise InputError(
                f"{self.path.parent} holds {counted(len(self.records), 'point')} of a different sweep ({what}); choose "
                f"another --out, or remove {FILE} there"
            )
        differing = changes(self.made_with[-1], now[MADE_WITH])
        if differing and not self.force:
            raise InputError(
                f"{self.path.parent} holds {counted(len(self.records), 'point')}, computed otherwise "
                f"({differing}): the last digits may differ; go on with --force, choose another --out, or remove "
                f"{FILE} there"
            )
        return keep

    def _write(self, content: Mapping[str, Any]) -> None:
        line = json.dumps(content, allow_nan=False).encode() + b"\n"
        if self.file.write(line) != len(line):
            raise OSError(28, "No space left on device")

    def add(self, point: int, record: dict[str, Any]) -> None:
        """Keep a finished point. Raises RunError if the disk refuses."""
        try:
            self._write({"point": point, **record})
        except OSError as error:
            raise RunError(f"cannot write {self.path}: {error.strerror or error}") from error
        self.records[point] = record

    def done(self) -> set[int]:
        """The points that need no further run; failed ones get another."""
        return {k for k, record in self.records.items() if "figures" in record}

    def close(self) -> None:
        self.file.close()


def _short(value: object) -> str:
    if isinstance(value, list) and len(value) > 3:
        return f"{value[0]} to {value[-1]} ({len(value)} values)"
    text = "nothing" if value is None else str(value)
    return text if len(text) <= 60 else f"{text[:12]}..."
