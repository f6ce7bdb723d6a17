"""The commands that run a system many times."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..system.request import assignments
from .options import (
    FmusOption,
    MapOption,
    OutOption,
    PeriodOption,
    ReplaceOption,
    SetOption,
    StopOption,
    SystemName,
    app,
)


@app.command()
def calibrate(
    out: Annotated[
        Path | None, typer.Option("--out", help="The parameter file to write; the shipped one by default.")
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Fit the free parameters of the nominal system to the paper's Table 3 and write the parameter file."""
    from ..paper.calibration import calibrate as fit

    fit(out, fmus)


@app.command()
def converge(
    system: SystemName = "nominal",
    out: OutOption = Path("results"),
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Rerun a system with every period halved and quartered: observed order and error bar per signal."""
    from ..studies.convergence import converge as study
    from ..system.request import changes_of

    study(system, out, fmus, changes_of(replace, map_, period))


@app.command()
def bench(
    json_file: Annotated[Path | None, typer.Option("--json", help="Write the rows to this file.")] = None,
    fmus: FmusOption = None,
) -> None:
    """Measure the cost of the master beside other masters and the bare FMU calls, in one run."""
    from ..studies.bench.bench import bench as measure

    measure(json_file, fmus)


@app.command()
def sweep(
    name: Annotated[
        str, typer.Argument(metavar="NAME", help="A shipped sweep or system (see `rovbrush systems`), or a .toml file.")
    ],
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            metavar="NAME=VALUES",
            help="motor.R=0.1:0.3:7 (low:high:count, :log for equal ratios) or motor.V_in=8,12; repeatable: a grid.",
        ),
    ] = [],  # noqa: B006
    out: OutOption = Path("results"),
    set_: SetOption = [],  # noqa: B006
    stop: StopOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    random: Annotated[
        int, typer.Option("--random", min=0, metavar="COUNT", help="Random points; --vary then gives low:high.")
    ] = 0,
    seed: Annotated[int | None, typer.Option("--seed", min=0, help="Of the random points; 1 by default.")] = None,
    points: Annotated[
        Path | None, typer.Option("--points", help="A CSV file with a point per row; its head names the parameters.")
    ] = None,
    workers: Annotated[int, typer.Option("--workers", min=0, help="Processes; 0: one per core.")] = 0,
    scheduler: Annotated[
        str, typer.Option("--scheduler", metavar="ADDRESS", help="Compute on a Dask cluster, such as tcp://host:8786.")
    ] = "",
    fmus: FmusOption = None,
) -> None:
    """Run a system over ranges of parameters; an interrupted sweep goes on where it was."""
    from ..studies.sweep.sweep import Options
    from ..studies.sweep.sweep import sweep as run_sweep
    from ..system.request import changes_of

    changes = changes_of(replace, map_, period)
    options = Options(vary, assignments(set_), stop, random, seed, points, workers, scheduler, fmus, changes)
    run_sweep(name, out, options)


@app.command()
def reproduce(
    out: OutOption = Path("results"),
    claim: Annotated[
        list[int] | None, typer.Option("--claim", help="Answer only this claim and print its numbers; repeatable.")
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Answer the paper's claims one by one: claims.json and a report in one HTML page."""
    from ..paper.reproduce import reproduce as study

    study(out, fmus, claim or ())


@app.command()
def strategies(out: OutOption = Path("results"), set_: SetOption = [], fmus: FmusOption = None) -> None:  # noqa: B006
    """Compare the controller's strategies over the same passes: PID, feedforward, force control."""
    from ..paper.strategies import strategies as study

    study(out, assignments(set_), fmus)
