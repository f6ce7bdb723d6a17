"""Systems in this master and in others, and how it starts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..console import print_table, tell
from .words import Rows, medians


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
