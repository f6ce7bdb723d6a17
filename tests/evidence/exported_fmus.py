"""Shipped systems as one native FMU each, in fmpy: the bits of the run at every instant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from fmpy import simulate_fmu
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

from .exported import built

NAME = "exported_fmus"
CLAIM = "a shipped system as one native FMU gives the bits of its run in another host, and is fit to be exchanged"
CASES = tuple(
    (system, fmi) for system in ("test_stand", "jam", "hull_pass", "station_keeping") for fmi in ("2.0", "3.0")
)
COUNT = len(CASES)
UNIT = "FMUs"
LIMIT = 900.0
SAMPLE = 0  # tests/orchestrator/emit has small ones
FINITE = True
STOP = 1.1  # s


def one(index: int, folder: Path) -> str:
    name, fmi = CASES[index]
    system = assemble(name, {}, f"{STOP} s", built(name, folder.parent))
    path = folder / "whole.fmu"
    export_fmu(system, path, fmi)
    if wrong := [row for row in check_fmu(path).rows if row.verdict == "error"]:
        return str(wrong)
    run = simulate(planned(system))
    if run.failure:
        return run.failure
    step, outputs = float(min(c.period for c in system.components.values())), run.plan.layout.outputs
    names = [".".join(key) for group in run.plan.groups for key in group.columns if key in outputs]
    found = simulate_fmu(str(path), stop_time=STOP, step_size=step, output_interval=step, output=names)
    at = np.round(found["time"] / step).astype(int)
    signals, compared = Signals(run), 0
    for group, ticks in zip(run.plan.groups, run.ticks, strict=True):
        places = np.round(np.array([run.plan.clock.time(t) for t in ticks.tolist()]) / step).astype(int)
        for key in group.columns:
            if key in outputs:
                own = np.asarray(signals[".".join(key)].values, dtype=float)[np.isin(places, at)]
                their = np.asarray(found[".".join(key)], dtype=float)[np.isin(at, places)]
                compared += 1
                if own.tobytes() != their.tobytes():
                    return f"{name}, FMI {fmi}: {'.'.join(key)} differs"
    return "" if compared > 50 else f"{name}: only {compared} signals were compared"
