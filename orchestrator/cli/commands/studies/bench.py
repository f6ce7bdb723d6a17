"""The command that measures what the master costs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ...console import tell
from ...options import FmusOption, app
from ...progress import share


@app.command()
def bench(
    parts: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PART]...",
            help="masters, loop, foreign, start, components, sizes, long, growth, solvers, windows, elsewhere, "
            "gym, outside, pacing, observers, sweeps, workers; all by default. With --against: against, fmus.",
        ),
    ] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Fewer repetitions, shorter runs.")] = False,
    against: Annotated[
        Path | None,
        typer.Option(
            "--against",
            metavar="PATH",
            help="Compare with another installation, by its interpreter; or other FMUs, by their folder.",
        ),
    ] = None,
    json_file: Annotated[Path | None, typer.Option("--json", help="Write the rows to this file.")] = None,
    fmus: FmusOption = None,
) -> None:
    """Measure the cost of the master beside other masters and the bare FMU calls, in one run."""
    from ....studies.bench.bench import Asked
    from ....studies.bench.bench import bench as measure
    from ...bench_tables.printed import PRINTED

    other = (None, against) if against and against.is_dir() else (against, None)
    with share("bench") as progress:
        found = measure(Asked(tuple(parts or ()), quick, fmus, *other), json_file, tell, progress)
    for name, rows in found.parts.items():
        PRINTED[name](rows)
    if json_file:
        tell(f"wrote {json_file}")
