"""The commands for FMUs that come from others or go to them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .options import app


@app.command()
def check(
    fmus: Annotated[list[Path], typer.Argument(metavar="FMU...", help="The files to check, FMI 2.0 or 3.0.")],
    json_file: Annotated[Path | None, typer.Option("--json", help="Write all rows to this file.")] = None,
) -> None:
    """Check FMUs: archive, description, other tools' opinions, and a dry run in processes of its own."""
    from .checks.chain import check_all

    if not check_all(fmus, json_file):
        raise typer.Exit(1)
