"""What runs cost, part by part."""

from __future__ import annotations

from ..console import print_table, tell
from .words import Rows, medians


def _three_digits(value: float) -> str:
    """A number with three digits that count, or all before the point."""
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def print_loop(rows: Rows) -> None:
    """The loop beside the bare calls."""
    cells = []
    for r in rows:
        kind = ", ".join([r["algorithm"], *["by hand"] * r["by_hand"], *["rows"] * r["recording"]])
        ways = ("bare_us", "operations_us", "loop_us", "code_us", "best_us")
        costs = (_three_digits(r[key]) if key in r else "" for key in ways)
        cells.append((f"{r['FMUs']}", kind, *costs, f"{r['ratio']:.2f}", f"{r['ratio_of_fastest']:.2f}"))
    title = (
        f"A macro step in microseconds, {medians(rows)} in turns, and how many times the bare calls it takes; "
        f"rows: they are recorded; by hand: Python asks for each step; one by one: its operations"
    )
    headings = (
        "FMUs", "algorithm", "bare", "one\nby one", "fused", "own\ncode", "fastest", "ratio",
        "of the\nfastest",
    )  # fmt: skip
    print_table(title, headings, cells, words=(1,))


def print_long_runs(rows: Rows) -> None:
    """Long runs with their memory."""
    cells = [
        (f"{r['macro_steps']}", f"{r['loop_s']:.2f}", f"{r['command_s']:.1f}", f"{r['peak_memory_MB']:.0f}")
        for r in rows
    ]
    headings = ("macro steps", "loop [s]", "whole command [s]", "peak memory [MB]")
    print_table("Long runs of two native FMUs: every row in result.nc", headings, cells, words=())


def print_growth(rows: Rows) -> None:
    """Reader and plan of growing systems."""
    cells = [
        (r["grows"], f"{r['size']}", f"{r['reader_s']:.2f}", f"{r['plan_s']:.2f}", f"{r['peak_memory_MB']:.0f}")
        for r in rows
    ]
    headings = ("what grows", "size", "reader [s]", "plan [s]", "peak memory [MB]")
    print_table("Growth: CPU time, each system in a process of its own", headings, cells)


def print_solvers(rows: Rows) -> None:
    """Solvers of FMUs for Model Exchange."""
    cells = [
        (row["model"], name, f"{value:.3g}")
        for row in rows
        for name, value in row.items()
        if name not in ("part", "model")
    ]
    print_table("FMUs for Model Exchange: integration, least time of all rounds", ("model", "solver", ""), cells)


def print_gym(rows: Rows) -> None:
    """Environments: steps and resets."""
    if not rows:
        return
    cells = [
        (
            r["system"], f"{r['actions']}", f"{r['observations']}", f"{r['steps_per_s']:.0f}",
            f"{r['best_steps_per_s']:.0f}", f"{r['us_per_reset']:.1f}", f"{r['best_us_per_reset']:.1f}",
        ) for r in rows
    ]  # fmt: skip
    headings = ("system", "actions", "seen", "steps/s", "best", "reset [us]", "best")
    print_table(f"Environments of Gymnasium, nothing recorded, {medians(rows)}", headings, cells)


def print_pacing(rows: Rows) -> None:
    """Deadlines: what they cost, and how they are kept."""
    for r in rows:
        cost = (f"{r[key]:.3f}" for key in ("us_per_step", "us_per_step_with_deadline", "us_per_deadline"))
        headings = ("system", "step [us]", "with a deadline [us]", "the deadline [us]")
        title = f"Deadlines every 1 ms, all over already so that nobody waits, {medians(rows)}"
        print_table(title, headings, [(r["system"], *cost)])
        kept = f"{r['deadlines']}", f"{100 * r['within_2_ms']:.4g} %", f"{r['mean_us']:.0f}", f"{r['worst_us']:.0f}"
        told = ("deadlines", "within 2 ms", "mean lateness [us]", "worst [us]", "missed")
        print_table("The same in real time, one run", told, [(*kept, f"{r['missed']}")])


def print_observers(rows: Rows) -> None:
    """Observers: what they cost the loop, and what became of the rows."""
    alone = rows[0]["us_per_step"]
    cells = [
        (r["observer"], f"{r['us_per_step']:.3f}", f"{r['us_per_step'] - alone:+.3f}", f"{r['end_s']:.2f}", r["told"])
        for r in rows
    ]
    headings = ("observer", "macro step [us]", "more [us]", "to its end [s]", "rows of the last run")
    title = f"Four native FMUs, {medians(rows)} of 20000 steps as fast as they go"
    print_table(title, headings, cells, words=(0, 4))


def print_sweeps(rows: Rows) -> None:
    """Points of sweeps."""
    cells = [
        (
            r["system"], f"{r['points']}", f"{r['workers']}", f"{r['ms_per_point']:.3f}",
            f"{r['worker_ms_per_point']:.3f}", f"{r['loaded_anew_ms']:.2f}", f"{r['bytes_per_point']:.0f}",
        ) for r in rows
    ]  # fmt: skip
    headings = (
        "system", "points", "workers", "a point,\nresults and all [ms]", "of a core [ms]", "FMUs loaded\nanew [ms]",
        "bytes",
    )  # fmt: skip
    print_table("Sweeps: native FMUs that stay loaded, one run", headings, cells)


def print_workers(rows: Rows) -> None:
    """Threads of one run."""
    cells = [
        (
            f"{r['fmus']} of {r['step_us']:g} us", *(f"{r[f'{way}_us']:.4g}" for way in ("one", "auto", "all")),
            *(f"{r['one_us'] / r[f'{way}_us']:.2f}" for way in ("auto", "all")),
            *(f"{r['one_fastest_us'] / r[f'{way}_fastest_us']:.2f}" for way in ("auto", "all")),
            "" if r["bare_gain"] is None else f"{r['bare_gain']:.2f}",
        ) for r in rows
    ]  # fmt: skip
    threads = f"{max(rows[0]['processors'], 2)} threads"
    headings = (
        "equal FMUs", "one\n[us]", "auto\n[us]", f"{threads}\n[us]", "auto:\nfaster", f"{threads}:\nfaster",
        "auto,\nfastest", f"{threads},\nfastest", "2 bare\nthreads",
    )  # fmt: skip
    print_table(f"A macro step of FMUs that step at once, {medians(rows)} in turns", headings, cells)
    for r in rows:
        tell(r["said"])
