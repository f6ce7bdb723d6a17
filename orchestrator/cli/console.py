"""What a person sees of a run: messages, tables, the comparison, the summary."""

from __future__ import annotations

import errno
import os
import re
import sys
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from ..errors import counted
from ..files import typed

if TYPE_CHECKING:
    from ..plan.plan import Plan
    from ..system.model import System
    from ..system.request import Request


PATH = re.compile(r'"[^"]*[/\\][^"]*"|\'[^\']*[/\\][^\']*\'')  # in quotes: is copied, so it stays in one line
HARD = "\N{NO-BREAK SPACE}"
FOLDED = 16  # characters that a column of words keeps at least, where it has so many
TIGHT = 10  # and where that saves a second table


class Stdout:
    """Standard output as long as somebody reads: a closed pipe or a full disk must not cost a run its results.

    `lost` says why nothing is printed any more; the command line tells it on stderr at the end.
    """

    lost = ""

    def write(self, text: str) -> int:
        self._try(sys.stdout.write, text)
        return len(text)

    def flush(self) -> None:
        self._try(sys.stdout.flush)

    def _try(self, act: Callable[..., object], *arguments: str) -> None:
        try:
            if not self.lost:
                act(*arguments)
        except OSError as error:
            self.lost = os.strerror(error.errno or errno.EIO)
            with suppress(OSError, ValueError):  # what is still in a buffer goes nowhere when the process ends
                nowhere = os.open(os.devnull, os.O_WRONLY)
                os.dup2(nowhere, sys.stdout.fileno())
                os.close(nowhere)

    def __getattr__(self, name: str) -> Any:
        return getattr(sys.stdout, name)


stdout = Stdout()
WIDTH = 100  # columns where neither a terminal nor COLUMNS says how many there are
EVENTS_SHOWN = 12  # lines of a summary
ALWAYS = {"simulated_s": "s", "wall_s": "s", "start_s": "s", "peak_memory_MB": "MB"}  # units in every summary
FOLDING = sys.stdout.isatty() or "COLUMNS" in os.environ  # a file or a pipe gets whole lines
console = Console(
    file=stdout,  # type: ignore[arg-type]
    highlight=False,
    soft_wrap=not FOLDING,
    width=None if FOLDING else WIDTH,
)


def leave_stdout() -> None:
    """From now on messages go to stderr: the rows of a run are what standard output is for."""
    console.file = sys.stderr


def tell(text: str) -> None:
    """Plain text: lines that are too long for the terminal are folded between words, and go on indented."""
    if FOLDING:
        text = "\n".join(map(_folded, text.split("\n")))
    console.print(text, markup=False, soft_wrap=True)  # a path longer than the terminal stays one word


def _folded(line: str) -> str:
    if len(line) <= console.width:
        return line
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    whole = PATH.sub(lambda found: found[0].replace(" ", HARD), line)
    words = textwrap.wrap(
        whole, console.width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False,
        drop_whitespace=True, replace_whitespace=False,
    )  # fmt: skip
    return "\n".join(words).replace(HARD, " ")


def wrote(paths: Sequence[Path], folder: Path) -> None:
    """The files of a folder that a command has made."""
    tell(f"wrote {', '.join(path.name for path in paths)} to {folder}")


def print_table(
    title: str,
    headings: Sequence[str],
    rows: Iterable[Sequence[str | Text]],
    words: Sequence[int] = (0,),
    show_lines: bool = False,
) -> None:
    """A table within the width of the terminal: columns of `words` are folded, never cut, numbers stay whole.

    Where the columns find no room beside each other there is a table for each part of them, the leading `words` in
    each and the title above the first. Cells are plain text, or styled; brackets in them mean nothing.
    """
    cells = [[Text(cell) if isinstance(cell, str) else cell for cell in row] for row in rows]
    widths = [
        max(Text(heading).__rich_measure__(console, console.options).maximum, *(row[k].cell_len for row in cells), 0)
        for k, heading in enumerate(headings)
    ]
    for part, columns in enumerate(columns_that_fit(widths, words, console.width)):
        table = Table(title=None if part else Text(title), title_justify="left", show_lines=show_lines)
        for k in columns:
            if k in words:
                table.add_column(Text(headings[k]), overflow="fold")
            else:
                table.add_column(Text(headings[k]), justify="right", no_wrap=True, overflow="fold")
        for row in cells:
            table.add_row(*(row[k] for k in columns))
        console.print(table, soft_wrap=False)


