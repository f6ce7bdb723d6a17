"""One run of one system, from its file to the results folder."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import fields, replace
from math import ceil
from pathlib import Path

from ..cli.console import console, print_comparison, print_notes, print_summary, progress
from ..clock import duration
from ..errors import InputError, RovbrushError, RunError
from ..exchange.recordings.write import write_boundary
from ..files import prepare_folder
from ..plan.plan import Plan
from ..results.energy import require_energy
from ..results.files import write_results
from ..results.summary import comparison, summarize
from ..results.tables import Run
from ..run.checkpoint import Checkpoint, read_checkpoint, unserializable, write_checkpoint
from ..run.fingerprint import require_unchanged
from ..run.interrupt import stop_on_interrupt
from ..run.planned import planned
from ..run.recorder import IN_MEMORY
from ..run.session import Session
from ..system.assemble import assemble_request
from ..system.request import Request


def run_system(request: Request, out: Path, check: bool) -> None:
    """Run, print and write. Raises RunError after an early end (what was computed is written) or a failed check."""
    plan = planned(assemble_request(request), request.record_boundary)
    times = checkpoint_ticks(plan, request.checkpoint)
    prepare_folder(out)
    print_notes(plan.system)
    _run(plan, request, out, check, times)


def resume_system(folder: Path, asked: Request, check: bool) -> None:
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
    plan = planned(assemble_request(request), request.record_boundary)
    require_unchanged(checkpoint.unchanged, plan)
    times = checkpoint_ticks(plan, request.checkpoint)
    prepare_folder(folder, "--resume")
    console.print(f"going on from t = {checkpoint.at.time:.9g} s")
    _run(plan, request, folder, check, times, checkpoint)


def checkpoint_ticks(plan: Plan, every: str) -> Iterable[int]:
    """The instants at which checkpoints are due, before the stop. Raises InputError where FMUs cannot be saved."""
    if not every:
        return []
    ticks = duration(every, "--checkpoint") / plan.clock.seconds(1)
    if why := unserializable(plan):
        raise InputError(f"--checkpoint: {why}; run without it")
    return (ceil(k * ticks) for k in range(1, ceil(plan.clock.stop / ticks)))


def _run(
    plan: Plan, request: Request, out: Path, check: bool, checkpoints: Iterable[int], begin: Checkpoint | None = None
) -> None:
    console.print("loading the FMUs; the first run compiles their kernels, which takes about half a minute")
    file = out / f".result.{os.getpid()}.tmp.nc"
    hint = ""
    try:
        with Session(plan, file=file) as session, stop_on_interrupt(session.control):
            if begin:
                begin.restore(session)
            with progress(float(plan.system.stop), f"running {plan.system.name}", begin=int(session.time)) as report:
                for tick in checkpoints:
                    if tick > session.tick and not session.failure:
                        session.advance(until_tick=tick, progress=report)
                        if not session.failure:
                            session.failure = _keep(session, request, out)
                if not session.failure:
                    session.advance(progress=report)
            if session.failure and session.resumable:
                why = _keep(session, request, out)
                hint = f"\n{why}" if why else f"\ngo on with `rovbrush run --resume {out}`"
            write_run(session.run(), out, request.record_boundary, check, hint)
    finally:
        file.unlink(missing_ok=True)


def _keep(session: Session, request: Request, out: Path) -> str:
    """Write a checkpoint; why that cannot be, if so: what was computed is not to be lost for it."""
    try:
        write_checkpoint(session, out, request.content())
    except RovbrushError as error:
        return str(error)
    return ""


def write_run(run: Run, out: Path, boundaries: Sequence[str], check: bool, hint: str = "") -> None:
    """Print and write what a run left; see `run_system`. `hint` goes with the error of an early end."""
    summary = summarize(run)
    rows = comparison(run, summary)
    summary["comparison"] = [
        {k: row[k] for k in ("label", "unit", "reference", "value", "ratio", "within")} for row in rows
    ]
    paths = write_results(run, out, summary)
    for component in boundaries:
        paths += write_boundary(run, component, out)
    print_comparison(rows)
    print_summary(summary)
    console.print(f"wrote {', '.join(path.name for path in paths)} to {out}")
    if not isinstance(run.recorded, list):
        console.print(f"no result.csv: the tables take more than {IN_MEMORY / 1e6:g} MB; result.nc holds all rows")
    if run.failure:
        raise RunError(
            f"{run.failure}\nwhat was computed until then is in {out}, marked incomplete" + f"\n{hint}" * bool(hint)
        )
    require_energy(run)
    outside = [row["label"] for row in rows if row["within"] is False]
    if check and outside:
        raise RunError(f"outside their bounds: {', '.join(outside)}")
