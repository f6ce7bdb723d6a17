"""How far the results depend on the communication periods: rerun with every period halved and quartered.

Of every recorded signal, at the instants of the coarsest run, d1 is the largest difference between the runs with
periods 1 and 1/2, d2 that between 1/2 and 1/4. The observed order is p = log2(d1/d2). Where it shows convergence,
Richardson's extrapolation gives the error bar of the run as it stands, d1 2^p/(2^p - 1); where the differences do not
shrink there is none. The means of the summary are treated likewise.
"""

from __future__ import annotations

import csv
import math
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from rich.table import Table

from ..cli.console import console, print_notes, progress
from ..errors import InputError, RunError
from ..files import prepare_folder, write_file, write_json
from ..plan.plan import make_plan
from ..results.plots import new_figure
from ..results.signals import Signals
from ..results.summary import summarize
from ..results.tables import require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..system.assemble import assemble
from ..system.request import UNCHANGED, Changes

BOUND = 0.005  # largest relative change of a mean when every period is halved
LEAST_ORDER = 0.3  # below it the differences do not shrink in earnest
ROUNDING = 1e-13  # of a signal's size: smaller differences are none
SHOWN = 30  # signals in the table and in the figure
FACTORS = (Fraction(1), Fraction(1, 2), Fraction(1, 4))


def converge(name: str, out: Path, fmus: Path | None, changes: Changes = UNCHANGED) -> list[dict[str, Any]]:
    """Run with periods times 1, 1/2 and 1/4; print and write what each mean and signal does.

    Returns the rows of the means. Raises RunError if one of them changes by more than BOUND, InputError for a system
    whose steps no period decides.
    """
    base = planned(assemble(name, {}, fmus=fmus, changes=changes))
    if base.adaptive:
        raise InputError(f"{base.system.path.name}: with algorithm 'ecco' the tolerances decide the steps, not periods")
    prepare_folder(out)
    print_notes(base.system)
    summaries, runs = [], []
    for factor in FACTORS:
        plan = make_plan(base.system.with_periods(factor))
        with progress(float(plan.system.stop), f"{name}, periods times {factor}") as report:
            runs.append(Signals(require_complete(simulate(plan, progress=report))))
        summaries.append(summarize(runs[-1].run))
    rows = [row(key, [s[key] for s in summaries]) for key in summaries[0] if key.endswith("_mean")]
    signals = [signal_row(key, runs) for key in runs[0].places if not key.startswith("coupling.")]
    signals.sort(key=lambda r: r["relative"] if r["relative"] is not None else math.inf, reverse=True)
    if rows:
        show(name, rows)
    show_signals(name, signals)
    content = {"system": name, "bound": BOUND, "rows": rows, "signals": signals}
    paths = [
        write_file(out / "convergence.json", lambda p: write_json(p, content)),
        write_file(out / "convergence.csv", lambda p: write_table(p, signals)),
        write_file(out / "convergence.png", figure(name, signals).savefig),
    ]
    console.print(f"wrote {', '.join(path.name for path in paths)} to {out}")
    outside = [r["quantity"] for r in rows if abs(r["change"]) > BOUND]
    if outside:
        raise RunError(f"halving every period changes {', '.join(outside)} by more than {100 * BOUND:g} %")
    return rows


def row(key: str, values: list[float]) -> dict[str, Any]:
    """One mean at periods times 1, 1/2, 1/4: the change by halving, the observed order."""
    first, second = values[0] - values[1], values[1] - values[2]
    order = math.log2(abs(first / second)) if first and second else None
    scale = abs(values[0]) or 1.0
    return {
        "quantity": key,
        "values": values,
        "change": first / scale,
        "change_quartered": second / scale,
        "order": order,
    }


def signal_row(name: str, runs: list[Signals]) -> dict[str, Any]:
    """One signal: both differences, observed order, error bar, and that relative to the signal's largest magnitude.

    The order is None where a difference is nothing but rounding; the error bar is None where nothing converges.
    """
    coarse = runs[0][name]
    values = [coarse.values, *(np.interp(coarse.time, run[name].time, run[name].values) for run in runs[1:])]
    size = float(np.max(np.abs(values[2])))
    first, second = (float(np.max(np.abs(a - b))) for a, b in pairwise(values))
    order: float | None = None
    bar: float | None = 0.0
    if max(first, second) > ROUNDING * size:
        order = math.log2(first / second) if first and second else None
        gain = 2.0**order if order is not None else 1.0
        bar = first * gain / (gain - 1.0) if order is not None and order >= LEAST_ORDER else None
    relative = None if bar is None else bar / size if size else 0.0
    return {
        "signal": name, "unit": coarse.unit, "difference_halved": first, "difference_quartered": second,
        "order": order, "error_bar": bar, "relative": relative,
    }  # fmt: skip


def show(name: str, rows: list[dict[str, Any]]) -> None:
    """The means on the terminal."""
    table = Table(title=f"{name}: means with every period times 1, 1/2, 1/4", title_justify="left")
    for heading in ("mean", "1", "1/2", "1/4", "change by halving", "by halving again", "observed order"):
        table.add_column(heading, justify="left" if heading == "mean" else "right")
    for r in rows:
        order = "-" if r["order"] is None else f"{r['order']:.2f}"
        table.add_row(
            r["quantity"],
            *(f"{v:.6g}" for v in r["values"]),
            f"{100 * r['change']:.1e} %",
            f"{100 * r['change_quartered']:.1e} %",
            order,
        )
    console.print(table)


def show_signals(name: str, rows: list[dict[str, Any]]) -> None:
    """The signals with the largest error bars on the terminal; those that do not converge come first."""
    title = f"{name}: signals, periods as they are"
    table = Table(title=f"{title} ({SHOWN} of {len(rows)})" if len(rows) > SHOWN else title, title_justify="left")
    for heading in ("signal", "unit", "halved: changes by", "halved again", "observed order", "error bar", "relative"):
        table.add_column(heading, justify="left" if heading in ("signal", "unit") else "right")
    for r in rows[:SHOWN]:
        order = "-" if r["order"] is None else f"{r['order']:.2f}"
        bar = ("does not converge", "") if r["error_bar"] is None else (f"{r['error_bar']:.2e}", f"{r['relative']:.1e}")
        differences = (f"{r[key]:.2e}" for key in ("difference_halved", "difference_quartered"))
        table.add_row(r["signal"], r["unit"], *differences, order, *bar)
    console.print(table)


def write_table(path: Path, rows: list[dict[str, Any]]) -> None:
    """All signals as CSV; what is not known is an empty cell."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]) if rows else ["signal"])
        writer.writeheader()
        writer.writerows(rows)


def figure(name: str, rows: list[dict[str, Any]]) -> Any:
    """The largest error bars, relative to the size of their signals, with the observed orders."""
    known = [r for r in rows if r["error_bar"]][:SHOWN]
    drawn, (axis,) = new_figure(f"{name}: error bars of the signals, and observed orders")
    drawn.set_size_inches(8.0, 2.0 + 0.25 * len(known))
    for k, r in enumerate(reversed(known)):
        axis.plot([r["relative"]], [k], "o", color="tab:blue")
        axis.annotate(f"  order {r['order']:.2f}", (r["relative"], k), va="center", fontsize="small")
    axis.set_yticks(range(len(known)), [f"{r['signal']} [{r['unit']}]" for r in reversed(known)], fontsize="small")
    if known:
        axis.set_xscale("log")
        axis.margins(x=0.2)
    axis.set_xlabel("error bar over the signal's largest magnitude [1]")
    return drawn
