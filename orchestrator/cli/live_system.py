"""`rovbrush live`: from what was asked for to a run with a page, and what a person is told of it."""

from __future__ import annotations

from pathlib import Path

from ..extras import require
from ..live.carried import run_live
from ..live.driver import checked_speed
from ..live.server import PageServer
from ..live.touch import touchable
from ..loop.machine.compiled import require_loop
from ..participant.opening import require_compiler
from ..run.carry_out import Finished, claim
from ..run.planned import planned
from ..system.assemble import assemble_request
from ..system.request import Request
from .console import print_notes, tell
from .run_system import require_good, show


def live_system(
    request: Request, out: Path, speed: float, paused: bool, place: tuple[str, int, str], stay: bool, force: bool
) -> None:
    """Run, with a page at `place` (host, port, token). Errors as of `run_system`, and InputError for the place."""
    require("nicegui", "rovbrush live")
    checked_speed(speed)
    server = PageServer(*place)
    try:
        system = assemble_request(request)
        plan = planned(touchable(system), deadlines="")
        require_loop()
        for component in system.components.values():
            require_compiler(component.fmu, component.name)
        folder, older = claim(out, system.name, force)
        print_notes(system)
        server.wait()
        tell(f"the page is at {server.url} (Ctrl-C ends the run and writes its results)")
        last: list[Finished] = []

        def ended(finished: Finished) -> None:
            last[:] = [finished]
            show(finished)

        run_live(plan, request, server, folder, older, ended, speed, paused, stay)
    finally:
        server.close()
    require_good(last[-1], check=False)
