"""The commands that run a system many times: refined periods, ranges of parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ... import completion
from ...console import print_table, tell, wrote
from ...options import (
    EventOption,
    FmusOption,
    MapOption,
    OutOption,
    OutsideOption,
    ParametersOption,
    PeriodOption,
    ReplaceOption,
    ScenarioOption,
    SetOption,
    StartOption,
    StopOption,
    SystemName,
    app,
)
from ...progress import counting, share

if TYPE_CHECKING:
    from ....studies.sweep.table import Table

SIGNALS_SHOWN = 30
POINTS_SHOWN = 12  # of a sweep along one axis that are printed as a table


@app.command()
def converge(
    system: SystemName = "nominal",
    out: OutOption = Path("results"),
    start: StartOption = "",
    stop: StopOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    scenario: ScenarioOption = [],  # noqa: B006
    event: EventOption = [],  # noqa: B006
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Rerun a system with every period halved and quartered: observed order and error bar per signal."""
    from ....studies.convergence import converge as study
    from ....system.request import changes_of

    with share(f"{Path(system).stem}, with every period times 1, 1/2, 1/4") as progress:
        changes = changes_of(replace, map_, period, allow_outside, parameters, scenario, event)
        found = study(system, out, fmus, changes, tell, progress, start, stop)
    print_means(Path(system).stem, found.rows)
    print_signals(Path(system).stem, found.signals)
    wrote(found.paths, out)
    found.require_bound()


def print_means(name: str, rows: Sequence[Mapping[str, Any]]) -> None:
    """What the means do with the periods."""
    if not rows:
        return
    cells = [
        (
            r["quantity"], *(f"{v:.6g}" for v in r["values"]), f"{100 * r['change']:.1e} %",
            f"{100 * r['change_quartered']:.1e} %", "-" if r["order"] is None else f"{r['order']:.2f}",
        ) for r in rows
    ]  # fmt: skip
    headings = ("mean", "1", "1/2", "1/4", "change by\nhalving", "by halving\nagain", "observed\norder")
    print_table(f"{name}: means with every period times 1, 1/2, 1/4", headings, cells)


def print_signals(name: str, rows: Sequence[Mapping[str, Any]]) -> None:
    """The signals with the largest error bars; those that do not converge come first."""
    cells = []
    for r in rows[:SIGNALS_SHOWN]:
        order = "-" if r["order"] is None else f"{r['order']:.2f}"
        bar = ("none", "") if r["error_bar"] is None else (f"{r['error_bar']:.2e}", f"{r['relative']:.1e}")
        differences = (f"{r[key]:.2e}" for key in ("difference_halved", "difference_quartered"))
        cells.append((r["signal"], r["unit"], *differences, order, *bar))
    title = f"{name}: signals, periods as they are"
    title += f" ({SIGNALS_SHOWN} of {len(rows)})" if len(rows) > SIGNALS_SHOWN else ""
    headings = ("signal", "unit", "halved:\nchanges by", "halved\nagain", "observed\norder", "error\nbar", "relative")
    print_table(title, headings, cells, words=(0, 1))
    lost = sum(r["error_bar"] is None for r in rows)
    if lost:
        tell(f"error bar none: the signal does not converge ({lost} of {len(rows)})")


@app.command()
def sweep(
    name: Annotated[
        str,
        typer.Argument(
            metavar="NAME",
            autocompletion=completion.sweeps,
            help="A shipped sweep or system (see `rovbrush systems`), or a .toml file.",
        ),
    ],
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            metavar="NAME=VALUES",
            autocompletion=completion.varied,
            help="motor.R=0.1:0.3:7 (low:high:count, :log for equal ratios) or motor.V_in=8,12; repeatable: a grid.",
        ),
    ] = [],  # noqa: B006
    out: OutOption = Path("results"),
    set_: SetOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    scenario: ScenarioOption = [],  # noqa: B006
    event: EventOption = [],  # noqa: B006
    random: Annotated[
        int, typer.Option("--random", min=0, metavar="COUNT", help="Random points; --vary then gives low:high.")
    ] = 0,
    seed: Annotated[int | None, typer.Option("--seed", min=0, help="Of the random points; 1 by default.")] = None,
    design: Annotated[
        str,
        typer.Option(
            "--design", metavar="KIND", help="How --random fills the ranges: random, latin (hypercube) or sobol."
        ),
    ] = "",
    points: Annotated[
        Path | None, typer.Option("--points", help="A CSV file with a point per row; its head names the parameters.")
    ] = None,
    workers: Annotated[int, typer.Option("--workers", min=0, help="Processes; 0: one per core.")] = 0,
    scheduler: Annotated[
        str, typer.Option("--scheduler", metavar="ADDRESS", help="Compute on a Dask cluster, such as tcp://host:8786.")
    ] = "",
    force: Annotated[
        bool, typer.Option("--force", help="Go on although other versions or another processor computed what is there.")
    ] = False,
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Run a system over ranges of parameters; an interrupted sweep goes on where it was."""
    from ....studies.sweep.options import Options
    from ....studies.sweep.picture import write_pictures
    from ....studies.sweep.sweep import sweep as run_sweep
    from ....system.request import assignments, changes_of

    changes = changes_of(replace, map_, period, allow_outside, parameters, scenario, event)
    options = Options(
        vary,
        assignments(set_),
        stop,
        random,
        seed,
        points,
        workers,
        scheduler,
        fmus,
        changes,
        design,
        force,
        start,
    )
    with counting(f"sweep {Path(name).stem}", "points") as progress:
        found = run_sweep(name, out, options, tell, progress)
    if found.cost:
        tell(found.cost.text)
    print_points(found.table)
    for axis in found.table.without_effect():
        tell(f"{axis} has no effect here: no figure of merit changes, to the last bit")
    pictures = write_pictures(found.dataset, out)
    wrote([out / "points.jsonl", out / "sweep.nc", out / "sweep.csv", *pictures.paths], out)
    found.require_all()
    pictures.require_all()


def print_points(table: Table) -> None:
    """A sweep along one axis: each figure of merit at the first point, and its change from there at the others."""
    design = table.design
    if len(design.axes) != 1 or len(design) > POINTS_SHOWN:
        return
    axis = design.axes[0]
    cells = []
    for name, (unit, _) in table.figures.items():
        first, *others = table.column(name).tolist()
        changes = (f"{100 * (value / first - 1):+.3g} %" if first and value == value else "-" for value in others)
        cells.append((f"{name} [{unit}]", f"{first:.5g}", *changes))
    headings = [axis.label(value) for value in axis.values]
    title = f"{table.title}: the first point, and the change from it"
    print_table(title, (f"{axis.name} [{axis.unit}]", *headings), cells)
