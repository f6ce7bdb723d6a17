"""How far the results depend on the communication periods: rerun with every period halved and quartered."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path
from typing import Any

from rich.table import Table

from ..changes import UNCHANGED, Changes
from ..console import console, print_notes, progress
from ..errors import RunError
from ..plan import make_plan
from ..results import prepare_folder, write_file, write_json
from ..simulation import require_complete, simulate
from ..summary import summarize
from .single import planned

BOUND = 0.005  # largest relative change of a mean when every period is halved


def converge(name: str, out: Path, fmus: Path | None, changes: Changes = UNCHANGED) -> list[dict[str, Any]]:
    """Run with periods times 1, 1/2 and 1/4; print and write what each mean does. Raises RunError beyond BOUND."""
    base = planned(name, {}, fmus=fmus, changes=changes)
    prepare_folder(out)
    print_notes(base.system)
    summaries = []
    for factor in (Fraction(1), Fraction(1, 2), Fraction(1, 4)):
        plan = make_plan(base.system.with_periods(factor))
        with progress(float(plan.system.stop), f"{name}, periods times {factor}") as report:
            summaries.append(summarize(require_complete(simulate(plan, progress=report))))
    rows = [row(key, [s[key] for s in summaries]) for key in summaries[0] if key.endswith("_mean")]
    show(name, rows)
    path = write_file(out / "convergence.json", lambda p: write_json(p, {"system": name, "bound": BOUND, "rows": rows}))
    console.print(f"wrote {path}")
    outside = [r["quantity"] for r in rows if abs(r["change"]) > BOUND]
    if outside:
        raise RunError(f"halving every period changes {', '.join(outside)} by more than {100 * BOUND:g} %")
    return rows


def row(key: str, values: list[float]) -> dict[str, Any]:
    """One mean at periods times 1, 1/2, 1/4: the change by halving, the observed order, Richardson's error estimate."""
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


def show(name: str, rows: list[dict[str, Any]]) -> None:
    """The table on the terminal."""
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
