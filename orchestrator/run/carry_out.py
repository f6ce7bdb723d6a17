"""A planned run into a folder: the rows first, then what is made of them. Nothing is printed here.

Whatever ends the run (its stop, a failing FMU, a signal, a disk that fills up, a fault of ours), the rows that are
complete are written and closed before anything else is made of them.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from math import ceil
from pathlib import Path

from ..clock import duration
from ..errors import InputError, RovbrushError, RunError
from ..files import prepare_folder, sweep_up, typed, write_file
from ..plan.plan import Plan
from ..results.files.folder import remove, require_own
from ..results.files.writing import MESSAGES, More, Written, write_messages, write_products, write_rows
from ..results.tables import Run
from ..system.request import Request
from .checkpoint.checkpoint import Checkpoint, unserializable, write_checkpoint
from .checkpoint.files import found_in
from .ends.interrupt import ENDING, StopRequests
from .pacing.pace import Pace
from .pacing.scheduling import scheduled
from .recording.observers import Every, Progress
from .session.session import Session


@dataclass
class Finished:
    """A run that has ended, and what it left. `resume` says how it can go on, or why it cannot."""

    run: Run
    written: Written
    resume: str = ""
    failures: list[str] = field(default_factory=list)  # of the run and of what was to be made of it


def claim(out: Path, system: str, force: bool = False, option: str = "--out") -> tuple[Path, list[str]]:
    """The folder of a run, absolute and ready to be written to, and the files of the run before, which it replaces.

    What dead runs left half-written is swept up. Raises InputError if the folder is somebody else's or cannot be
    written; see `require_own`.
    """
    out = Path(os.path.abspath(out))  # an FMU may change the working directory
    older = require_own(out, system, force)
    prepare_folder(out, option)
    found_in(out)  # before it is swept up: a checkpoint may lie there under a temporary name
    sweep_up(out)
    return out, older


def checkpoint_ticks(plan: Plan, every: str) -> Iterable[int]:
    """The instants at which checkpoints are due, before the stop. Raises InputError where FMUs cannot be saved."""
    if not every:
        return []
    ticks = duration(every, "--checkpoint") / plan.clock.seconds(1)
    if why := unserializable(plan):
        raise InputError(f"--checkpoint: {why}; run without it")
    return (ceil(k * ticks) for k in range(1, ceil(plan.clock.stop / ticks)))


def carry_out(
    plan: Plan,
    out: Path,
    request: Request,
    older: Sequence[str] = (),
    begin: Checkpoint | None = None,
    force: bool = False,
    progress: Callable[[float], object] | None = None,
    more: Sequence[More] = (),
    pace: Pace | None = None,
    go: Callable[[Session], object] = Session.advance,
    watched: Callable[[Session], AbstractContextManager[None]] = lambda _session: nullcontext(),
) -> Finished:
    """Run a plan, or go on with it from `begin`, and write everything into `out`, see `claim`.

    `older`: files that are removed when time 0 is reached. `request` is kept with checkpoints. `progress` is called
    now and then with the time reached [s]. `more`: products beside the usual ones. `pace`: in real time. `go` brings
    the session to its end, `watched` is there meanwhile. Ctrl-C, SIGTERM and SIGHUP end the run in good order. Raises
    FmuError or InputError where time 0 cannot be reached, RunError if nowhere is room for the rows; every other failure
    is in what is returned.
    """
    file = out / f".result.{os.getpid()}.tmp.nc"
    stop = StopRequests(ENDING)
    try:
        with stop.heard(), Session(plan, file=file, stop_requests=stop, pace=pace) as session:
            if begin:
                begin.restore(session, force)
            with scheduled(pace), watched(session):  # what refuses here has cost nobody their results
                remove(out, older)
                _advance(session, out, request, progress, go)
            resume = _resume(session, out, request) if go is Session.advance else ""  # another one is not known again
            run = session.run()
            written = write_rows(run, out)
            stop.insist()
            finished = Finished(run, written, resume)
            try:
                write_products(run, written, more)
            except KeyboardInterrupt:
                written.failures.append("interrupted while the results were written")
            finished.failures = [*filter(None, [run.failure, written.elsewhere]), *written.failures]
        finished.failures += filter(None, [session.ended_badly])
        _say_more(session, finished)
        return finished
    finally:
        file.unlink(missing_ok=True)


def _advance(
    session: Session, out: Path, request: Request, progress: Callable[[float], object] | None,
    go: Callable[[Session], object],
) -> None:  # fmt: skip
    """To the stop, or until something ends the run: `failure` says what."""

    def keep(_time: float) -> None:
        if not session.over:
            session.failure = _kept(session, out, request)

    due = (tick for tick in checkpoint_ticks(session.plan, request.checkpoint) if tick > session.tick)
    session.observers.append(Every(keep, due))
    if progress:
        session.observers.append(Progress(progress))
    try:
        go(session)
    except KeyboardInterrupt:
        session.fail(f"{session.stop_requests.reason}, at once, at t = {session.time:.9g} s")
    except RovbrushError as error:
        session.fail(str(error))
    except Exception as error:  # a fault of ours: what was computed is not to be lost for it
        session.fail(f"t = {session.time:.9g} s: unexpected {type(error).__name__}: {error}")


def _say_more(session: Session, finished: Finished) -> None:
    """What FMUs logged while they were terminated, beside what they had before."""
    messages = session.participants.messages()
    if len(messages) > len(finished.run.messages):
        path = finished.written.folder / MESSAGES
        try:
            write_file(path, lambda new: write_messages(messages, new))
        except RunError as error:
            finished.failures.append(str(error))


def _resume(session: Session, out: Path, request: Request) -> str:
    """How a run that was interrupted can go on; empty where that is no question."""
    if not session.failure or not session.resumable:
        return ""
    if why := _kept(session, out, request):
        return why
    return "\n".join([f"go on with `rovbrush run --resume {typed(out)}`", *session.forgotten])


def _kept(session: Session, out: Path, request: Request) -> str:
    """Write a checkpoint; why that cannot be, if so: what was computed is not to be lost for it."""
    try:
        write_checkpoint(session, out, request.content())
    except RovbrushError as error:
        return str(error)
    except Exception as error:
        return f"no checkpoint could be written: unexpected {type(error).__name__}: {error}"
    return ""
