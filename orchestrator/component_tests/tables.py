"""The bench's findings as tables of 100 columns, and its exit code."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from ..errors import RunError
from .suites import claim_of
from .verdicts import Bench, Verdict, judge, make_bench

WIDTH = 100
STYLE = {"failed": "bold red", "passed": "green", "fits": "green", "converted": "cyan", "noted": "yellow"}


def test_component(path: Path, component: str, map_path: Path | None, tolerance: float) -> int:
    """Print both tables; 0 if nothing failed, 1 otherwise. Raises RunError if not one test applies."""
    console = Console(width=WIDTH, highlight=False)
    bench = make_bench(path, component, map_path, tolerance)
    console.print(_interface(bench))
    verdicts = list(bench.judge())
    console.print(_behaviour(verdicts))
    counts = {kind: sum(v.verdict == kind for v in verdicts) for kind in ("passed", "failed", "not applicable")}
    misfits = len(bench.comparison.failures)
    console.print(
        f"{path.name} as {component}: interface {'fits' if not misfits else f'fails in {misfits}'}; of "
        f"{len(verdicts)} tests {counts['passed']} passed, {counts['failed']} failed, "
        f"{counts['not applicable']} not applicable"
    )
    if not counts["passed"] + counts["failed"]:
        raise RunError(f"{path.name}: no test of {component} could be run on it; a mapping file can name its variables")
    return int(bool(misfits or counts["failed"]))


def _interface(bench: Bench) -> Table:
    """Only what is worth a word; variables that simply fit are counted in the caption."""
    rows = bench.comparison.rows
    fitting = sum(row.finding == "fits" for row in rows)
    caption = f"{fitting} variables fit as they are"
    table = Table(title="Interface", title_justify="left", caption=caption, caption_justify="left", width=WIDTH)
    for heading, width in (("ours", 20), ("theirs", 24), ("", 9), ("", None)):
        table.add_column(heading, width=width, overflow="fold")
    for row in rows:
        if row.finding != "fits":
            table.add_row(escape(row.ours), escape(row.theirs), _styled(row.finding), escape(row.text))
    return table


def _behaviour(verdicts: list[Verdict]) -> Table:
    table = Table(title="Behaviour", title_justify="left", show_lines=True, width=WIDTH)
    for heading, width in (("claim", 48), ("verdict", 10), ("", None)):
        table.add_column(heading, width=width, overflow="fold")
    for v in verdicts:
        table.add_row(escape(v.claim), _styled(v.verdict), escape(v.text))
    return table


def _styled(word: str) -> str:
    return f"[{STYLE[word]}]{word}[/]" if word in STYLE else word
