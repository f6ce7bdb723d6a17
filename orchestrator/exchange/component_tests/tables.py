"""The bench's findings as tables of 100 columns, and its exit code."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from ...errors import RunError
from .verdicts import Bench, Verdict, make_bench

WIDTH = 100
STYLE = {"failed": "bold red", "passed": "green", "fits": "green", "converted": "cyan", "noted": "yellow"}


def run_bench(path: Path, component: str, map_path: Path | None, tolerance: float) -> int:
    """Print both tables; 0 if nothing failed, 1 otherwise. Raises RunError if not one test applies."""
    console = Console(width=WIDTH, highlight=False)
    bench = make_bench(path, component, map_path, tolerance)
    print_interface(bench, console)
    verdicts = list(bench.judge())
    console.print(_behaviour(verdicts))
    counts = {kind: sum(v.verdict == kind for v in verdicts) for kind in ("passed", "failed", "not applicable")}
    misfits = len(bench.comparison.failures)
    console.print(f"{path.name} as {component}: interface {'fits' if not misfits else f'fails in {misfits}'}")
    console.print(", ".join(f"{count} {kind}" for kind, count in counts.items()), f"of {len(verdicts)} tests")
    if not counts["passed"] + counts["failed"]:
        raise RunError(f"{path.name}: no test of {component} could be run on it; a mapping file can name its variables")
    return int(bool(misfits or counts["failed"]))


def print_interface(bench: Bench, console: Console) -> None:
    """A table of what is worth a word each; what simply fits, or is simply not there, is named in a line."""
    rows = bench.comparison.rows
    told = [row for row in rows if row.finding != "fits" and (row.theirs or row.finding != "absent")]
    if told:
        table = Table(title="Interface", title_justify="left", width=WIDTH)
        for heading, width in (("ours", 20), ("theirs", 24), ("", 9), ("", None)):
            table.add_column(heading, width=width, overflow="fold")
        for row in told:
            table.add_row(escape(row.ours), escape(row.theirs), _styled(row.finding), escape(row.text))
        console.print(table)
    console.print(f"{sum(row.finding == 'fits' for row in rows)} variables fit as they are")
    absent = [row.ours for row in rows if row.finding == "absent" and not row.theirs]
    if absent:
        console.print(f"not there, so that tests which need them do not apply: {', '.join(absent)}", markup=False)


def _behaviour(verdicts: list[Verdict]) -> Table:
    table = Table(title="Behaviour", title_justify="left", show_lines=True, width=WIDTH)
    for heading, width in (("claim", 48), ("verdict", 10), ("", None)):
        table.add_column(heading, width=width, overflow="fold")
    for v in verdicts:
        table.add_row(escape(v.claim), _styled(v.verdict), escape(v.text))
    return table


def _styled(word: str) -> str:
    return f"[{STYLE[word]}]{word}[/]" if word in STYLE else word
