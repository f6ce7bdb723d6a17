"""What a run leaves on disk: its rows first, and then, each by itself, what is made of them.

Every file is written under a temporary name and renamed when complete. A product that cannot be made costs a message,
never the rows or another product.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...errors import RovbrushError, RunError
from ...files import reason, write_file, write_json
from ...plan.explain import explain
from ..summary.figures_of_merit import figure_units
from ..summary.summary import comparison, summarize
from ..tables import Run
from .csv import write_csv
from .manifest import manifest
from .netcdf import write_netcdf

ROWS, TABLE, SUMMARY, MANIFEST, PLAN = "result.nc", "result.csv", "summary.json", "manifest.json", "plan.txt"
UNITS = "units"  # of the figures of merit, in summary.json
OVERVIEW = "overview.png"  # the picture that every run has whose rows are in memory
MESSAGES = "messages.log"  # what FMUs logged
RESERVED = frozenset(  # what a run, a sweep or a picture asked for later is written to
    (ROWS, TABLE, SUMMARY, MANIFEST, PLAN, OVERVIEW, MESSAGES, "plot.png", "plot.svg", "plot.pdf", "sweep.nc",
     "sweep.csv", "sweep.png", "sweep_tornado.png", "points.jsonl")
)  # fmt: skip
COMPARED = ("label", "unit", "reference", "value", "ratio", "within")  # of a comparison, in summary.json

More = tuple[Sequence[str], Callable[[Run, Path], list[Path]]]  # further files by name, and what writes them


@dataclass
class Written:
    """What was written, and what could not be. `elsewhere` says where the rows are if the folder did not take them."""

    folder: Path
    paths: list[Path] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    elsewhere: str = ""
    summary: dict[str, Any] = field(default_factory=dict)
    comparison: list[dict[str, Any]] = field(default_factory=list)

    def attempt(self, what: str, make: Callable[[], list[Path]]) -> None:
        """Make a product. Its failure is kept as a message."""
        try:
            self.paths += make()
        except RovbrushError as error:
            self.failures.append(str(error))
        except Exception as error:  # a fault of ours must not cost the other products
            self.failures.append(f"{what} could not be made: unexpected {type(error).__name__}: {error}")


def write_rows(run: Run, folder: Path) -> Written:
    """Write result.nc and close it. Raises RunError only if no disk takes the rows.

    A folder that has gone is made anew; a disk that refuses is replaced by a temporary folder.
    """
    refused: list[str] = []
    for place in _places(folder):
        try:
            gone = not folder.is_dir()
            chosen = place()
            return Written(chosen, [_rows(run, chosen / ROWS)], elsewhere=_said(folder, chosen, gone, refused))
        except Exception as error:  # whatever the libraries below raise: the next place may take them
            refused.append(str(error) if isinstance(error, RovbrushError) else f"{folder / ROWS}: {reason(error)}")
    if not isinstance(run.recorded, list):
        with suppress(Exception):
            run.recorded.finish(folder / ROWS, False, partly=True)
            lost = "; the last rows found no room, result.nc ends before them"
            return Written(folder, [folder / ROWS], elsewhere="; ".join(refused[:1]) + lost)
    raise RunError(f"the rows could not be written: {'; '.join(dict.fromkeys(refused))}")


def _places(folder: Path) -> Iterator[Callable[[], Path]]:
    """The folder, made anew if need be, and where else there may be room."""

    def own() -> Path:
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    yield own
    for parent in (None, "/var/tmp", "/dev/shm"):
        if parent is None or Path(parent).is_dir():
            yield lambda parent=parent: Path(tempfile.mkdtemp(prefix="rovbrush-", dir=parent))  # type: ignore[misc]


def _rows(run: Run, path: Path) -> Path:
    try:
        if isinstance(run.recorded, list):
            return write_file(path, lambda temporary: write_netcdf(run, temporary))
        run.recorded.finish(path, not run.failure, run=run)
    except BaseException:
        with suppress(OSError):
            if path.parent.name.startswith("rovbrush-"):
                path.parent.rmdir()
        raise
    return path


def _said(folder: Path, chosen: Path, gone: bool, refused: list[str]) -> str:
    if chosen != folder:
        return f"{refused[0]}; the results went to {chosen}"
    return f"the folder {folder} had gone and was made anew" if gone else ""


def write_products(
    run: Run, written: Written, more: Sequence[More] = (), summary: Mapping[str, Any] | None = None
) -> None:
    """Make everything but the rows, each product apart; `more`: further ones. `summary`: one that is there already.

    Of what was recorded to a file there is no result.csv and no overview.png. Ctrl-C leaves out what is not made yet.
    """
    folder = written.folder
    figures = run.plan.system.reporting["figures"]
    in_memory = isinstance(run.recorded, list)
    table, picture = [TABLE] * in_memory, [OVERVIEW] * (in_memory and any(g.columns for g in run.plan.groups))
    said = [MESSAGES] * bool(run.messages)
    files = [ROWS, *said, MANIFEST, PLAN, *table, SUMMARY, *picture, *_names(figures)]
    files += [name for names, _ in more for name in names]

    def summed() -> list[Path]:
        written.summary = summarize(run) if summary is None else dict(summary)
        return []

    def compared() -> list[Path]:
        if summary is None:
            written.comparison = comparison(run, written.summary)
            rows = [{key: row[key] for key in COMPARED} for row in written.comparison]
            written.summary["comparison"] = rows
        return []

    def file(name: str, write: Callable[[Path], Any]) -> Callable[[], list[Path]]:
        return lambda: [write_file(folder / name, write)]

    try:
        if said:
            written.attempt(MESSAGES, file(MESSAGES, lambda path: write_messages(run.messages, path)))
        else:
            with suppress(OSError):
                (folder / MESSAGES).unlink(missing_ok=True)  # those of an earlier run
        written.attempt(MANIFEST, file(MANIFEST, lambda path: write_json(path, manifest(run, files))))
        written.attempt(PLAN, file(PLAN, lambda path: path.write_text(explain(run.plan) + "\n", encoding="utf-8")))
        if table:
            written.attempt(TABLE, file(TABLE, lambda path: write_csv(run, path)))
        else:
            (folder / TABLE).unlink(missing_ok=True)  # that of an earlier run
        written.attempt(SUMMARY, summed)
        if written.summary or summary is not None:
            written.attempt("the comparison", compared)
            told = {**written.summary, UNITS: figure_units(run.plan.system)}
            written.attempt(SUMMARY, file(SUMMARY, lambda path: write_json(path, told)))
        if picture:
            written.attempt(OVERVIEW, lambda: _overview(run, folder))
        else:
            (folder / OVERVIEW).unlink(missing_ok=True)  # that of an earlier run
        for entry in figures:
            if "table" in entry:
                written.attempt(str(entry["table"]), lambda entry=entry: _profiles(run, entry, folder))  # type: ignore[misc]
            written.attempt(str(entry["file"]), lambda entry=entry: _figure(run, entry, folder))  # type: ignore[misc]
        for names, make in more:
            written.attempt(", ".join(names), lambda make=make: make(run, folder))  # type: ignore[misc]
    except KeyboardInterrupt:
        missing = [name for name in files if not any(path.name == name for path in written.paths)]
        written.failures.append(f"interrupted; not written: {', '.join(missing)}")


def write_messages(messages: Sequence[str], path: Path) -> None:
    """What FMUs logged, one message a line."""
    path.write_text("".join(f"{message}\n" for message in messages), encoding="utf-8")


def _names(figures: Sequence[Mapping[str, Any]]) -> list[str]:
    """The files of figures, the tables of those that have one before them."""
    return [str(entry[key]) for entry in figures for key in ("table", "file") if key in entry]


def _profiles(run: Run, entry: Mapping[str, Any], folder: Path) -> list[Path]:
    from ..profiles import profiles, write_profiles

    if profiles(run, entry) is None:
        return []
    return [write_file(folder / str(entry["table"]), lambda path: write_profiles(run, entry, path))]


def _overview(run: Run, folder: Path) -> list[Path]:
    from ..pictures.overview import overview
    from ..pictures.traces import run_traces

    found = run_traces(run)
    return [write_file(folder / OVERVIEW, overview(found).savefig)] if found.usual() else []


def _figure(run: Run, entry: Mapping[str, Any], folder: Path) -> list[Path]:
    from ..pictures.figures import figure

    drawn = figure(run, entry)
    return [write_file(folder / str(entry["file"]), drawn.savefig)] if drawn else []


def write_results(run: Run, folder: Path, summary: Mapping[str, Any]) -> list[Path]:
    """Write everything, with a summary that is there already; the paths in the order of writing.

    Raises RunError that names every product that could not be made; the others are there.
    """
    with suppress(OSError):  # `write_rows` finds another place where this is impossible
        folder.mkdir(parents=True, exist_ok=True)
    written = write_rows(run, folder)
    write_products(run, written, summary=summary)
    if written.elsewhere or written.failures:
        found = ", ".join(path.name for path in written.paths)
        raise RunError("\n".join([written.elsewhere, *written.failures, f"{found} are in {written.folder}"]).strip())
    return written.paths
