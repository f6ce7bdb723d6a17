"""Reports as a table on the terminal and as a JSON file."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from ...files import write_file
from .rows import Report

STYLES = {"pass": "green", "finding": "yellow", "error": "bold red", "not applicable": "dim", "skipped": "dim"}


def print_report(report: Report) -> None:
    """The table of one FMU, and its count in one line."""
    console = Console(width=None if sys.stdout.isatty() else 100, highlight=False)
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_edge=False)
    table.add_column("", width=7)
    table.add_column("check", width=36)
    table.add_column("found, and how to mend it", overflow="fold")
    stage = ""
    for row in report.rows:
        if row.stage != stage:
            table.add_row("", f"[bold]{escape(row.stage)}[/]", "")
            stage = row.stage
        style = STYLES[row.verdict]
        verdict = {"not applicable": "n.a."}.get(row.verdict, row.verdict)
        mend = f"\n[{style}]mend:[/] {escape(row.mend)}" if row.mend else ""
        table.add_row(f"[{style}]{verdict}[/]", escape(row.rule), escape(row.found) + mend)
    console.print(f"[bold]{escape(str(report.path))}[/]{escape(f' ({report.kind})' if report.kind else '')}")
    console.print(table)
    console.print(summary(report), style="green" if report.clean else "bold red")
    console.print()


def summary(report: Report) -> str:
    """How many checks passed, and what did not."""
    text = f"{report.count('pass')} passed, {report.count('error')} errors, {report.count('finding')} findings"
    for verdict in ("not applicable", "skipped"):
        number = report.count(verdict)
        text += f", {number} {verdict}" if number else ""
    return text


def write_json(reports: Sequence[Report], path: Path) -> None:
    """All reports as one file: a list with path, kind, counts and rows of each FMU."""
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
