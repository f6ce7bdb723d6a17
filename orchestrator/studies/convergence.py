"""How far the results depend on the communication periods: rerun with every period halved and quartered.

Of every recorded signal, at the instants of the coarsest run, d1 is the largest difference between the runs with
periods 1 and 1/2, d2 that between 1/2 and 1/4. The observed order is p = log2(d1/d2). Where it shows convergence,
Richardson's extrapolation gives the error bar of the run as it stands, d1 2^p/(2^p - 1); where the differences do not
shrink there is none. The means of the summary are treated likewise.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import InputError, RunError
from ..files import prepare_folder, write_file, write_json
from ..fmu.types import BINARY, TEXT
from ..plan.plan import make_plan
from ..results.pictures.canvas import new_figure
from ..results.signals import Signals
from ..results.summary.summary import summarize
from ..results.tables import require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..system.assemble import assemble
from ..system.model import System
from ..system.request import UNCHANGED, Changes

BOUND = 0.005  # largest relative change of a mean when every period is halved
LEAST_ORDER = 0.3  # below it the differences do not shrink in earnest
ROUNDING = 1e-13  # of a signal's size: smaller differences are none
SHOWN = 30  # signals in the figure
FACTORS = (Fraction(1), Fraction(1, 2), Fraction(1, 4))


@dataclass(frozen=True)
class Convergence:
    """What halving and quartering every period changes: a row per mean and per signal, and the files that hold them."""

    name: str
    rows: list[dict[str, Any]]
    signals: list[dict[str, Any]]
    paths: list[Path]

    @property
    def outside(self) -> list[str]:
        """The means that change by more than BOUND."""
        return [r["quantity"] for r in self.rows if abs(r["change"]) > BOUND]

    def require_bound(self) -> None:
        """Raises RunError if a mean changes by more than BOUND."""
        if self.outside:
            raise RunError(f"halving every period changes {', '.join(self.outside)} by more than {100 * BOUND:g} %")


def converge(
    name: str,
    out: Path,
    fmus: Path | None,
    changes: Changes = UNCHANGED,
    tell: Callable[[str], None] = lambda _line: None,
    progress: Callable[[float], None] = lambda _share: None,
    start: str = "",
    stop: str = "",
) -> Convergence:
    """Run with periods times 1, 1/2 and 1/4, and write what each mean and signal does as JSON, CSV and figure.

    `tell` hears what the user must know of replaced components, `progress` the share of the work that is done, 0 to 1.
    `start`, `stop`: other times than the system's.
    Raises InputError for a system whose steps no period decides.
    """
    base = planned(assemble(name, {}, stop, fmus, changes, start=start))
    if base.adaptive:
        raise InputError(
            f"{base.system.path.name}: with algorithm '{base.system.algorithm}' "
            f"the tolerances decide the steps, not periods"
        )
    prepare_folder(out)
    for component in base.system.components.values():
        for note in component.notes:
            tell(note)
    begin, span = float(base.system.start), float(base.system.stop - base.system.start)
    work, done = float(sum(1 / factor for factor in FACTORS)), 0.0
    summaries, runs = [], []
    for factor in FACTORS:
        share = float(1 / factor) / work

        def reached(time: float, done: float = done, share: float = share) -> None:
            progress(done + share * (time - begin) / span)

        plan = make_plan(base.system.with_periods(factor))
        runs.append(Signals(require_complete(simulate(plan, progress=reached))))
        summaries.append(summarize(runs[-1].run))
        done += share
    rows = [row(key, [s[key] for s in summaries]) for key in summaries[0] if key.endswith("_mean")]
    compared = [key for key in runs[0].places if not key.startswith("coupling.") and is_number(base.system, key)]
    signals = [signal_row(key, runs) for key in compared]
    signals.sort(key=lambda r: r["relative"] if r["relative"] is not None else math.inf, reverse=True)
    content = {"system": name, "bound": BOUND, "rows": rows, "signals": signals}
    paths = [
        write_file(out / "convergence.json", lambda p: write_json(p, content)),
        write_file(out / "convergence.csv", lambda p: write_table(p, signals)),
        write_file(out / "convergence.png", figure(name, signals).savefig),
    ]
    return Convergence(name, rows, signals, paths)


def is_number(system: System, key: str) -> bool:
    """Whether a signal is one: texts converge to nothing."""
    component, _, variable = key.partition(".")
    kind = system.components[component].fmu.type_of(variable)
    return kind is None or kind.code not in (TEXT, BINARY)


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
    values = [
        coarse.values.astype(float),
        *(np.interp(coarse.time, run[name].time, run[name].values) for run in runs[1:]),
    ]
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
