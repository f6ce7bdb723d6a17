"""What steps of components cost."""

from __future__ import annotations

from ..console import print_table
from .words import Rows, medians


def print_components(rows: Rows) -> None:
    """Every component in its lives."""
    from ...studies.bench.components.components import KINDS

    cells = []
    for name in dict.fromkeys(row["component"] for row in rows):
        cost = {row["life"]: f"{row['us_per_call']:.2f}" for row in rows if row["component"] == name}
        cells.append((name, *(cost.get(kind, "") for kind in KINDS)))
    title = f"One component by itself, microseconds per call of 1 ms, {medians(rows)}"
    print_table(title, ("component", *KINDS.values()), cells)


def print_sizes(rows: Rows) -> None:
    """Components as they grow."""
    if not rows:
        return
    cells = [
        (r["component"], r["case"], f"{r['count']:.2f}", f"{r['native_us']:.2f}", f"{r['kernel_us']:.2f}",
         f"{r['kernel_us'] / r['native_us']:.2f}")
        for r in rows
    ]  # fmt: skip
    title = f"Size, processor time per step in microseconds, {medians(rows)}"
    headings = ("component", "case", rows[0]["counts"], "native FMU", "compiled kernel", "ratio")
    print_table(title, headings, cells, words=(0, 1))


def print_windows(rows: Rows) -> None:
    """Components under wine."""
    if not rows:
        return
    cells = [(r["component"], *(f"{r[key]:.1f}" for key in ("here_us", "wine_us", "beside_us"))) for r in rows]
    title = f"FMUs for win64 under wine, microseconds per step with its exchange, {medians(rows)}"
    print_table(title, ("component", "here", "under wine", "difference"), cells)


def print_elsewhere(rows: Rows) -> None:
    """Components here, in processes, at a server."""
    costs = ("here_us", "process_us", "server_us")
    cells = [
        (r["component"], f"{r['inputs']}", f"{r['outputs']}", *(f"{r[key]:.1f}" for key in costs),
         f"{r['server_us'] - r['here_us']:.0f}")
        for r in rows
    ]  # fmt: skip
    title = f"FMUs elsewhere on this machine, microseconds per step with its exchange, {medians(rows)}"
    headings = ("component", "inputs", "outputs", "here", "process", "server", "difference")
    print_table(title, headings, cells)


def print_outside(rows: Rows) -> None:
    """Components that are no FMU."""
    if not rows:
        return
    cells = [(r["kind"], f"{r['us_per_step']:.3g}", f"{r['best_us_per_step']:.3g}") for r in rows]
    title = f"A step with {rows[0]['signals']} signals each way, microseconds, {medians(rows)}"
    print_table(title, ("component", "step", "best"), cells)
