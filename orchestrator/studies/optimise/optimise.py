"""An optimisation: what is asked for, checked; the search; what it leaves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...environment import environment
from ...errors import InputError, RunError, counted
from ...files import prepare_folder
from ..sweep.design.axis import Axis, Range, checked_axis
from ..sweep.design.sampling import choices
from ..sweep.merits import require_known, written_out
from ..sweep.options import Options
from ..sweep.points import CONTENT, MADE_WITH, Points
from ..sweep.request import Request, requested
from ..sweep.sweep import make_workers
from .constraint import constraint_of, figure_of
from .search import evolve, polish
from .trials import Aim, Trial, Trials
from .written import write_found

POPULATION = 8  # points of a generation for each parameter


@dataclass(frozen=True)
class Optimum:
    """The best point found, and every one that was tried, in order."""

    request: Request
    aim: Aim
    axes: tuple[Axis, ...]
    spaces: dict[str, object]
    best: Trial
    trials: tuple[Trial, ...]
    base: str = ""  # the parameter set that was asked for; the system's own, if none
    paths: tuple[Path, ...] = ()

    @property
    def values(self) -> dict[str, object]:
        return {axis.name: value for axis, value in zip(self.axes, self.best.values, strict=True)}

    def at_end(self) -> dict[str, str]:
        """The parameters that are at an end of their range, and which."""
        ends = {}
        for axis, value in zip(self.axes, self.best.values, strict=True):
            space = self.spaces[axis.name]
            if isinstance(space, Range):
                near = 1e-3 * (space.high - space.low)
                for end, name in ((space.low, "lower"), (space.high, "upper")):
                    if abs(float(value) - end) <= near:
                        ends[axis.name] = name
        return ends


def optimise(
    name: str,
    out: Path,
    options: Options,
    minimise: str = "",
    maximise: str = "",
    subject_to: Sequence[str] = (),
    generations: int = 20,
    population: int = 0,
    polishing: int | None = None,
    tell: Callable[[str], None] = lambda _line: None,
    progress: Callable[[int, int], None] = lambda _done, _of: None,
) -> Optimum:
    """The point in the ranges of `options.vary` at which a figure is least, or greatest, and every constraint holds.

    Differential evolution of `population` points (POPULATION for each parameter, if 0) over `generations`, then at most
    `polishing` runs of a local search (10 for each parameter). The same seed gives the same points, whatever the number
    of workers; what `out` holds already is not computed again. Raises InputError before anything is computed; RunError
    after an interruption, and where no point satisfies all constraints.
    """
    if bool(minimise) == bool(maximise):
        raise InputError("give one of --minimise and --maximise, and what else matters as --subject-to")
    if options.points or options.random or options.design:
        raise InputError("an optimisation chooses its points; leave --points, --random and --design out")
    figure = minimise or maximise
    figures = [figure, *map(figure_of, subject_to)]
    request = requested(name, replace(options, figures={**options.figures, **written_out(figures)}))
    require_known([figure], request.units, "--minimise" if minimise else "--maximise")
    aim = Aim(figure, 1 if minimise else -1, tuple(constraint_of(text, request) for text in subject_to))
    if not request.vary:
        raise InputError("nothing to vary; give --vary, for instance --vary motor.R=0.05:0.2")
    named = {request.system.full_name(key): text for key, text in request.vary.items()}
    if len(named) < len(request.vary):
        raise InputError(f"--vary: a parameter is varied twice ({', '.join(request.vary)})")
    spaces = {key: choices(request.system, key, text) for key, text in named.items()}
    axes = tuple(
        checked_axis(request.system, key, [s.low, s.high] if isinstance(s, Range) else s.items)
        for key, s in spaces.items()
    )
    job = request.job_of(axes)
    size = population or max(POPULATION * len(axes), 8)
    if size < 5:
        raise InputError(f"--population {size}: differential evolution needs 5 points at least")
    local = 10 * len(axes) if polishing is None else polishing
    most = size * (generations + 1) + local
    workers = make_workers(options, job, size)
    with workers:
        prepare_folder(out)
        request.tell_notes(tell)
        tell(
            f"at most {counted(most, 'run')}: {generations + 1} generations of {size} for "
            f"{counted(len(axes), 'parameter')}, and {local} of a local search"
        )
        head = _head(request, job.digest, aim, named, size)
        points = Points(out, head, options.force)
        trials = Trials(job, workers, points, spaces, aim, lambda done: progress(min(done, most), most))
        if trials.kept:
            tell(f"{counted(len(trials.kept), 'point')} are there already")
        try:
            evolve(trials, size, generations, request.seed)
            if trials.best().violation == 0.0:
                polish(trials, local)
        except BaseException as error:
            workers.stop()
            if isinstance(error, (KeyboardInterrupt, RunError)):
                reason = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
                raise RunError(
                    f"{reason}\n{counted(len(points.done()), 'point')} are kept in {out}; give the same command again "
                    "to go on"
                ) from error
            raise
        finally:
            points.close()
    found = Optimum(request, aim, axes, dict(spaces), trials.best(), tuple(trials.all), job.changes.parameters)
    return replace(found, paths=write_found(found, out))


def require_feasible(found: Optimum) -> None:
    """Raise RunError where no point satisfies all constraints, with the one that comes nearest."""
    best, units = found.best, found.request.units
    if best.error:
        raise RunError(f"every run failed; the first: {best.error}")
    if best.violation > 0.0:
        at = ", ".join(f"{axis.name} = {axis.label(v)}" for axis, v in zip(found.axes, best.values, strict=True))
        broken = [
            f"{c.text(units[c.figure])} is broken by {100 * e:.3g} % ({c.figure} = {best.figures[c.figure]:.6g})"
            for c, e in zip(found.aim.constraints, best.excesses, strict=True) if e > 0.0
        ]  # fmt: skip
        raise RunError(
            f"none of {counted(len(found.trials), 'point')} satisfies all constraints; the nearest one ({at}): "
            f"{'; '.join(broken)}. Widen a range of --vary, or a bound of --subject-to"
        )


def _head(request: Request, digest: str, aim: Aim, named: dict[str, object], size: int) -> dict[str, object]:
    """The first line of points.jsonl: whatever decides which points are tried, and what they give."""
    return {
        "system": request.system.name, "stop_s": float(request.system.stop), "design": "differential evolution",
        "seed": request.seed, "population": size, "objective": f"{'min' if aim.sign > 0 else 'max'} {aim.figure}",
        "subject to": [c.text(request.units[c.figure]) for c in aim.constraints],
        **{f"vary {name}": str(text) for name, text in named.items()},
        "figures of merit": request.units, CONTENT: digest, MADE_WITH: environment(),
    }  # fmt: skip