def columns_that_fit(widths: Sequence[int], words: Sequence[int], room: int) -> list[list[int]]:
    """The columns of each table: those of `words` can be folded, the leading ones of them stand in each."""
    need, tight = (
        [min(width, least if k in words else width) + 3 for k, width in enumerate(widths)] for least in (FOLDED, TIGHT)
    )
    if 1 + sum(tight) <= room:
        return [list(range(len(widths)))]
    lead = [k for k in range(len(widths)) if set(range(k + 1)) <= set(words)]
    tables: list[list[int]] = []
    for k in range(len(lead), len(widths)):
        if not tables or 1 + sum(need[n] for n in (*tables[-1], k)) > room:
            tables.append(list(lead))
        tables[-1].append(k)
    return tables or [lead]


def print_comparison(rows: Sequence[Mapping[str, Any]], steady: bool = True) -> None:
    """The paper's numbers beside the run's; of a run that did not become `steady` there is no verdict."""
    if not rows:
        return
    cells = []
    for row in rows:
        bound = "" if row.get("tolerance") is None else f"{100 * row['tolerance']:g} %"
        verdict = {None: Text(""), True: Text("within"), False: Text("outside", "bold red")}[row["within"]]
        numbers = (f"{row['reference']:g}", f"{row['value']:.5g}", f"{row['ratio']:.4f}", bound)
        cells.append((row["label"], row["unit"], *numbers, verdict))
    headings = ("quantity", "unit", "paper", "simulated", "ratio", "bound", "")
    over = "means over the steady window" if steady else "not steady: no verdict"
    print_table(f"Paper and simulation, {over}", headings, cells, words=(0, 1, 6))
    for row in rows:
        if row.get("note"):
            tell(f"{row['label']}: {row['note']}")


def print_notes(system: System) -> None:
    """What the user must know before a run: of replaced components, and of FMUs that break the standard."""
    from ..system.inputs.free_inputs import start_notes

    for fmu in {component.fmu.digest: component.fmu for component in system.components.values()}.values():
        if fmu.notes:
            tell(
                f"{fmu.path.name} breaks the standard in {counted(len(fmu.notes), 'point')} that a run can do without: "
                f"`rovbrush check {typed(fmu.path)}` lists them, --strict makes them errors"
            )
    if system.breaches:
        tell(
            f"{system.path.name} breaks the standard in {counted(len(system.breaches), 'point')} that a run can do "
            f"without: `rovbrush check {typed(system.path)}` lists them, --strict makes them errors"
        )
    for remark in system.remarks:
        tell(remark)
    for component in system.components.values():
        for note in component.notes:
            tell(note)
    for note in start_notes(system):
        tell(note)


def print_transfers(plan: Plan, request: Request) -> None:
    """What the plan chose between rates, what it holds that was extrapolated before, and what aliases."""
    from ..plan.remarks import aliased, chosen, held_now

    if text := chosen(plan):
        options = [f"--{key}" for key in ("replace", "map_", "period", "set_", "input_") if getattr(request, key)]
        with_ = f" with the same {', '.join(options)}".replace("_", "") if options else ""
        tell(f"{text}: `rovbrush plan {typed(request.system)}`{with_} shows each")
    for line in (*held_now(plan), *aliased(plan)):
        tell(line)


def print_summary(summary: Mapping[str, Any], units: Mapping[str, str] | None = None) -> None:
    """Figures of merit, one a line, with the `units` of those that have one."""
    known = {**ALWAYS, **(units or {})}
    for key, value in summary.items():
        if isinstance(value, (int, float, str)):
            number = f"{value:.6g}" if isinstance(value, float) else str(value)
            unit = known.get(key, "")
            tell(f"  {key:<28} {number}{'' if unit in ('', '1') else f' {unit}'}")
    lines = summary.get("events", ())
    if lines:
        tell("  what happened")
    for line in lines[:EVENTS_SHOWN]:
        tell(f"    {line}")
    if len(lines) > EVENTS_SHOWN:
        tell(f"    and {len(lines) - EVENTS_SHOWN} more events, all in the group `events` of result.nc")
    if waiting := summary.get("did_not_happen"):
        tell(f"  did not happen: {', '.join(waiting)}")
    for loop, residual in summary.get("initial_loops", {}).items():
        tell(f"  at the start, {loop}: residual {residual:.3g}")
