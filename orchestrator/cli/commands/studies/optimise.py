"""The command `optimise`: the best parameters under constraints."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

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
    app,
)
from ...progress import counting

if TYPE_CHECKING:
    from ....studies.optimise.optimise import Optimum


@app.command()
def optimise(
    name: Annotated[
        str, typer.Argument(metavar="NAME", help="A shipped system or sweep (see `rovbrush systems`), or a .toml file.")
    ],
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary", metavar="NAME=RANGE", help="motor.R=0.05:0.2 (:log for equal ratios), or a list a,b; repeatable."
        ),
    ] = [],  # noqa: B006
    minimise: Annotated[
        str, typer.Option("--minimise", metavar="FIGURE", help='A figure of merit, or "peak motor.i".')
    ] = "",
    maximise: Annotated[str, typer.Option("--maximise", metavar="FIGURE", help="As --minimise.")] = "",
    subject_to: Annotated[
        list[str],
        typer.Option("--subject-to", metavar='"FIGURE <= VALUE"', help='Or >=; also "z_max <= 5 mm"; repeatable.'),
    ] = [],  # noqa: B006
    generations: Annotated[int, typer.Option("--generations", min=1, help="After the first.")] = 20,
    population: Annotated[int, typer.Option("--population", min=0, help="Points of one; 0: 8 per parameter.")] = 0,
    polish: Annotated[int | None, typer.Option("--polish", min=0, help="Local search: 10 runs per parameter.")] = None,
    seed: Annotated[int | None, typer.Option("--seed", min=0, help="Of the search; 1 by default.")] = None,
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
    """The best parameters within ranges: a figure of merit least or greatest, others within bounds."""
    from ....studies.optimise.optimise import optimise as study
    from ....studies.optimise.optimise import require_feasible
    from ....studies.sweep.options import Options
    from ....system.request import assignments, changes_of

    options = Options(
        vary, assignments(set_), stop, 0, seed, None, workers, scheduler, fmus,
        changes_of(replace, map_, period, allow_outside, parameters, scenario, event), "", force, start,
    )  # fmt: skip
    with counting(f"optimise {Path(name).stem}", "runs") as progress:
        found = study(
            name, out, options, minimise, maximise, subject_to, generations, population, polish, tell, progress
        )
    print_found(found)
    wrote([out / "points.jsonl", *found.paths], out)
    require_feasible(found)


def print_found(found: Optimum) -> None:
    """The best point: its parameters, and the figures that were asked for."""
    best, units = found.best, found.request.units
    if best.error:
        return
    ends = found.at_end()
    rows = [
        (axis.name, axis.label(value), axis.unit, f"at the {ends[axis.name]} end" if axis.name in ends else "")
        for axis, value in zip(found.axes, best.values, strict=True)
    ]
    print_table(f"best of {len(found.trials)} runs", ("parameter", "value", "unit", ""), rows, (0, 3))
    figure = found.aim.figure
    word = "least" if found.aim.sign > 0 else "greatest"
    figures = [(figure, f"{best.figures[figure]:.6g}", units[figure], word)]
    for constraint, excess in zip(found.aim.constraints, best.excesses, strict=True):
        held = "broken" if excess > 0.0 else "active" if excess > -1e-2 else "holds"
        value = f"{best.figures[constraint.figure]:.6g}"
        unit = units[constraint.figure]
        figures.append((constraint.figure, value, unit, f"{constraint.text(unit)}: {held}"))
    print_table("figures of merit", ("figure", "value", "unit", ""), figures, (0, 3))
