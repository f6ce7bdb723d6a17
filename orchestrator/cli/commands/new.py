"""The command that writes a component to begin with."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated

import typer

from ...errors import InputError
from ..console import tell
from ..options import app
from .built import raise_ours


@app.command("new-component")
def new_component(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Its name: letters, digits and _, as `leaky_tank`.")],
    folder: Annotated[Path, typer.Option("--folder", metavar="DIR", help="Where its folder is made.")] = Path(),
) -> None:
    """Write a small component that works: equations, interface, tests, README; and say what comes next."""
    found = list(entry_points(group="rovbrush.new_components"))
    if not found:
        raise InputError("nothing is installed that writes components; install the whole rovbrush package")
    for writer in found:
        try:
            made, steps = writer.load()(name, folder)
        except Exception as error:
            raise_ours(error)
        tell(f"wrote {made}: {', '.join(sorted(path.name for path in made.iterdir() if path.is_file()))}")
        width = max(len(command) for command, _ in steps)
        for command, words in steps:
            tell(f"  {command:<{width}}  {words}" if command else f"  {words}")
