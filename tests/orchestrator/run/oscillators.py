"""Two oscillators, FMUs for Model Exchange, with every solver."""

from __future__ import annotations

from pathlib import Path

import exchange_build
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.system.file.reader import load_system

SYSTEM = """
format = 2
stop_time = "{stop}"
algorithm = "{algorithm}"
[solver]
{solver}
[components.o]
fmu = "oscillator.fmu"
period = "50 ms"
parameters = {{ mu = {mu} }}
{more}
[components.f]
fmu = "forced.fmu"
period = "70 ms"
"""
CVODE, RESTARTED = 'method = "cvode"', 'method = "cvode"\nrestart = true'
METHODS = ('method = "dormand-prince"', 'method = "rk4"\nstep = "3 ms"', CVODE, RESTARTED)
PUSHED = "inputs = { u = { time = [0.0, 8.0], values = [0.0, 3.0] } }"


def planned(
    folder: Path, solver: str, mu: float = 5.0, more: str = "", algorithm: str = "gauss-seidel", stop: str = "8 s"
) -> Plan:
    for name in ("oscillator", "forced"):
        exchange_build.exchange(folder, name)
    path = folder / "system.toml"
    path.write_text(SYSTEM.format(solver=solver, mu=mu, more=more, algorithm=algorithm, stop=stop), encoding="utf-8")
    return make_plan(load_system(str(path), folder))
