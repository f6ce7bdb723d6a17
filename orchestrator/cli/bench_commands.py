"""The command that measures what the master costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from .console import print_table, tell
from .options import FmusOption, app

Rows = Sequence[Mapping[str, Any]]


@app.command()
def bench(
    json_file: Annotated[Path | None, typer.Option("--json", help="Write the rows to this file.")] = None,
    fmus: FmusOption = None,
) -> None:
    """Measure the cost of the master beside other masters and the bare FMU calls, in one run."""
    from ..studies.bench.bench import bench as measure

    found = measure(json_file, fmus, tell)
    print_systems(found.systems)
    print_components(found.components)
    print_long_runs(found.long_runs)
    if json_file:
        tell(f"wrote {json_file}")


def print_systems(rows: Rows) -> None:
    """The systems and masters."""
    from ..studies.bench.bench import REPEATS

    cells = []
    for system, master in dict.fromkeys((r["system"], r["master"]) for r in rows):
        same = {r["recording"]: r for r in rows if (r["system"], r["master"]) == (system, master)}
        costs = [f"{same[on]['us_per_macro_step']:.3g}" if on in same else "" for on in (False, True)]
        extra = [
            f"{same[True][key]:.3g}" if key in same.get(True, {}) else ""
            for key in ("real_time_factor", "start_s", "peak_memory_MB")
        ]
        cells.append((system, master, *costs, *extra))
    headings = ("system", "master", "off [us]", "recording\non [us]", "times\nreal time", "start\n[s]", "memory\n[MB]")
    print_table(f"Cost per macro step, medians of {REPEATS} runs", headings, cells, words=(0, 1))
    for r in rows:
        if "load_s" in r:
            figures = {"load": r["load_s"], "first run": r["first_run_s"], "next run": r["next_run_s"]}
            spent = ", ".join(f"{name} {1e3 * seconds:.3g} ms" for name, seconds in figures.items())
            tell(f"{r['system']} to 20 ms from Python: {spent}")


def print_components(rows: Rows) -> None:
    """Every component in its lives."""
    from ..studies.bench.components import KINDS, REPEATS

    cells = []
    for name in dict.fromkeys(row["component"] for row in rows):
        cost = {row["life"]: f"{row['us_per_call']:.2f}" for row in rows if row["component"] == name}
        cells.append((name, *(cost.get(kind, "") for kind in KINDS)))
    title = f"One component by itself, microseconds per call of 1 ms, medians of {REPEATS} in turns"
    print_table(title, ("component", *KINDS.values()), cells)


def print_long_runs(rows: Rows) -> None:
    """Long runs with their memory."""
    cells = [
        (f"{r['macro_steps']}", f"{r['loop_s']:.2f}", f"{r['command_s']:.1f}", f"{r['peak_memory_MB']:.0f}")
        for r in rows
    ]
    headings = ("macro steps", "loop [s]", "whole command [s]", "peak memory [MB]")
    print_table("Long runs of two native FMUs: every row in result.nc", headings, cells, words=())
