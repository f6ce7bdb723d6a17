"""The commands that draw what is there already: a run, a sweep, several runs beside each other."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...errors import InputError, nearest
from .. import completion
from ..console import print_table, tell, wrote
from ..options import app

if TYPE_CHECKING:
    from ...results.pictures.comparison import Comparison

ENDINGS = (".png", ".svg", ".pdf", ".html")
DRAWN = "plot.png"  # in the folder of the results, where nothing else is said


@app.command()
def plot(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The results folder of a run or a sweep.")],
    signals: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SIGNAL]...",
            help="Names or patterns, motor.*; by default what is connected.",
            autocompletion=completion.drawn,
        ),
    ] = None,
    begin: Annotated[str, typer.Option("--from", metavar="TIME", help='From when: "2 s".')] = "",
    end: Annotated[str, typer.Option("--to", metavar="TIME", help='Until when: "3 s".')] = "",
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", metavar="FILE", help=f"A .png, .svg, .pdf or .html (can be zoomed); else {DRAWN} in DIR."
        ),
    ] = None,
) -> None:
    """Draw the signals of a run, complete or not, or the figures of merit of a sweep."""
    from ...clock import instant
    from ...files import write_file
    from ...results.opened import open_result
    from ...results.pictures.overview import choose, picture
    from ...results.pictures.page import require_plotly, signals_page
    from ...results.pictures.traces import traces
    from ...studies.sweep.picture import SWEEP, draw_sweep

    if not folder.exists():
        open_result(folder)  # which says so
    path = _target(folder, out)
    if (folder / SWEEP).is_file() and not (folder / "result.nc").is_file():
        if path.suffix == ".html" or begin or end:
            raise InputError(f"{folder} holds a sweep: it is drawn as .png, .svg or .pdf, without --from and --to")
        wrote([write_file(path, draw_sweep(folder, signals or ()).savefig)], path.parent)
        return
    if path.suffix == ".html":
        require_plotly()
    first, last = (float(instant(t, o)) if t else None for t, o in ((begin, "--from"), (end, "--to")))
    if first is not None and last is not None and last <= first:
        raise InputError(f"--to {end} is not after --from {begin}")
    found = traces(open_result(folder))
    choice = choose(found, signals or (), first, last, page=path.suffix == ".html")
    if path.suffix == ".html":
        page = signals_page(found, choice)
        write_file(path, lambda new: new.write_text(page, encoding="utf-8"))
    else:
        write_file(path, picture(found, choice).savefig)
    if found.failure:
        tell(f"the run ended early: {found.failure}")
    if choice.left_out:
        drawn, every = len(choice.rows), len(choice.rows) + len(choice.left_out)
        tell(f"drawn: the first {drawn} of {every} rows; what is in the others by name, such as {choice.others[0]}")
    wrote([path], path.parent)


@app.command()
def compare(
    folders: Annotated[list[Path], typer.Argument(metavar="DIR1 DIR2 [DIR]...", help="Results folders of runs.")],
    signals: Annotated[
        list[str],
        typer.Option(
            "--signal",
            metavar="SIGNAL",
            help="Names or patterns, motor.*; by default what is connected.",
            autocompletion=completion.drawn,
        ),
    ] = [],  # noqa: B006
    labels: Annotated[
        list[str], typer.Option("--label", metavar="TEXT", help="What a run is called: one for each, in their order.")
    ] = [],  # noqa: B006
    out: Annotated[Path, typer.Option("--out", help="Folder for compare.png and compare.html.")] = Path("comparison"),
) -> None:
    """Draw runs over each other, with their differences from the first and a table of figures of merit."""
    from ...files import prepare_folder, write_file
    from ...results.pictures.comparison import compare as compare_results
    from ...results.pictures.page import comparison_page, require_plotly

    found = compare_results(folders, signals, labels)
    prepare_folder(out)
    paths = [write_file(out / "compare.png", found.plot().savefig)]
    print_merits(found)
    try:
        require_plotly()
        page = comparison_page(found)
        paths.append(write_file(out / "compare.html", lambda new: new.write_text(page, encoding="utf-8")))
    except InputError as error:
        tell(f"no compare.html: {error}")
    if found.equal:
        tell(f"equal to the last bit: {', '.join(found.equal)}")
    if found.missing:
        tell(f"not in all of them: {', '.join(found.missing)}")
    wrote(paths, out)


def print_merits(found: Comparison) -> None:
    """Figures of merit of each run, and what the others differ by from the first."""
    from ...results.pictures.page import number, signed

    first, *others = found.labels
    cells = [
        (row["name"], row["unit"], *map(number, row["values"]), *map(signed, row["differences"]))
        for row in found.merits
    ]
    headings = ("", "unit", first, *others, *(f"{label}\nless {first}" for label in others))
    if cells:
        print_table("Figures of merit", headings, cells, words=(0, 1))


def _target(folder: Path, out: Path | None) -> Path:
    """The file to draw into. Raises InputError for another ending, no such folder, or a file that is a result."""
    from ...results.files.folder import files_of
    from ...results.files.writing import OVERVIEW

    path = out or folder / DRAWN
    if path.suffix not in ENDINGS:
        raise InputError(f"--out {path}: no {', '.join(ENDINGS)}{nearest(path.suffix, ENDINGS)}")
    if not path.parent.is_dir():
        raise InputError(f"--out {path}: there is no folder {path.parent}")
    if path.name != OVERVIEW and path.name in files_of(path.parent):
        raise InputError(f"--out {path} would overwrite a file of that run; give another name")
    return path
