"""Runs an FMU in processes of their own, so that its crash is a row and not the end of the check."""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from ...processes import fault_of
from .child import MODULE, again, broken_off
from .rows import Row
from .rules import good_manners, misuse
from .subject import Subject

PATIENCE = 300.0  # s per process; a first run may compile for half a minute


def dry_run_rows(subject: Subject) -> Iterator[Row]:
    """First whether it runs at all; then good manners and misuse, in a new process after whatever went wrong."""
    (first,) = run_rules(subject.path, ["runs"])
    yield first
    if first.verdict != "pass":
        yield Row(first.stage, "all further rules", "not applicable", "they need an FMU that runs")
        return
    batches = (tuple(good_manners.RULES)[1:], tuple(misuse.RULES))
    with ThreadPoolExecutor(len(batches)) as pool:
        for rows in pool.map(lambda names: run_rules(subject.path, names), batches):
            yield from rows


def run_rules(path: Path, names: Sequence[str], patience: float = PATIENCE) -> list[Row]:
    """A row for each rule of `good_manners` or `misuse`. See `child` for when a new process goes on."""
    rows: list[Row] = []
    while len(rows) < len(names):
        left = names[len(rows) :]
        seen, fault = _one_process(path, left, patience)
        rows += seen
        if fault and len(seen) < len(left):
            mend = f"it must answer with a status; {again(path, left[len(seen)])}"
            rows.append(broken_off(left[len(seen)], f"the process {fault}", mend))
    return rows


def _one_process(path: Path, names: Sequence[str], patience: float) -> tuple[list[Row], str]:
    """The rows of the rules that ended, and what ended the process if it was not the child's own doing."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.jsonl"
        command = [sys.executable, "-m", MODULE, str(path), str(report), *names]
        fault = fault_of(command, patience)
        lines = report.read_text(encoding="utf-8").splitlines() if report.is_file() else []
    return [Row(**json.loads(line)) for line in lines], fault
