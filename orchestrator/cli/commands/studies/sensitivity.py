"""The command `sensitivity`: which parameter matters."""

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
    from ....studies.sensitivity.indices import Estimate, Indices
    from ....studies.sensitivity.sensitivity import Sensitivity

SHOWN = 8  # parameters of a figure that are printed
PAIRS_SHOWN = 3
MEANING = {
    "sobol": "shares of the variance of each figure: of a parameter alone (first order), with all others (total)",
    "morris": "what the range of a parameter changes: mu* on average, whatever the sign; mu with it; sigma its spread",
}
HEADINGS = {"S1": "first order", "ST": "total", "mu_star": "mu*", "mu": "mu", "sigma": "sigma"}


@app.command()
def sensitivity(
    name: Annotated[
        str, typer.Argument(metavar="NAME", help="A shipped system or sweep (see `rovbrush systems`), or a .toml file.")
    ],
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary", metavar="NAME=RANGE", help="motor.R=0.05:0.2 (:log for equal ratios), or a list a,b; repeatable."
        ),
    ] = [],  # noqa: B006
    method: Annotated[
        str, typer.Option("--method", help="sobol: shares of the variance; morris: elementary effects, fewer runs.")
    ] = "sobol",
    samples: Annotated[
        int, typer.Option("--samples", min=0, help="Blocks of runs: 256 for Sobol (a power of 2), 20 for Morris.")
    ] = 0,
    second_order: Annotated[
        bool, typer.Option("--second-order", help="Sobol: of pairs too; nearly twice the runs.")
    ] = False,
    figure: Annotated[
        list[str],
        typer.Option(
            "--figure",
            metavar="NAME",
            help='A figure of merit of the system, or "peak motor.i"; all, if none is named.',
        ),
    ] = [],  # noqa: B006
    seed: Annotated[int | None, typer.Option("--seed", min=0, help="Of points and intervals; 1 by default.")] = None,
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
    """Which parameter matters: Sobol's or Morris's indices of each figure of merit, with 95 % intervals."""
    from ....studies.sensitivity.sensitivity import sensitivity as study
    from ....studies.sweep.options import Options
    from ....system.request import assignments, changes_of

    options = Options(
        vary, assignments(set_), stop, 0, seed, None, workers, scheduler, fmus,
        changes_of(replace, map_, period, allow_outside, parameters, scenario, event), "", force, start,
    )  # fmt: skip
    with counting(f"sensitivity {Path(name).stem}", "runs") as progress:
        found = study(name, out, options, method, samples, second_order, figure, tell, progress)
    if found.swept.cost:
        tell(found.swept.cost.text)
    tell(MEANING[found.method])
    for indices in found.indices:
        print_indices(found, indices)
    for parameter in found.idle:
        tell(f"{parameter} has no effect here: no figure of merit changes, to the last bit")
    tell_what_is_missing(found)
    wrote([out / "points.jsonl", out / "sweep.nc", out / "sweep.csv", *found.paths], out)
    found.swept.require_all()


def print_indices(found: Sensitivity, indices: Indices) -> None:
    """A table for one figure, what matters most first."""
    names, unit = found.parameters, indices.unit
    if indices.without:
        tell(f"{indices.figure}: no indices; {indices.without}")
        return
    rows = [[names[k], *(_cell(estimates[k]) for estimates in indices.of.values())] for k in indices.order()[:SHOWN]]
    of = f" [{unit}]" if found.method == "morris" else ""
    more = f" ({SHOWN} of {len(names)})" if len(names) > SHOWN else ""
    print_table(f"{indices.figure}{of}{more}", ("parameter", *(HEADINGS[key] for key in indices.of)), rows)
    pairs = sorted(indices.second.items(), key=lambda entry: -entry[1].value)[:PAIRS_SHOWN]
    told = [f"{names[j]} with {names[k]} {_cell(e)}" for (j, k), e in pairs if e.low > 0.0]
    if indices.second:
        tell(f"  second order: {'; '.join(told) or 'no pair whose interval lies above 0'}")


def _cell(estimate: Estimate) -> str:
    return f"{estimate.value:.3g}" + ("" if estimate.half != estimate.half else f" ± {estimate.half:.2g}")


def tell_what_is_missing(found: Sensitivity) -> None:
    """Blocks that were left out, and indices of which nobody can say yet whether they are 0."""
    names = found.parameters
    lost = {i.figure: i.lost for i in found.indices if i.lost and not i.without}
    if lost:
        told = ", ".join(f"{count} for {figure}" for figure, count in lost.items())
        tell(
            f"blocks were left out whole ({told}): a run of them failed or gave no number; the indices are those of "
            "the rest"
        )
    for indices in found.indices:
        if undecided := indices.undecided():
            tell(
                f"{indices.figure}: more samples are needed to say whether "
                f"{', '.join(names[k] for k in undecided)} matters: the interval is wider than the index (four times "
                "the samples halve it)"
            )
