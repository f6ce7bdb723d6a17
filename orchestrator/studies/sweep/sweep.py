"""Run a system over a design of parameter values, on all cores or a Dask cluster; gather its figures of merit."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...environment import environment, versions
from ...errors import InputError, RunError, counted
from ...files import prepare_folder
from ...results.figures_of_merit import figure_units
from ...system.model import System
from ...system.request import UNCHANGED, Changes
from .design import Design, check_count, make_design, vary_entries
from .file import SweepFile, sweep_file
from .point import Job, digest, job_system, load, planned
from .points import Points, header
from .replanned import is_structural
from .table import Table, write_table
from .workers import LocalWorkers, Workers, computed, cores

if TYPE_CHECKING:
    import xarray

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
    design: str = ""  # of --random: see `design.SAMPLERS`
    force: bool = False  # go on although another version or processor computed what is there
    start: str = ""


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
) -> Swept:
    """Compute every point that `out` does not hold yet, and write sweep.nc and sweep.csv.

    `tell` hears what the user must know before, `progress` how many points are done, of how many. The results do not
    depend on workers or interruptions. Raises InputError before anything is computed; RunError after an interruption
    (what was computed is written, and kept for the next time).
    """
    study = sweep_file(name)
    values = {**study.values, **options.values}
    vary = {} if options.points else {**study.vary, **vary_entries(options.vary)}
    if options.points and options.vary:
        raise InputError("--points lists every point; leave --vary and --random out")
    count = options.random or (0 if options.points else study.random)
    check_count(count, f"--random {count}" if options.random else f"{study.name}: random = {count}")
    changes = options.changes if options.changes.parameters else replace(options.changes, parameters=study.parameters)
    job = Job(
        study.system, str(options.fmus.resolve()) if options.fmus else "",
        tuple((key, tuple(v) if isinstance(v, list) else v) for key, v in values.items() if key not in vary),
        tuple(study.summary.items()), options.stop or study.stop, changes=changes,
        start=options.start or study.start,
    )  # fmt: skip
    system = job_system(job)
    require_figures(system, study)
    seed = study.seed if options.seed is None else options.seed
    design = make_design(system, vary, count, seed, options.points, options.design or study.design)
    for twice in {axis.name for axis in design.axes} & set(map(system.full_name, options.values)):
        raise InputError(f"--set {twice}: it is varied; leave one of the two out")
    load(job)  # its plan, and its figures of merit
    for axis in design.axes:
        if is_structural(system, axis.name):
            for value in sorted(set(axis.values), key=float):
                planned(job, ((axis.name, value),))
    units = figure_units(system)
    made_with = environment()
    job = replace(job, digest=digest(system), versions=tuple(versions().items()))
    workers = make_workers(options, job, len(design))
    with workers:
        prepare_folder(out)
        for component in system.components.values():
            for note in component.notes:
                tell(note)
        head = header(system, job.digest, design, units, made_with)
        points = Points(out, head, options.force)
        texts = {key: str(text) for key, text in system.reporting["summary"].items()}
        figures = {key: (unit, texts.get(key, key.replace("_", " "))) for key, unit in units.items()}
        title = study.description or f"{study.name} over {', '.join(vary)}"
        table = Table(title, design, figures, points.records, points.made_with)
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


def require_figures(system: System, study: SweepFile) -> None:
    """Raise InputError, with the lines to write, where there is nothing to gather."""
    reporting = system.reporting
    if system.bonds or reporting["balance"] or reporting["summary"].keys() - {"window"}:
        return
    found = [(name, c.fmu.names("output")) for name, c in system.components.items()]
    output = next((f"{name}.{outputs[0]}" for name, outputs in found if outputs), "component.output")
    raise InputError(
        f"{study.name}: the system has no [summary], so that there is nothing to gather; write, for instance, into "
        f'{system.path.name} (or into a sweep file):\n[summary]\n{output.replace(".", "_")}_mean = "mean {output}"'
    )


def make_workers(options: Options, job: Job, points: int) -> Workers:
    """One process per core, or what the options say. Raises InputError for a scheduler that does not answer."""
    if options.scheduler and options.workers:
        raise InputError("--workers is for this machine; a Dask scheduler has the workers that were started for it")
    if options.scheduler:
        from .dask_workers import DaskWorkers

        return DaskWorkers(options.scheduler, job)
    return LocalWorkers(min(options.workers or cores(), points))


def run_points(
    workers: Workers, job: Job, design: Design, points: Points, progress: Callable[[int, int], None]
) -> Cost | None:
    """Compute and keep what is missing; what that cost."""
    done = points.done()
    tasks = [(k, design.point(k)) for k in range(len(design)) if k not in done]
    if not tasks:
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
