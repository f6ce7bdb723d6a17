"""A study over parameters as it is asked for: the system, what is varied, what its workers need to know."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from ...environment import versions
from ...errors import InputError
from ...results.summary.figures_of_merit import figure_units
from ...system.model import System
from .design.axis import Axis
from .design.design import check_count, vary_entries
from .design.replanned import is_structural
from .file import SweepFile, sweep_file
from .options import Options
from .workers.point import Job, digest, job_system, load, planned


@dataclass(frozen=True)
class Request:
    """What a file and the options ask for, together."""

    study: SweepFile
    system: System
    job: Job
    vary: Mapping[str, object]
    count: int
    seed: int
    options: Options

    @property
    def units(self) -> dict[str, str]:
        """The figures of merit with their units."""
        return figure_units(self.system)

    @property
    def figures(self) -> dict[str, tuple[str, str]]:
        """Unit and definition of each figure of merit."""
        texts = {key: str(text) for key, text in self.system.reporting["summary"].items()}
        return {key: (unit, texts.get(key, key.replace("_", " "))) for key, unit in self.units.items()}

    def job_of(self, axes: Sequence[Axis]) -> Job:
        """The job of workers that vary `axes`, each value of which can be planned. Raises InputError, FmuError."""
        for twice in {axis.name for axis in axes} & set(map(self.system.full_name, self.options.values)):
            raise InputError(f"--set {twice}: it is varied; leave one of the two out")
        load(self.job)  # its plan, and its figures of merit
        for axis in axes:
            if is_structural(self.system, axis.name):
                for value in sorted(set(axis.values), key=float):
                    planned(self.job, ((axis.name, value),))
        return replace(self.job, digest=digest(self.system), versions=tuple(versions().items()))

    def tell_notes(self, tell: Callable[[str], None]) -> None:
        """What the user must know of replaced components."""
        for component in self.system.components.values():
            for note in component.notes:
                tell(note)


def requested(name: str, options: Options) -> Request:
    """What a sweep file, or a system, and the options ask for. Raises InputError, FmuError."""
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
        tuple({**study.summary, **options.figures}.items()), options.stop or study.stop, changes=changes,
        start=options.start or study.start,
    )  # fmt: skip
    system = job_system(job)
    require_figures(system, study)
    if options.figures:
        load(job)  # their signals, which somebody has just typed
    seed = study.seed if options.seed is None else options.seed
    return Request(study, system, job, vary, count, seed, options)


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
