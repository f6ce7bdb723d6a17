"""The chain: one FMU, all checks, one report. A check that cannot go on says so in a row; nothing raises."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from ...errors import FmuError
from .archive_rules import archive_rows, loadable_row
from .description_rules import capability_rows, description_rows
from .dry_run import dry_run_rows
from .external import fmpy_row, fmutool_row
from .rows import Report, Row
from .subject import Subject, open_subject
from .table import print_report, write_json
from .unit_rules import unit_rows


def check_fmu(path: Path) -> Report:
    """Every check of one FMU."""
    try:
        subject = open_subject(path)
    except FmuError as error:
        found, _, mend = str(error).removeprefix(f"FMU {path} ").rpartition("; ")
        return Report(path, "", [Row("archive", "can be read", "error", found or mend, mend if found else "")])
    described = subject.description
    kind = f"FMI {described.fmiVersion}, {described.modelName}"
    good = f"{sum(p.is_file() for p in subject.folder.rglob('*'))} files, none outside the folder"
    return Report(path, kind, [Row("archive", "can be read", "pass", good), *_rows(subject)])


def _rows(subject: Subject) -> Iterator[Row]:
    groups: tuple[Callable[[Subject], Iterator[Row]], ...] = (
        archive_rows,
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


def check_all(paths: list[Path], json_file: Path | None) -> bool:
    """Check and print each FMU, write the JSON file if one is wanted; True if there is no error and no finding."""
    reports = []
    for path in paths:
        reports.append(check_fmu(path))
        print_report(reports[-1])
    if json_file:
        write_json(reports, json_file)
    return all(report.clean for report in reports)
