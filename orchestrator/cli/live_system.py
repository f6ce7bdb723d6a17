"""`rovbrush live`: from what was asked for to a run with a page, and what a person is told of it."""

from __future__ import annotations

from pathlib import Path

from ..live.carried import run_live
from ..live.driver import checked_speed
from ..live.server import PageServer
from ..live.touch import touchable
from ..loop.machine.compiled import require_loop
from ..participant.opening import require_compiler
from ..run.carry_out import Finished, claim
from ..run.pacing.asked import place_of
from ..run.pacing.pace import Pace
from ..run.planned import planned
from ..system.assemble import assemble_request
from ..system.request import Request
from .console import print_notes, tell
from .run_system import require_good, show


def live_system(
    request: Request, out: Path, server: PageServer, speed: float, paused: bool, stay: bool, force: bool
) -> None:
    """Run, with a page by that server. Errors as of `run_system`."""
    checked_speed(speed)
    pace = Pace(speed or 1.0, "warn", "", *place_of(request))
    system = assemble_request(request)
    plan = planned(touchable(system), deadlines="")
    require_loop()
    for component in system.components.values():
        require_compiler(component.fmu, component.name)
    folder, older = claim(out, system.name, force)
    print_notes(system)
    last: list[Finished] = []

    def ready() -> None:
        server.wait()
        tell(f"the page is at {server.url} (Ctrl-C ends the run and writes its results)")

    def ended(finished: Finished) -> None:
        last[:] = [finished]
        show(finished)

    run_live(plan, request, server, folder, older, ended, pace, speed, paused, stay, ready)
    require_good(last[-1], check=False)
