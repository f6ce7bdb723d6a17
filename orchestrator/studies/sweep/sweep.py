"""Run a system over a design of parameter values, on all cores or a Dask cluster; gather its figures of merit."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...environment import environment
from ...errors import InputError, RunError, counted
from ...extras import needed
from ...files import prepare_folder
from .design.design import Design, make_design
from .options import Options
from .points import Points, header
from .request import Request, requested
from .table import Table, write_table
from .workers.point import Job
from .workers.workers import LocalWorkers, Workers, computed, cores

if TYPE_CHECKING:
    import xarray

ERRORS_SHOWN = 3


@dataclass(frozen=True)
class Cost:
    """What the points of one call took, all workers together."""

    points: int
    wall_s: float
    cpu_s: float
    memory_MB: float  # the largest of a worker

    @property
    def text(self) -> str:
        """In a line."""
        return (
            f"{counted(self.points, 'point')} in {self.wall_s:.1f} s: {self.points / self.wall_s:.2f} points/s, "
            f"{self.cpu_s / self.points:.3f} s of a core per point, {self.cpu_s / self.wall_s:.2f} cores busy on "
            f"average, at most {self.memory_MB:.0f} MB per worker"
        )


@dataclass(frozen=True)
class Swept:
    """All points of a sweep, the same as a dataset, and what it took to compute those that were missing."""

    table: Table
    dataset: xarray.Dataset
    folder: Path
    cost: Cost | None

    def require_all(self) -> xarray.Dataset:
        """The dataset. Raises RunError if a point failed."""
        failed = [(k, error) for k, error in enumerate(self.table.errors()) if error]
        if not failed:
            return self.dataset
        design = self.table.design
        lines = [f"point {k} ({_values(design.point(k))}): {error}" for k, error in failed[:ERRORS_SHOWN]]
        more = ["..."] if len(failed) > ERRORS_SHOWN else []
        head = f"{len(failed)} of {counted(len(design), 'point')} failed; see `error` in {self.folder}"
        raise RunError("\n  ".join([head, *lines, *more]))


def sweep(
    name: str,
    out: Path,
    options: Options,
    tell: Callable[[str], None] = lambda _line: None,
    progress: Callable[[int, int], None] = lambda _done, _of: None,
    check: Callable[[Request, Design], None] = lambda _request, _design: None,
) -> Swept:
    """Compute every point that `out` does not hold yet, and write sweep.nc and sweep.csv.

    `tell` hears what the user must know before, `progress` how many points are done, of how many; `check` looks at what
    is to be computed, and may raise InputError. The results do not depend on workers or interruptions. Raises
    InputError before anything is computed; RunError after an interruption (what was computed is written, and kept for
    the next time).
    """
    needed("xarray", "a sweep")
    request = requested(name, options)
    design = make_design(
        request.system, request.vary, request.count, request.seed, options.points,
        "" if options.blocks else options.design or request.study.design, options.blocks,
    )  # fmt: skip
    check(request, design)
    job, made_with = request.job_of(design.axes), environment()
    workers = make_workers(options, job, len(design))
    with workers:
        prepare_folder(out)
        request.tell_notes(tell)
        head = header(request.system, job.digest, design, request.units, made_with)
        points = Points(out, head, options.force)
        title = request.study.description or f"{request.study.name} over {', '.join(request.vary)}"
        table = Table(title, design, request.figures, points.records, points.made_with)
        if points.records:
            tell(f"{len(points.done())} of {counted(len(design), 'point')} are there already")
        try:
            cost = run_points(workers, job, design, points, progress)
        except BaseException as error:
            workers.stop()
            if isinstance(error, (KeyboardInterrupt, RunError)):
                with suppress(RunError):  # the disk may be what is full; the points are kept anyway
                    write_table(table, out)
                reason = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
                raise RunError(
                    f"{reason}\n{len(points.done())} of {counted(len(design), 'point')} are kept in {out}; "
                    "give the same command again to go on"
                ) from error
            raise
        finally:
            points.close()
    return Swept(table, write_table(table, out), out, cost)


def make_workers(options: Options, job: Job, points: int) -> Workers:
    """One process per core, or what the options say. Raises InputError for a scheduler that does not answer."""
    if options.scheduler and options.workers:
        raise InputError("--workers is for this machine; a Dask scheduler has the workers that were started for it")
    if options.scheduler:
        from .workers.dask import DaskWorkers

        return DaskWorkers(options.scheduler, job)
    return LocalWorkers(min(options.workers or cores(), points))


def run_points(
    workers: Workers, job: Job, design: Design, points: Points, progress: Callable[[int, int], None]
) -> Cost | None:
    """Compute and keep what is missing; what that cost."""
    done = points.done()
    tasks = design.points(k for k in range(len(design)) if k not in done)
    if not len(tasks):
        return None
    begin, cpu, memory = time.perf_counter(), 0.0, 0.0
    progress(len(done), len(design))
    for finished, (k, record) in enumerate(computed(workers, job, tasks), len(done) + 1):
        points.add(k, record)
        cpu, memory = cpu + record.get("cpu_s", 0.0), max(memory, record.get("memory_MB", 0.0))
        progress(finished, len(design))
    return Cost(len(tasks), time.perf_counter() - begin, cpu, memory)


def _values(values: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in values.items())
