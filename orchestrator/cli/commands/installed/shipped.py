"""The commands for what comes with the package: its systems and sweeps, and its documentation."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ....errors import InputError
from ....files import typed
from ... import completion
from ...console import tell, wrote
from ...options import app


@app.command()
def systems(
    copy: Annotated[
        str,
        typer.Option(
            "--copy",
            metavar="NAME",
            autocompletion=completion.copies,
            help="Copy this one, with what it refers to, to begin with.",
        ),
    ] = "",
    to: Annotated[Path | None, typer.Option("--to", metavar="DIR", help="Copy it there; by default here.")] = None,
) -> None:
    """List the shipped systems, parameter sets and sweeps; or copy one of them, to change it."""
    from ....studies.sweep.file import shipped_sweeps
    from ....system.file.copied import copy_shipped
    from ....system.file.parameter_sets import shipped_sets
    from ....system.file.reader import system_description
    from ....system.file.shipped import SWEEPS, SYSTEMS, shipped_systems

    if to is not None and not copy:
        raise InputError("--to DIR says where a copy goes; say of what with --copy NAME")
    if copy:
        folder = to or Path()
        paths = copy_shipped(copy, folder)
        wrote(paths, folder)
        tell(f"  rovbrush {'sweep' if paths[0].stem in shipped_sweeps() else 'run'} {typed(paths[0])} --out results")
        return
    for name in shipped_systems():
        tell(f"{name:<20} {system_description(SYSTEMS / f'{name}.toml')}")
    tell("\nparameter sets, for `--parameters`:")
    for name, about in shipped_sets().items():
        tell(f"{name:<20} {about}")
    tell("\nsweeps, for `rovbrush sweep`:")
    for name in shipped_sweeps():
        tell(f"{name:<20} {system_description(SWEEPS / f'{name}.toml')}")


@app.command()
def docs(
    path: Annotated[bool, typer.Option("--path", help="Only print where it is.")] = False,
) -> None:
    """Open the documentation: the site of this installation, or else its address."""
    from ...documentation import documentation, open_page

    place = documentation()
    tell(place)
    if not path and not open_page(place):
        tell("no browser could be opened here; open it yourself")
