"""The commands that judge FMUs: `check` and `test-component`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.table import Table
from rich.text import Text

from ...console import console, print_table, tell
from ...guard import sheltered
from ...options import OutsideOption, app

if TYPE_CHECKING:
    from ....exchange.checks.rows import Report
    from ....exchange.component_tests.compare import Comparison
    from ....exchange.component_tests.verdicts import Verdict

STYLES = {
    "pass": "green", "finding": "yellow", "error": "bold red", "not applicable": "dim", "skipped": "dim",
    "passed": "green", "failed": "bold red", "fits": "green", "converted": "cyan", "noted": "yellow",
}  # fmt: skip


@app.command()
def check(
    fmus: Annotated[list[Path], typer.Argument(metavar="FMU...", help="FMUs of FMI 1.0, 2.0, 3.0; SSPs; OSP's files.")],
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit with 1 for findings too, not only for errors.")
    ] = False,
    allow_outside: OutsideOption = [],  # noqa: B006
    json_file: Annotated[Path | None, typer.Option("--json", help="Write all rows to this file.")] = None,
) -> None:
    """Check FMUs: archive, description, other tools' opinions, and a dry run in processes of its own.

    Of a system's file of SSP or OSP itself, and then the FMUs in it.
    """
    from ....exchange.checks.chain import write_reports
    from ....exchange.checks.systems import check_file

    reports = []
    for path in fmus:
        for report in check_file(path, allow_outside):
            reports.append(report)
            print_report(report)
    if json_file:
        write_reports(reports, json_file)
    if any(report.count("error") or (strict and not report.clean) for report in reports):
        raise typer.Exit(1)


def print_report(report: Report) -> None:
    """The table of one FMU, and its count in one line."""
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_edge=False)
    table.add_column("", width=7)
    table.add_column("check", width=36)
    table.add_column("found, and how to mend it", overflow="fold")
    stage = ""
    for row in report.rows:
        if row.stage != stage:
            table.add_row("", Text(row.stage, "bold"), "")
            stage = row.stage
        style = STYLES[row.verdict]
        found = Text(row.found)
        if row.mend:
            found.append("\nmend:", style).append(f" {row.mend}")
        table.add_row(Text({"not applicable": "n.a."}.get(row.verdict, row.verdict), style), Text(row.rule), found)
    console.print(Text.assemble((str(report.path), "bold"), f" ({report.kind})" if report.kind else ""))
    console.print(table, soft_wrap=False)
    style = "green" if report.clean else "bold red" if report.count("error") else "yellow"
    console.print(report.text, style=style)
    console.print()


@app.command("test-component")
def test_component(
    fmu: Annotated[Path, typer.Argument(metavar="FMU", help="The file to test, FMI 1.0, 2.0 or 3.0.")],
    component: Annotated[str, typer.Option("--as", metavar="NAME", help="The component that it claims to be.")],
    map_: Annotated[Path | None, typer.Option("--map", help="Mapping file, where it has other names.")] = None,
    tolerance: Annotated[
        float, typer.Option("--tolerance", min=0.0, help="Relative error granted to its solver.")
    ] = 1e-3,
) -> None:
    """Test an FMU as one of the components: its interface, then the component's own behaviour tests."""
    if sheltered(fmu, judge_and_print, fmu, component, map_, tolerance):
        raise typer.Exit(1)


def judge_and_print(path: Path, component: str, map_path: Path | None, tolerance: float) -> int:
    """Print both tables; 0 if nothing failed, 1 otherwise. Raises RunError if not one test applies.

    In a process of its own.
    """
    from ....exchange.component_tests.verdicts import make_bench, require_applicable, require_outputs

    bench = make_bench(path, component, map_path, tolerance)
    print_interface(bench.comparison)
    require_outputs(bench)
    verdicts = list(bench.judge())
    print_verdicts("Behaviour", verdicts)
    failed = [v for v in verdicts if v.verdict == "failed"]
    if failed and len(failed) < len(verdicts):
        print_verdicts("What failed", failed)
    misfits = len(bench.comparison.failures)
    tell(f"{path.name} as {component}: interface {'fits' if not misfits else f'fails in {misfits}'}")
    kinds = ("passed", "failed", "not applicable")
    counts = ", ".join(f"{sum(v.verdict == kind for v in verdicts)} {kind}" for kind in kinds)
    tell(f"{counts} of {len(verdicts)} tests")
    require_applicable(path, component, verdicts)
    return int(bool(misfits or failed))


def print_interface(comparison: Comparison) -> None:
    """A table of what is worth a word each; what simply fits, or is simply not there, is named in a line."""
    rows = comparison.rows
    told = [row for row in rows if row.finding != "fits" and (row.theirs or row.finding != "absent")]
    if told:
        cells = [(row.ours, row.theirs, styled(row.finding), row.text) for row in told]
        print_table("Interface", ("ours", "theirs", "", ""), cells, words=(0, 1, 2, 3))
    tell(f"{sum(row.finding == 'fits' for row in rows)} variables fit as they are")
    absent = [row.ours for row in rows if row.finding == "absent" and not row.theirs]
    if absent:
        tell(f"not there, so that tests which need them do not apply: {', '.join(absent)}")


def print_verdicts(title: str, verdicts: Sequence[Verdict]) -> None:
    """A row per test."""
    cells = [(v.claim, styled(v.verdict), v.text) for v in verdicts]
    print_table(title, ("claim", "verdict", ""), cells, words=(0, 1, 2), show_lines=True)


def styled(word: str) -> Text:
    """A verdict in its colour."""
    return Text(word, STYLES.get(word, ""))
