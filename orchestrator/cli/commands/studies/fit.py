"""The command that fits parameters to measured data."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ....errors import InputError
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
    from ....studies.fit.fit import Fitted


@app.command()
def fit(
    system: Annotated[
        str, typer.Argument(metavar="SYSTEM", help="A system or an FMU, or a .toml file of experiments.")
    ],
    data: Annotated[
        list[Path], typer.Option("--data", metavar="LOG.csv", help="time, and columns `name [unit]`; repeatable.")
    ] = [],  # noqa: B006
    vary: Annotated[
        list[str], typer.Option("--vary", metavar="NAME=LOW:HIGH", help="What is fitted, and where; :log; repeatable.")
    ] = [],  # noqa: B006
    match: Annotated[
        list[str], typer.Option("--match", metavar="NAME[=COLUMN],...", help="The signals that were measured.")
    ] = [],  # noqa: B006
    sigma: Annotated[
        list[str],
        typer.Option("--sigma", metavar="NAME=VALUE", help="Standard deviation of a signal; estimated if not given."),
    ] = [],  # noqa: B006
    loss: Annotated[
        str, typer.Option("--loss", metavar="KIND", help="linear, or against outliers soft_l1, huber, cauchy, arctan.")
    ] = "linear",
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
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Fit parameters of a system to measured data: estimates with 95 % intervals, correlations, pictures."""
    from ....studies.fit.experiment import Recipe
    from ....studies.fit.file import fit_file, is_fit_file
    from ....studies.fit.fit import Options
    from ....studies.fit.fit import fit as run_fit
    from ....system.request import assignments, changes_of

    changes = changes_of(replace, map_, period, allow_outside, parameters, scenario, event)
    options = Options(vary, match, assignments(set_), _sigma(sigma), loss, fmus, changes)
    recipes = [Recipe(path, {}, start, stop) for path in data]
    name = system
    if is_fit_file(system):
        if data or start or stop:
            raise InputError(f"{system} names its data and times; leave --data, --start and --stop out")
        name, recipes, options = fit_file(Path(system), options)
    with counting(f"fit {Path(name).stem}", "runs") as progress:
        found = run_fit(name, recipes, options, out, tell, progress)
    print_fit(found)
    wrote(found.paths, out)
    found.require_identified()


def _sigma(texts: list[str]) -> dict[str, float]:
    found = {}
    for text in texts:
        name, _, value = text.partition("=")
        try:
            found[name.strip()] = float(value)
        except ValueError:
            raise InputError(f"--sigma {text}: write NAME=VALUE with a number") from None
    return found


def print_fit(found: Fitted) -> None:
    """Estimates, signals and what must be known of them."""
    cells = [
        (one.name, one.unit, f"{one.start:.5g}", f"{one.value:.6g}", f"{one.error:.2g}",
         f"{one.low:.6g} to {one.high:.6g}") for one in found.estimates
    ]  # fmt: skip
    headings = ("parameter", "unit", "start", "estimate", "standard\nerror", "95 % interval")
    print_table(f"{found.title}: {found.evaluations} runs in {found.seconds:.1f} s", headings, cells, words=(0, 1))
    rows = [(one.name, one.unit, str(one.rows), f"{one.rms:.4g}", f"{one.durbin_watson:.2f}") for one in found.signals]
    print_table("what is left", ("signal", "unit", "rows", "rms", "Durbin-\nWatson"), rows, words=(0, 1))
    for note in found.notes:
        tell(f"note: {note}")
