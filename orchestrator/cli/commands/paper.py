"""The commands for the paper that the shipped systems come from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..console import console, print_table, tell, wrote
from ..options import FmusOption, OutOption, SetOption, app
from ..progress import counting, share

if TYPE_CHECKING:
    from ...paper.calibration import Fit


@app.command()
def calibrate(
    out: Annotated[
        Path | None, typer.Option("--out", help="The parameter file to write; the shipped one by default.")
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Fit the free parameters of the nominal system to the paper's Table 3 and write the parameter file."""
    from ...paper.calibration import calibrate as fit

    _, path = fit(out, fmus, print_fit)
    tell(f"wrote {path}")


def print_fit(fit: Fit) -> None:
    """One paragraph per rung."""
    tell("  ".join(f"{name} = {value:g}" for name, value in fit.values.items()))
    for f in fit.figures:
        wanted = f"at most {f.wanted:g}" if f.limit else f"target {f.wanted:g}  ({100 * f.deviation:+.2f} %)"
        tell(f"  {f.name:<14} {f.value:10.4f}  {wanted}")
    tell(f"  misses {', '.join(fit.missed)}" if fit.missed else "  meets every bound")


@app.command()
def reproduce(
    out: OutOption = Path("results"),
    claim: Annotated[
        list[int] | None, typer.Option("--claim", help="Answer only this claim and print its numbers; repeatable.")
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Answer the paper's claims one by one: claims.json and a report in one HTML page."""
    from ...paper.reproduce import reproduce as study

    heading = ["every run, by the command that repeats it:"]

    def began(command: str) -> None:
        while heading:
            tell(heading.pop())
        console.print(command, style="dim", markup=False)

    found = study(out, fmus, claim or (), began)
    print_claims(found.rows)
    for said in found.parameter_sets:
        tell(f"parameters: {said}")
    if claim:
        print_checks(found.rows)
    else:
        wrote(found.paths, out)
        tell(f"open {found.paths[-1]} in a browser")


def print_claims(rows: Sequence[Mapping[str, Any]]) -> None:
    """The claims and their verdicts."""
    from rich.text import Text

    from ...paper.claims import VERDICTS

    color = dict(zip(VERDICTS, ("green", "blue", "red"), strict=True))
    cells = [(str(row["number"]), row["claim"], Text(row["verdict"], color[row["verdict"]])) for row in rows]
    print_table("The paper, claim by claim", ("", "claim", "verdict"), cells, words=(1, 2))
    tell(", ".join(f"{sum(row['verdict'] == verdict for row in rows)} {verdict}" for verdict in VERDICTS))


def print_checks(rows: Sequence[Mapping[str, Any]]) -> None:
    """Every number behind the claims, and why its bound is what it is."""
    from ...paper.claims.claim import BOUNDS

    for row in rows:
        for c in row["checks"]:
            sign = "" if c["holds"] else "  does not hold"
            wanted = f"{c['rule']} {c['paper']:g}" if c["rule"] in BOUNDS else f"paper {c['paper']:g} ({c['rule']})"
            tell(f"  {row['number']}: {c['quantity']} = {c['computed']:.6g} {c['unit']}, {wanted}{sign}")
            tell(f"     why: {c['reason']}")
        for key in ("arithmetic", "note"):
            if row.get(key):
                tell(f"  {row['number']}: {row[key]}")


@app.command()
def strategies(out: OutOption = Path("results"), set_: SetOption = [], fmus: FmusOption = None) -> None:  # noqa: B006
    """Compare the controller's strategies over the same passes: PID, feedforward, force by a sensor, by an observer."""
    from ...paper.strategies import ROWS
    from ...paper.strategies import strategies as study
    from ...system.request import assignments

    with share("strategies") as progress:
        found = study(out, assignments(set_), fmus, progress)
    for name, columns in found.merits.items():
        cells = [
            (text, unit, *(f"{factor * column[key]:.3g}" for column in columns.values()))
            for key, (text, (unit, factor)) in ROWS.items()
        ]
        print_table(f"{name}: strategies over the same pass", ("", "unit", *columns), cells, words=(0, 1))
    wrote(found.paths, out)


@app.command()
def design(
    out: OutOption = Path("results"),
    points: Annotated[
        int | None,
        typer.Option("--points", min=0, help="Random points for the error bars; as many as its sweep says, 0: none."),
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Which tool, gains, sensors and thrust do the shipped task, with error bars: design.html and design.json."""
    from ...paper.design.study import design as study

    with counting("sweep monte_carlo", "points") as progress:
        found = study(out, fmus, points, lambda command: console.print(command, style="dim", markup=False), progress)
    print_table(
        "the task, and 5 to 95 % of the points", ("", "unit", "task", "5 %", "95 %"), found.answers, words=(0, 1)
    )
    if found.verdict:
        tell(found.verdict)
    wrote(found.paths, out)
    tell(f"open {found.paths[-1]} in a browser")
