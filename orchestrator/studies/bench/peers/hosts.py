"""Other masters run a system: libcosim (libcosimpy), Ecos (ecospy), and a plain loop of fmpy calls.

All three step every FMU in parallel at one period with inputs held: what the plan calls `jacobi` and `hold`. Each
runs in a process of its own, since a foreign library may crash or hang, and reads the system from an SSP that our
export writes.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from ....clock import seconds_text
from ....errors import InputError, RunError
from ....system.model import System
from ....system.ssp.write import write_ssp
from . import host_loops
from .host_loops import load_tbb

HOSTS = tuple(host_loops.LOOPS)  # also the names of the packages


@dataclass(frozen=True)
class HostRun:
    """What a host reports: wall time in its steps, per macro step [s], and every Real output after the last one."""

    seconds_per_step: float
    outputs: dict[str, float]


def run_host(host: str, system: System, steps: int, recording: bool = False, limit: float = 120.0) -> HostRun:
    """Run a system of one period in another master for `steps` steps, in a process that may take `limit` seconds.

    `recording`: every output at every step, by what the host offers for it. Raises InputError for a host that is not
    installed and for systems of several periods, RunError if the host fails.
    """
    if steps < 3:
        raise InputError(f"{host}: at least 3 steps are needed to measure one")
    why = missing(host)
    if why:
        raise InputError(why)
    periods = {component.period for component in system.components.values()}
    if len(periods) > 1:
        shown = ", ".join(map(seconds_text, sorted(periods)))
        raise InputError(f"{host} is given systems of one period; {system.name} has {shown}")
    for name, component in system.components.items():
        if not component.fmu.description.fmiVersion.startswith("2"):
            raise InputError(f"{host} is given FMI 2.0; component {name} is of {component.fmu.description.fmiVersion}")
    with tempfile.TemporaryDirectory(prefix="rovbrush_host_") as folder:
        ssp, answer = Path(folder) / "system.ssp", Path(folder) / "answer.json"
        write_ssp(system, ssp)
        command = [
            sys.executable,
            "-m",
            host_loops.__name__,
            host,
            str(ssp),
            str(steps),
            str(int(recording)),
            str(answer),
        ]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit, cwd=folder, check=False)
        except subprocess.TimeoutExpired:
            raise RunError(f"{host} did not finish {steps} steps of {system.name} within {limit:g} s") from None
        if not answer.is_file():
            tail = "\n".join(done.stderr.strip().splitlines()[-5:])
            raise RunError(f"{host} failed on {system.name} (exit code {done.returncode}): {tail}")
        return HostRun(**json.loads(answer.read_text(encoding="utf-8")))


def missing(host: str) -> str:
    """Why a host cannot be used here; empty if it can."""
    if host not in HOSTS:
        return f"no host '{host}'; there are {', '.join(HOSTS)}"
    if find_spec(host) is None:
        return f"{host} is not installed: pip install 'rovbrush[hosts]'"
    if host == "ecospy" and sys.platform == "linux" and not load_tbb():
        return "ecospy needs libtbb.so.12, which its package leaves out: pip install tbb"
    return ""
