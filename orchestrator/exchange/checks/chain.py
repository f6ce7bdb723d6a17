"""The chain: one FMU, all checks, one report. A check that cannot go on says so in a row; nothing raises."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path

from ...errors import FmuError, counted
from ...files import write_file
from ...fmu.files.archive import OURS
from .dry_run import dry_run_rows
from .external import fmpy_row, fmutool_row
from .note_rows import note_rows
from .rows import Report, Row
from .rules.archive_rules import archive_rows, loadable_row
from .rules.description_rules import capability_rows, description_rows
from .rules.unit_rules import unit_rows
from .subject import Subject, open_subject


def check_fmu(path: Path) -> Report:
    """Every check of one FMU."""
    try:
        subject = open_subject(path)
    except FmuError as error:
        found, _, mend = str(error).removeprefix(f"FMU {path}").lstrip(": ").rpartition("; ")
        return Report(path, "", [Row("archive", "can be read", "error", found or mend, mend if found else "")])
    described = subject.description
    kind = f"FMI {described.fmiVersion}, {described.modelName}"
    files = sum(p.is_file() and OURS not in p.parts for p in subject.folder.rglob("*"))
    good = f"{counted(files, 'file')}, none outside the folder"
    return Report(path, kind, [Row("archive", "can be read", "pass", good), *_rows(subject)])


def _rows(subject: Subject) -> Iterator[Row]:
    groups: tuple[Callable[[Subject], Iterator[Row]], ...] = (
        archive_rows,
        noted_rows,
        description_rows,
        unit_rows,
        capability_rows,
    )
    for group in groups:
        yield from group(subject)
    yield fmpy_row(subject)
    yield fmutool_row(subject)
    loadable = loadable_row(subject)
    yield loadable
    if loadable.verdict == "pass":
        yield from dry_run_rows(subject)


def noted_rows(subject: Subject) -> Iterator[Row]:
    """Where it breaks the standard and a run can do without."""
    yield from note_rows(subject.notes)


def write_reports(reports: Sequence[Report], path: Path) -> None:
    """All reports as one JSON file: a list with path, kind, counts and rows of each FMU. Raises RunError."""
    content = [
        {
            "fmu": str(report.path),
            "kind": report.kind,
            "errors": report.count("error"),
            "findings": report.count("finding"),
            "rows": [asdict(row) for row in report.rows],
        }
        for report in reports
    ]
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    write_file(path, lambda temporary: temporary.write_text(text, encoding="utf-8"))
