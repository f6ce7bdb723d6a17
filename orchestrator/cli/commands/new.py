"""The commands that write something to begin with: a system, or a component."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated, Any

import typer

from ...errors import FmuError, InputError
from ..console import tell
from ..options import app
from .built import raise_ours


@app.command("new-component")
def new_component(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Its name: letters, digits and _, as `leaky_tank`.")],
    folder: Annotated[Path, typer.Option("--folder", metavar="DIR", help="Where its folder is made.")] = Path(),
) -> None:
    """Write a small component that works: equations, interface, tests, README; and say what comes next."""
    _write("rovbrush.new_components", lambda write: write(name, folder))


@app.command("new")
def new_system(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Its name: letters, digits and _, as `my_plant`.")],
    folder: Annotated[Path, typer.Option("--folder", metavar="DIR", help="Where its folder is made.")] = Path(),
) -> None:
    """Write a small system that works: an FMU of your own with its source, one of ours, a test; say what comes next."""
    from ...system.file.reader import load_system
    from ...system.file.shipped import shipped_systems
    from ..editors import editor_files

    if name in shipped_systems():
        raise InputError(f"there is a shipped system {name} already; `rovbrush systems --copy {name}` copies it")
    made = _write("rovbrush.new_systems", lambda write: write(name, folder, editor_files(name)))
    try:
        load_system(str(made / f"{name}.toml"))
    except FmuError as error:  # of ours, which are not built here yet
        tell(f"before it runs: {error}")


def _write(group: str, write: Callable[[Any], tuple[Path, list[tuple[str, str]]]]) -> Path:
    """Let whoever writes such things do so, and print the files and what comes next; the folder."""
    found = list(entry_points(group=group))
    if not found:
        raise InputError("nothing is installed that writes such a thing; install the whole rovbrush package")
    try:
        made, steps = write(found[0].load())
    except Exception as error:
        raise_ours(error)
    tell(f"wrote {made}: {', '.join(sorted(path.name for path in made.iterdir()))}")
    width = max(len(command) for command, _ in steps)
    for command, words in steps:
        tell(f"  {command:<{width}}  {words}" if command else f"  {words}")
    return made
