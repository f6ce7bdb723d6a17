"""Live runs one behind the other: each is carried out like any run, with what was done beside its results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import count
from pathlib import Path

from ..files import write_file
from ..plan.diagram.draw import block_diagram
from ..plan.plan import Plan
from ..results.tables import Run
from ..run.carry_out import Finished, carry_out, claim
from ..run.ends.interrupt import ENDING, StopRequests
from ..run.pacing.pace import Pace
from ..system.request import Request
from .driver import IDLE, Driver
from .record import Record
from .server import PageServer

SCENARIO = "scenario.toml"
BIGGEST = 40  # components of a diagram


def run_live(
    plan: Plan, request: Request, server: PageServer, out: Path, older: Sequence[str] = (),
    show: Callable[[Finished], object] = lambda finished: None, speed: float = 1.0, paused: bool = True,
    stay: bool = True,
) -> list[Finished]:  # fmt: skip
    """Run a plan of a `touchable` system into `out`, and again, beside that, for every reset.

    `show` is told of each run that has ended. `paused`: it waits at its start. `stay`: when a run has ended the page
    is there until Ctrl-C, or until somebody ends it there. Errors as of `carry_out`.
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
        more = [((SCENARIO,), partial(_write_record, record))]
        finished = carry_out(plan, out, request, older, more=more, pace=Pace(speed or 1.0, "skip"), go=driver.go)
        found.append(finished)
        show(finished)
        speed, again = driver.speed, driver.wants == "reset"
        if not again and stay and not driver.interrupted:
            again = _rest(driver, finished, server)
    return found


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
