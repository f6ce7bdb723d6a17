"""The command that measures what the master costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from ...console import print_table, tell
from ...options import FmusOption, app
from ...progress import share

Rows = Sequence[Mapping[str, Any]]


@app.command()
def bench(
    parts: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PART]...",
            help="masters, loop, foreign, start, components, sizes, long, growth, solvers, windows, elsewhere, "
            "gym, outside, pacing, observers, sweeps, workers; all by default. With --against: against, fmus.",
        ),
    ] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Fewer repetitions, shorter runs.")] = False,
    against: Annotated[
        Path | None,
        typer.Option(
            "--against",
            metavar="PATH",
            help="Compare with another installation, by its interpreter; or other FMUs, by their folder.",
        ),
    ] = None,
    json_file: Annotated[Path | None, typer.Option("--json", help="Write the rows to this file.")] = None,
    fmus: FmusOption = None,
) -> None:
    """Measure the cost of the master beside other masters and the bare FMU calls, in one run."""
    from ....studies.bench.bench import Asked
    from ....studies.bench.bench import bench as measure

    other = (None, against) if against and against.is_dir() else (against, None)
    with share("bench") as progress:
        found = measure(Asked(tuple(parts or ()), quick, fmus, *other), json_file, tell, progress)
    for name, rows in found.parts.items():
        PRINTED[name](rows)
    if json_file:
        tell(f"wrote {json_file}")


def medians(rows: Rows) -> str:
    """How often each was measured, in words."""
    return f"medians of {rows[0]['runs']} runs" if rows[0]["runs"] > 1 else "one run of each"


def _number(row: Mapping[str, Any] | None, key: str) -> str:
    """A number of a row as text; empty without the row."""
    return "" if row is None else "failed" if row[key] is None else f"{row[key]:.3g}"


def _tell_failures(rows: Rows) -> None:
    """Why other masters did not come to an end."""
    for words in dict.fromkeys(r["failed"] for r in rows if "failed" in r):
        tell(words)


def print_systems(rows: Rows) -> None:
    """The systems and masters."""
    cells = []
    for system, master in dict.fromkeys((r["system"], r["master"]) for r in rows):
        same = {r["recording"]: r for r in rows if (r["system"], r["master"]) == (system, master)}
        costs = [_number(same.get(on), "us_per_macro_step") for on in (False, True)]
        real_time = same.get(True, {}).get("real_time_factor")
        cells.append((system, master, *costs, "" if real_time is None else f"{real_time:.3g}"))
    headings = ("system", "master", "off [us]", "recording on [us]", "times real time")
    print_table(f"Cost per macro step, {medians(rows)}", headings, cells, words=(0, 1))
    _tell_failures(rows)


def _three_digits(value: float) -> str:
    """A number with three digits that count, or all before the point."""
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def print_loop(rows: Rows) -> None:
    """The loop beside the bare calls."""
    cells = []
    for r in rows:
        kind = ", ".join([*["by hand"] * r["by_hand"], *["rows"] * r["recording"]])
        ways = ("bare_us", "operations_us", "loop_us", "code_us", "best_us")
        costs = (_three_digits(r[key]) if key in r else "" for key in ways)
        cells.append(
            (f"{r['FMUs']}", r["algorithm"], kind, *costs, f"{r['ratio']:.2f}", f"{r['ratio_of_fastest']:.2f}")
        )
    title = (
        f"A macro step in microseconds, {medians(rows)} in turns, and how many times the bare calls it takes; "
        f"rows: they are recorded; by hand: Python asks for each step; one by one: its operations"
    )
    headings = (
        "FMUs", "algorithm", "", "bare", "one\nby one", "fused", "own\ncode", "fastest", "ratio",
        "of the\nfastest",
    )  # fmt: skip
    print_table(title, headings, cells, words=(1, 2))


def print_foreign(rows: Rows) -> None:
    """Systems of FMUs as other tools export them, in times of the bare calls."""
    cells = []
    for system, master in dict.fromkeys((r["system"], r["master"]) for r in rows):
        same = {r["recording"]: r for r in rows if (r["system"], r["master"]) == (system, master)}
        both = [same.get(on) for on in (False, True)]
        texts = [_number(r, key) for key in ("us_per_macro_step", "ratio") for r in both]
        cells.append((system, master, *texts))
    headings = ("system", "master", "off [us]", "recording on [us]", "to bare calls: off", "on")
    print_table(f"FMUs as other tools export them, per macro step, {medians(rows)}", headings, cells, words=(0, 1))
    _tell_failures(rows)


def print_start(rows: Rows) -> None:
    """Starts of a run, by the command and from Python."""
    names = {
        "start_s": "command: start to first step", "load_s": "Python: load",
        "first_run_s": "Python: first run of 20 ms",
        "next_run_s": "Python: next run of 20 ms",
    }  # fmt: skip
    cells = [(f"{r['system']}, {words}", f"{1e3 * r[key]:.3g}") for r in rows for key, words in names.items()]
    print_table("Starts, in processes of their own", ("", "[ms]"), cells)
    tell("; ".join(f"peak memory of the command: {r['peak_memory_MB']:.0f} MB" for r in rows))


def print_components(rows: Rows) -> None:
    """Every component in its lives."""
    from ....studies.bench.components.components import KINDS

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


def print_windows(rows: Rows) -> None:
    """Components under wine."""
    if not rows:
        return
    cells = [(r["component"], *(f"{r[key]:.1f}" for key in ("here_us", "wine_us", "beside_us"))) for r in rows]
    title = f"FMUs for win64 under wine, microseconds per step with its exchange, {medians(rows)}"
    print_table(title, ("component", "here", "under wine", "difference"), cells)


def print_solvers(rows: Rows) -> None:
    """Solvers of FMUs for Model Exchange."""
    cells = [
        (row["model"], name, f"{value:.3g}")
        for row in rows
        for name, value in row.items()
        if name not in ("part", "model")
    ]
    print_table("FMUs for Model Exchange: integration, least time of all rounds", ("model", "solver", ""), cells)


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


def print_outside(rows: Rows) -> None:
    """Components that are no FMU."""
    if not rows:
        return
    cells = [(r["kind"], f"{r['us_per_step']:.3g}", f"{r['best_us_per_step']:.3g}") for r in rows]
    title = f"A step with {rows[0]['signals']} signals each way, microseconds, {medians(rows)}"
    print_table(title, ("component", "step", "best"), cells)


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


def print_against(rows: Rows) -> None:
    """This installation over another one."""
    cells = [
        (
            r["figure"], f"{r['here_s']:.4g}", f"{r['there_s']:.4g}", f"{r['ratio']:.3f}",
            f"{r['ratio_of_fastest']:.3f}",
        ) for r in rows
    ]  # fmt: skip
    title = f"This installation and the other, medians of {rows[0]['rounds']} runs in turns"
    print_table(title, ("", "here [s]", "there [s]", "ratio", "of the\nfastest"), cells)


def print_folders(rows: Rows) -> None:
    """The FMUs of two folders: time per call, first start, size."""
    cells = [
        (
            r["fmu"], f"{r['us_per_call_here']:.4g}", f"{r['us_per_call_there']:.4g}", f"{r['us_per_call_ratio']:.3f}",
            f"{r['ratio_of_fastest']:.3f}",
            *(f"{r[key]:.2f}" if key in r else "" for key in ("first_s_here", "first_s_there", "first_s_ratio")),
            f"{r['kB_ratio']:.3f}",
        ) for r in rows
    ]  # fmt: skip
    title = f"These FMUs and the others: one call, medians of {rows[0]['rounds']} runs in turns, and the first start"
    headings = ("", "here [us]", "there [us]", "ratio", "of the\nfastest", "first [s]", "there [s]", "ratio", "size")
    print_table(title, headings, cells)


PRINTED = {
    "masters": print_systems, "loop": print_loop, "foreign": print_foreign, "start": print_start,
    "components": print_components, "sizes": print_sizes,
    "long": print_long_runs,
    "growth": print_growth, "solvers": print_solvers, "windows": print_windows, "gym": print_gym,
    "elsewhere": print_elsewhere, "outside": print_outside, "pacing": print_pacing,
    "observers": print_observers, "sweeps": print_sweeps, "workers": print_workers,
    "against": print_against, "fmus": print_folders,
}  # fmt: skip
