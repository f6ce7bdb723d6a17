"""Run a system over a design of parameter values, on all cores or a Dask cluster; gather its figures of merit."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.markup import escape
from rich.table import Table as Printed

from ...cli.console import console, print_notes, progress
from ...errors import InputError, RunError
from ...files import prepare_folder
from ...results.summary import figure_units
from ...system.request import UNCHANGED, Changes
from .design import Design, make_design, vary_entries
from .file import sweep_file
from .point import Job, digest, load
from .points import Points, Table, header, write_table
from .workers import LocalWorkers, Workers, computed, cores

if TYPE_CHECKING:
    import xarray

SHOWN = 12  # points of a sweep along one axis that are printed as a table
ERRORS_SHOWN = 3


@dataclass(frozen=True)
class Options:
    """What the command line adds to, or says in place of, a sweep file."""

    vary: Sequence[str] = ()
    values: Mapping[str, object] = field(default_factory=dict)
    stop: str = ""
    random: int = 0
    seed: int | None = None
    points: Path | None = None
    workers: int = 0  # 0: one per core
    scheduler: str = ""
    fmus: Path | None = None
    changes: Changes = UNCHANGED


def sweep(name: str, out: Path, options: Options) -> xarray.Dataset:
    """Compute every point that `out` does not hold yet, write sweep.nc and sweep.csv, and return the dataset.

    The results do not depend on workers or interruptions. Raises InputError before anything is computed; RunError
    after an interruption or with failed points (what was computed is written, and kept for the next time).
    """
    study = sweep_file(name)
    values = {**study.values, **options.values}
    vary = {} if options.points else {**study.vary, **vary_entries(options.vary)}
    for twice in vary.keys() & options.values.keys():
        raise InputError(f"--set {twice}: it is varied; leave one of the two out")
    count = options.random or (0 if options.points else study.random)
    seed = study.seed if options.seed is None else options.seed
    job = Job(
        study.system, str(options.fmus.resolve()) if options.fmus else "",
        tuple((key, tuple(v) if isinstance(v, list) else v) for key, v in values.items() if key not in vary),
        tuple(study.summary.items()), options.stop or study.stop, changes=options.changes,
    )  # fmt: skip
    system = load(job).system
    if not vary and options.vary:
        raise InputError("--points lists every point; leave --vary and --random out")
    design = make_design(system, vary, count, seed, options.points)
    units = figure_units(system)
    if not units:
        raise InputError(f"{study.name}: the system has no [summary], so that there is nothing to gather")
    job = replace(job, digest=digest(system))
    workers = make_workers(options, job, len(design))
    with workers:
        prepare_folder(out)
        print_notes(system)
        points = Points(out, header(system.name, job.digest, float(system.stop), design, units))
        texts = {**{key: str(text) for key, text in system.reporting["summary"].items()}}
        figures = {key: (unit, texts.get(key, key.replace("_", " "))) for key, unit in units.items()}
        table = Table(study.description or f"{study.name} over {', '.join(vary)}", design, figures, points.records)
        try:
            run_points(study.name, workers, job, design, points)
        except BaseException as error:
            workers.stop()
            if isinstance(error, (KeyboardInterrupt, RunError)):
                with suppress(RunError):  # the disk may be what is full; the points are kept anyway
                    write_table(table, out)
                reason = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
                raise RunError(
                    f"{reason}\n{len(points.done())} of {len(design)} points are kept in {out}; "
                    "give the same command again to go on"
                ) from error
            raise
        finally:
            points.close()
    result = write_table(table, out)
    show(table)
    console.print(f"wrote points.jsonl, sweep.nc, sweep.csv to {out}")
    failed = [(k, error) for k, error in enumerate(table.errors()) if error]
    if failed:
        lines = [f"point {k} ({_values(design.point(k))}): {error}" for k, error in failed[:ERRORS_SHOWN]]
        more = ["..."] if len(failed) > ERRORS_SHOWN else []
        raise RunError(
            "\n  ".join([f"{len(failed)} of {len(design)} points failed; see `error` in {out}", *lines, *more])
        )
    return result


def make_workers(options: Options, job: Job, points: int) -> Workers:
    """One process per core, or what the options say. Raises InputError for a scheduler that does not answer."""
    if options.scheduler and options.workers:
        raise InputError("--workers is for this machine; a Dask scheduler has the workers that were started for it")
    if options.scheduler:
        from .dask_workers import DaskWorkers

        return DaskWorkers(options.scheduler, job)
    return LocalWorkers(min(options.workers or cores(), points))


def run_points(name: str, workers: Workers, job: Job, design: Design, points: Points) -> None:
    """Compute and keep what is missing; say how it goes, and at the end what it cost."""
    done = points.done()
    tasks = [(k, design.point(k)) for k in range(len(design)) if k not in done]
    if done:
        console.print(f"{len(done)} of {len(design)} points are there already")
    if not tasks:
        return
    begin, cpu, memory = time.perf_counter(), 0.0, 0.0
    with progress(len(design), f"sweep {name}", "points", len(done)) as report:
        for finished, (k, record) in enumerate(computed(workers, job, tasks), len(done) + 1):
            points.add(k, record)
            cpu, memory = cpu + record.get("cpu_s", 0.0), max(memory, record.get("memory_MB", 0.0))
            report(finished)
    elapsed = time.perf_counter() - begin
    console.print(
        f"{len(tasks)} points in {elapsed:.1f} s: {len(tasks) / elapsed:.2f} points/s, {cpu / len(tasks):.3f} s of a "
        f"core per point, {cpu / elapsed:.2f} cores busy on average, at most {memory:.0f} MB per worker"
    )


def show(table: Table) -> None:
    """A sweep along one axis: each figure of merit at the first point, and its change from there at the others."""
    design = table.design
    if len(design.axes) != 1 or len(design) > SHOWN:
        return
    axis = design.axes[0]
    printed = Printed(title=f"{table.title}: the first point, and the change from it", title_justify="left")
    printed.add_column(escape(f"{axis.name} [{axis.unit}]"), no_wrap=True)
    for value in axis.values:
        printed.add_column(f"{value:g}" if isinstance(value, float) else str(value), justify="right")
    for name, (unit, _) in table.figures.items():
        first, *others = table.column(name).tolist()
        changes = (f"{100 * (value / first - 1):+.3g} %" if first and value == value else "-" for value in others)
        printed.add_row(escape(f"{name} [{unit}]"), f"{first:.5g}", *changes)
    console.print(printed)


def _values(values: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in values.items())
