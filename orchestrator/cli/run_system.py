"""`rovbrush run`: from what was asked for to a planned run, and what a person is told of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from pathlib import Path

from ..errors import InputError, RunError
from ..exchange.recordings.write import boundary_files, write_boundary
from ..loop.machine.compiled import is_compiled, require_loop
from ..observers.watched import NOBODY, Watching, watched
from ..participant.opening import require_compiler
from ..plan.explain import last_steps
from ..plan.plan import Plan
from ..results.files.csv import rate_files, rate_names
from ..results.files.netcdf import group_name
from ..results.files.writing import ROWS, More
from ..results.summary.energy import require_energy
from ..results.summary.figures_of_merit import figure_units
from ..run.carry_out import Finished, carry_out, checkpoint_ticks, claim
from ..run.checkpoint.checkpoint import Checkpoint, read_checkpoint
from ..run.checkpoint.fingerprint import require_unchanged
from ..run.pacing.asked import pace_of
from ..run.planned import planned
from ..run.recording.recorder import IN_MEMORY
from ..system.assemble import assemble_request, strictly
from ..system.request import Request
from .console import print_comparison, print_notes, print_summary, print_transfers, tell, wrote
from .progress import progress


def run_system(
    request: Request, out: Path, check: bool, force: bool = False, strict: bool = False, watching: Watching = NOBODY
) -> None:
    """Run, write and print. Raises RunError after an early end (what was computed is written) or a failed check.

    `strict`: only if all FMUs keep to the standard, else FmuError. `watching`: who looks on.
    """
    system = assemble_request(request)
    pace = pace_of(request)
    plan = planned(strictly(system) if strict else system, request.record_boundary, pace.every if pace else None)
    checkpoint_ticks(plan, request.checkpoint)
    watching.check(plan)
    require_loop()
    for component in plan.system.components.values():
        require_compiler(component.fmu, component.name)
    folder, older = claim(out, plan.system.name, force)
    if plan.system.parameter_set:
        tell(f"parameters: {plan.system.parameter_set}")
    print_notes(plan.system)
    for note in last_steps(plan):
        tell(note)
    print_transfers(plan, request)
    _run(plan, request, folder, check, older, watching=watching)


def resume_system(folder: Path, asked: Request, check: bool, force: bool = False, watching: Watching = NOBODY) -> None:
    """Go on from the checkpoint in a results folder, and write the results there. Errors as of `run_system`.

    Of `asked` only `fmus` and `checkpoint` may be given; they replace what was asked for then.
    """
    taken = [f.name for f in fields(asked) if getattr(asked, f.name) and f.name not in ("fmus", "checkpoint")]
    if taken:
        names = ", ".join(name.rstrip("_").replace("_", "-") for name in taken)
        raise InputError(f"--resume takes {names} from the checkpoint; leave it out")
    checkpoint = read_checkpoint(folder)
    try:
        request = Request.of(checkpoint.request or {})
    except ValueError:
        raise InputError(f"{checkpoint.folder} was not written by `rovbrush run`; go on as it was begun") from None
    request = replace(request, fmus=asked.fmus or request.fmus, checkpoint=asked.checkpoint or request.checkpoint)
    pace = pace_of(request)
    plan = planned(assemble_request(request), request.record_boundary, pace.every if pace else None)
    require_unchanged(checkpoint.unchanged, plan, force)
    checkpoint_ticks(plan, request.checkpoint)
    watching.check(plan)
    out, older = claim(folder, plan.system.name, force, "--resume")
    tell(f"going on from t = {checkpoint.at.time:.9g} s")
    begin = replace(checkpoint, folder=out / checkpoint.folder.name)
    _run(plan, request, out, check, older, begin, force, watching)


def _run(
    plan: Plan, request: Request, out: Path, check: bool, older: Sequence[str], begin: Checkpoint | None = None,
    force: bool = False, watching: Watching = NOBODY,
) -> None:  # fmt: skip
    tell(f"loading the FMUs{_first(plan)}")
    more = [_boundary(plan, component) for component in request.record_boundary]
    if request.csv:
        more.append((rate_names(plan), rate_files))
    origin = float(plan.system.start)
    reached = begin.at.time - origin if begin else 0.0
    with progress(float(plan.system.stop) - origin, f"running {plan.system.name}", begin=reached) as bar:

        def report(time: float) -> None:
            bar(time - origin)

        finished = carry_out(
            plan, out, request, older, begin, force, report, more, pace_of(request),
            watched=lambda session: watched(session, watching, tell),
        )  # fmt: skip
    show(finished)
    require_good(finished, check)


def _first(plan: Plan) -> str:
    """What the first run of all has to do that others need not, and how long that takes."""
    missing = [] if is_compiled() else ["the loop"]
    if plan.exchange:
        from ..integration.compiled import is_compiled as solver_is_compiled

        missing += [] if solver_is_compiled() else ["the solver of model exchange"]
    return f"; the first run compiles {' and '.join(missing)}, half a minute each at most" if missing else ""


def _boundary(plan: Plan, component: str) -> More:
    return boundary_files(component), lambda run, folder: write_boundary(run, component, folder)


def show(finished: Finished) -> None:
    """Print what a run left."""
    run, written = finished.run, finished.written
    print_comparison(written.comparison, written.summary.get("steady", True))
    print_summary(written.summary, figure_units(run.plan.system))
    wrote(written.paths, written.folder)
    if run.ended:
        tell(f"ended: {run.ended}")
    for line in run.lateness.words() if run.lateness else ():
        tell(line)
    for note in run.notes:
        tell(note if note.startswith("warning: ") else f"note: {note}")
    for line in written.summary.get("left_range", ()):
        tell(f"warning: {line}")
    groups = [group_name(run.plan, g) for g in range(len(run.plan.groups))]
    if groups and any(path.name == ROWS for path in written.paths):
        others = f"; its tables: {', '.join(groups)}" if len(groups) > 1 else ""
        tell(f'open {ROWS} with xarray.open_datatree("{written.folder / ROWS}")["{groups[0]}"]{others}')
    if not isinstance(run.recorded, list):
        tell(f"no result.csv: the tables take more than {IN_MEMORY / 1e6:g} MB; result.nc holds all rows")


def require_good(finished: Finished, check: bool) -> None:
    """Raise RunError for an early end, for anything that could not be made, or for a failed check."""
    run, written = finished.run, finished.written
    if finished.failures:
        lines = list(finished.failures)
        if run.failure:
            lines.append(f"what was computed until then is in {written.folder}, marked incomplete")
        elif not written.elsewhere:
            lines.append(f"the rows are in {written.folder / ROWS}")
        raise RunError("\n".join([*lines, finished.resume]).strip())
    require_energy(run)
    if not check:
        return
    if not written.summary.get("steady", True):
        raise RunError("the run ended before it was steady: nothing could be compared; give it a later --stop")
    outside = [row["label"] for row in written.comparison if row["within"] is False]
    if outside:
        raise RunError(f"outside their bounds: {', '.join(outside)}")
