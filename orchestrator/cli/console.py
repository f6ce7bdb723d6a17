"""What a person sees while and after a run: progress, the comparison table, the summary."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

if TYPE_CHECKING:
    from ..system.model import System

console = Console(highlight=False, soft_wrap=True, width=None if sys.stdout.isatty() else 120)
PLAIN_INTERVAL = 5.0  # s between progress lines where there is no terminal


@contextmanager
def progress(total: float, what: str, unit: str = "s", begin: int = 0) -> Iterator[Callable[[float], None]]:
    """A bar on a terminal, a line now and then elsewhere; the callback takes what is reached of `total` units."""
    started = time.monotonic()
    if not console.is_terminal:
        last = [started]

        def line(reached: float) -> None:
            now = time.monotonic()
            if now - last[0] >= PLAIN_INTERVAL and reached > begin:
                last[0] = now
                left = (now - started) * (total - reached) / (reached - begin)
                console.print(
                    f"{what}: {f'{reached:.3g}' if unit == 's' else reached} of {total:g} {unit}, {left:.0f} s left"
                )

        yield line
        return
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn(
            "{task.completed:.2f}/{task.total:g} s" if unit == "s" else f"{{task.completed:g}}/{{task.total:g}} {unit}"
        ),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(what, total=total, completed=begin)
        yield lambda reached: bar.update(task, completed=reached)


def print_comparison(rows: Sequence[Mapping[str, Any]]) -> None:
    """The paper's numbers beside the run's."""
    if not rows:
        return
    table = Table(title="Paper and simulation, means over the steady window", title_justify="left")
    for heading, justify in (
        ("quantity", "left"),
        ("unit", "left"),
        ("paper", "right"),
        ("simulated", "right"),
        ("ratio", "right"),
        ("bound", "right"),
        ("", "left"),
    ):
        table.add_column(heading, justify=justify)  # type: ignore[arg-type]
    for row in rows:
        verdict = {None: "", True: "within", False: "[bold red]outside[/]"}[row["within"]]
        bound = "" if row.get("tolerance") is None else f"{100 * row['tolerance']:g} %"
        table.add_row(
            row["label"],
            row["unit"],
            f"{row['reference']:g}",
            f"{row['value']:.5g}",
            f"{row['ratio']:.4f}",
            bound,
            verdict,
        )
    console.print(table)
    for row in rows:
        if row.get("note"):
            console.print(f"{row['label']}: {row['note']}")


def print_notes(system: System) -> None:
    """What the user must know of replaced components before a run."""
    for component in system.components.values():
        for note in component.notes:
            console.print(note, markup=False)


def print_summary(summary: Mapping[str, Any]) -> None:
    """Figures of merit, one a line."""
    for key, value in summary.items():
        if isinstance(value, float):
            console.print(f"  {key:<28} {value:.6g}")
        elif isinstance(value, (int, str)):
            console.print(f"  {key:<28} {value}")
    for loop, residual in summary.get("initial_loops", {}).items():
        console.print(f"  at time 0, {loop}: residual {residual:.3g}")
