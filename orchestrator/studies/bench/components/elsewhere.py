"""What it costs to have an FMU elsewhere: a step of each component here, in a process of its own, and at a server."""

from __future__ import annotations

import re
import statistics
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....errors import RunError
from ....plan.plan import make_plan
from ....system.file.reader import load_system
from ..fmus.systems import alone
from ..peers.masters import rovbrush_loop
from .components import STEP

REPEATS = 5
SERVES = re.compile(r"serving .* at (tcp://\S+)")


def elsewhere_rows(native: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds per step of every component with its exchange: here, in a process, at a server on this machine; in
    turns, with the share that is done. Raises RunError where the server does not begin."""
    system = load_system("nominal", native)
    with _served([component.fmu.path for component in system.components.values()]) as address:
        for k, name in enumerate(system.components):
            here = alone(system, name, STEP)
            plans = {}
            for where, isolation in (("here", ""), ("process", "process"), ("server", address)):
                component = replace(here.components[name], isolation=isolation)
                plans[where] = make_plan(replace(here, components={name: component}))
            seconds: dict[str, list[float]] = {}
            for _ in range(1 if quick else REPEATS):
                for where, plan in plans.items():
                    steps = plan.clock.stop // plan.clock.periods[name]
                    seconds.setdefault(where, []).append(1e6 * rovbrush_loop(plan) / steps)
            row = {f"{where}_us": statistics.median(values) for where, values in seconds.items()}
            fmu = here.components[name].fmu
            numbers = {"inputs": len(fmu.names("input")), "outputs": len(fmu.names("output"))}
            yield (k + 1) / len(system.components), {"component": name, "runs": len(seconds["here"]), **numbers, **row}


@contextmanager
def _served(fmus: Sequence[Path]) -> Iterator[str]:
    """The address of a server of these FMUs, a process of its own."""
    command = [sys.executable, "-m", "rovbrush.orchestrator", "serve", *map(str, fmus), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as server:
        assert server.stdout is not None
        said = server.stdout.readline()
        found = SERVES.search(said)
        try:
            if found is None:
                raise RunError(f"bench elsewhere: the server did not begin: {said}{server.stdout.read()}")
            yield found[1]
        finally:
            server.kill()
