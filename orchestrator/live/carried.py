"""Live runs one behind the other: each is carried out like any run, with what was done beside its results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import count
from pathlib import Path

from ..errors import RunError
from ..files import write_file
from ..plan.diagram.draw import block_diagram
from ..plan.plan import Plan
from ..results.tables import Run
from ..run.carry_out import Finished, carry_out, claim
from ..run.ends.interrupt import ENDING, StopRequests
from ..run.pacing.pace import Pace
from ..run.session.session import Session
from ..system.request import Request
from .driver import IDLE, Driver
from .record import Record
from .server import PageServer

SCENARIO = "scenario.toml"
PACE = Pace()
BIGGEST = 40  # components of a diagram


def run_live(
    plan: Plan, request: Request, server: PageServer, out: Path, older: Sequence[str] = (),
    show: Callable[[Finished], object] = lambda finished: None, pace: Pace = PACE, speed: float = 1.0,
    paused: bool = True, stay: bool = True, ready: Callable[[], object] = lambda: None,
) -> list[Finished]:  # fmt: skip
    """Run a plan of a `touchable` system into `out`, and again, beside that, for every reset.

    `show` is told of each run that has ended. `pace`: all but its factor, which is `speed` (0: as fast as it goes).
    `paused`: it waits at its start. `ready` is called there once, and a RunError of it ends the run. `stay`: when a
    run has ended the page is there until Ctrl-C, or until somebody ends it there. Errors as of `carry_out`.
    """
    diagram = block_diagram(plan) if len(plan.system.components) <= BIGGEST else ""
    found: list[Finished] = []
    again, first = True, out
    while again:
        attempt = len(found) + 1
        if attempt > 1:
            out, older = claim(_free(first), plan.system.name)
        record = Record(plan.system.name)
        driver = Driver(server.wire, record, diagram, speed, paused or attempt > 1, attempt, str(out))
        go = driver.go if attempt > 1 else partial(_begin, driver, ready)
        more = [((SCENARIO,), partial(_write_record, record))]
        finished = carry_out(plan, out, request, older, more=more, pace=replace(pace, factor=speed or 1.0), go=go)
        found.append(finished)
        show(finished)
        speed, again = driver.speed, driver.wants == "reset"
        if not again and stay and not driver.interrupted:
            again = _rest(driver, finished, server)
    return found


def _begin(driver: Driver, ready: Callable[[], object], session: Session) -> None:
    try:
        ready()
    except RunError as error:
        session.fail(str(error))
    driver.go(session)


def _free(first: Path) -> Path:
    """A folder beside the first one that is not there yet: what an earlier run left stays."""
    return next(path for k in count(2) if not (path := first.with_name(f"{first.name}_{k}")).exists())


def _write_record(record: Record, run: Run, folder: Path) -> list[Path]:
    return [write_file(folder / SCENARIO, lambda path: path.write_text(record.toml(), encoding="utf-8"))]


def _rest(driver: Driver, finished: Finished, server: PageServer) -> bool:
    """Behind the end of a run: whether it is to begin again."""
    failures = "; ".join(finished.failures)
    why = failures or finished.run.ended or f"it has reached its stop at t = {finished.run.end:.9g} s"
    stop = StopRequests(ENDING)
    with stop.heard():
        driver.rest("failed" if failures else "ended", why, str(finished.written.folder))
        while not stop.asked and not server.gone and not driver.wants:
            driver.obey(IDLE)
    return driver.wants == "reset"
