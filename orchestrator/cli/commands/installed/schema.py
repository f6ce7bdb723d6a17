"""The command that tells editors and people which keys the files have."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ...options import app


@app.command()
def schema(
    kind: Annotated[
        str, typer.Argument(metavar="KIND", help="Of which file: system, mapping, sweep, fit, parameter or unit.")
    ] = "system",
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write it there.")] = None,
    reference: Annotated[
        bool, typer.Option("--reference", help="Every key of all of them, with type and default, as Markdown.")
    ] = False,
) -> None:
    """Print the JSON schema of a kind of file, for editors, or the reference of all keys."""
    from ....files import prepare_folder, write_file
    from ....plan.algorithms.registry import algorithm_names, settings_tables
    from ....system.schema import pages

    algorithms = pages.Algorithms(algorithm_names(), settings_tables())
    text = pages.reference(algorithms) if reference else pages.schema_text(kind, algorithms)
    if out is None:
        print(text, end="")
        return
    prepare_folder(out.absolute().parent)
    print(f"wrote {write_file(out, lambda path: path.write_text(text, encoding='utf-8'))}")
