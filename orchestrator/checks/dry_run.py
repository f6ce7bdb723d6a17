"""Runs an FMU in processes of their own, so that its crash is a row and not the end of the check."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from . import good_manners, misuse
from .subject import Subject
from .rows import Row

PATIENCE = 300.0  # s per process; a first run may compile for half a minute
CHILD = "rovbrush.orchestrator.checks.child"


def dry_run_rows(subject: Subject) -> Iterator[Row]:
    """Good manners share a process until one crashes it; every misuse has its own."""
    batches = [tuple(good_manners.RULES), *((name,) for name in misuse.RULES)]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for rows in pool.map(lambda names: run_rules(subject.path, names), batches):
            yield from rows


def run_rules(path: Path, names: Sequence[str], patience: float = PATIENCE) -> list[Row]:
    """A row for each rule of `good_manners` or `misuse`. After a crash a new process goes on with the next rule."""
    rows: list[Row] = []
    while len(rows) < len(names):
        left = names[len(rows) :]
        seen, end = _one_process(path, left, patience)
        rows += seen
        if len(seen) < len(left):
            name = left[len(seen)]
            stage = good_manners.STAGE if name in good_manners.RULES else misuse.ORDER
            mend = "it must answer with a status; find the crash in a debugger with these calls"
            rows.append(Row(stage, name.replace("_", " "), "error", end, mend))
    return rows


def _one_process(path: Path, names: Sequence[str], patience: float) -> tuple[list[Row], str]:
    """The rows of the rules that ended, and how the process ended."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.jsonl"
        command = [sys.executable, "-m", CHILD, str(path), str(report), *names]
        try:
            run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=patience, check=False)
            end = _end(run.returncode)
        except subprocess.TimeoutExpired:
            end = f"it did not come back within {patience:g} s"
        lines = report.read_text(encoding="utf-8").splitlines() if report.is_file() else []
    entries = [json.loads(line) for line in lines]
    return [Row(**entry["row"]) for entry in entries if "row" in entry], end


def _end(code: int) -> str:
    if code < 0:
        return f"the process was ended by {signal.Signals(-code).name}"
    return f"the process ended with exit code {code if code < 256 else hex(code)}"
