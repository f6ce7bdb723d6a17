"""What the master costs: microseconds per macro step, beside a loop of plain fmpy calls over the same plan.

A macro step is one period of the fastest component. Ratios of rows from one run count; the machine does not.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from rich.table import Table

from ..console import console
from ..errors import RunError
from ..fmi2_instance import Fmi2Instance
from ..initialize import initialize
from ..memory import Memory
from ..operations import ACCUMULATE, COPY, GET, LINEAR, MEAN, PUSH, RECORD, SET, STEP
from ..plan import Plan, make_plan
from ..reader import load_system
from ..results import prepare_folder, write_file, write_json
from ..simulation import require_complete, simulate
from ..system import System

REPEATS = 5

TRIVIAL_FMU = """
from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real


class Feedthrough(Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.u = 0.0
        self.y = 0.0
        self.register_variable(Real("u", causality=Fmi2Causality.input, variability=Fmi2Variability.continuous))
        self.register_variable(Real("y", causality=Fmi2Causality.output, variability=Fmi2Variability.continuous))

    def do_step(self, current_time, step_size):
        self.y = self.u
        return True
"""

CHAIN = """
description = "four trivial Python FMUs in a ring"
stop_time = "20 s"
record = ["*"]
connections = ["a.y -> b.u", "b.y -> c.u", "c.y -> d.u", "d.y -> a.u"]
""" + "".join(f'[components.{name}]\nfmu = "Feedthrough.fmu"\nperiod = "1 ms"\n' for name in "abcd")


def bench(json_file: Path | None, fmus: Path | None) -> list[dict[str, Any]]:
    """Measure `python4` and `nominal`, print the table and write the rows. Raises RunError if a run fails."""
    if json_file:
        prepare_folder(json_file.parent, "--json")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        python4 = trivial_system(Path(folder))
        nominal = load_system("nominal", fmus)
        for system, fmpy_stop in ((python4, Fraction(4)), (nominal, Fraction(1))):
            for recording in (False, True):
                variant = replace(system, record=("*",) if recording else (), bonds=())
                label = {"system": "python4" if system is python4 else "nominal", "recording": recording}
                rows.append({**label, "master": "rovbrush", **measure(variant, rovbrush_loop)})
                rows.append({**label, "master": "fmpy", **measure(replace(variant, stop=fmpy_stop), fmpy_loop)})
    next(r for r in rows if (r["system"], r["master"], r["recording"]) == ("nominal", "rovbrush", True)).update(
        process_figures(fmus)
    )
    show(rows)
    if json_file:
        write_file(json_file, lambda path: write_json(path, rows))
        console.print(f"wrote {json_file}")
    return rows


def trivial_system(folder: Path) -> System:
    """Four feedthrough FMUs made by pythonfmu as they come, in a ring."""
    from pythonfmu.builder import FmuBuilder

    script = folder / "feedthrough_slave.py"
    script.write_text(TRIVIAL_FMU)
    FmuBuilder.build_FMU(script, folder / "Feedthrough.fmu")
    path = folder / "python4.toml"
    path.write_text(CHAIN)
    return load_system(str(path))


def measure(system: System, loop: Callable[[Plan], float]) -> dict[str, float]:
    """Median over REPEATS runs of a loop's wall time, per macro step and against real time."""
    plan = make_plan(system)
    steps = plan.clock.stop // min(plan.clock.periods.values())
    wall = statistics.median(loop(plan) for _ in range(REPEATS))
    return {"us_per_macro_step": 1e6 * wall / steps, "real_time_factor": float(system.stop) / wall}


def rovbrush_loop(plan: Plan) -> float:
    """Seconds that the compiled master takes."""
    return require_complete(simulate(plan)).wall


def fmpy_loop(plan: Plan) -> float:
    """Seconds that a Python loop takes which does the same plan with fmpy's setReal, doStep and getReal."""
    instances = {name: Fmi2Instance(component.fmu, name) for name, component in plan.system.components.items()}
    memory = Memory(plan)
    initialize(plan, dict(instances), memory)
    slaves = [instance.slave for instance in instances.values()]
    ends = []
    for table in (plan.layout.inputs, plan.layout.outputs):
        by_component = [
            [
                (slot, instances[name].fmu.variables[v].valueReference)
                for (owner, v), slot in table.items()
                if owner == name
            ]
            for name in instances
        ]
        ends.append(
            [
                (slots[0][0], slots[-1][0] + 1, [vr for _, vr in slots]) if slots else (0, 0, [])
                for slots in by_component
            ]
        )
    (inputs, outputs), clock, k = ends, plan.clock, plan.coefficients.tolist()
    values, recorded, rows = memory.z.tolist(), [], plan.cycle.tolist()
    begin = time.perf_counter()
    for cycle in range(clock.stop // clock.hyperperiod):
        base = cycle * clock.hyperperiod
        for code, _, c, a, b, p, q, at in rows:
            if code == SET:
                first, last, references = inputs[c]
                slaves[c].setReal(references, values[first:last])
            elif code == STEP:
                slaves[c].doStep(clock.time(base + b), clock.time(a))
            elif code == GET:
                first, last, references = outputs[c]
                values[first:last] = slaves[c].getReal(references)
            elif code == COPY:
                values[b] = k[at] * values[a] + k[at + 1]
            elif code == LINEAR:
                values[b] = k[at] * (values[a] + k[at + 2] * (values[a] - values[p])) + k[at + 1]
            elif code == ACCUMULATE:
                values[b] += k[at] * (values[p] + values[a])
            elif code == MEAN:
                tail = k[at + 2] * values[a] + k[at + 3] * values[p]
                values[b], values[q] = k[at] * (values[q] + tail) + k[at + 1], -tail
            elif code == PUSH:
                values[b] = values[a]
            elif code == RECORD:
                recorded.append([values[slot] for slot in plan.groups[a].slots])
    wall = time.perf_counter() - begin
    for instance in instances.values():
        instance.close()
    return wall


def process_figures(fmus: Path | None) -> dict[str, float]:
    """Start to first step [s] and peak memory [MB] of a `rovbrush run nominal` in its own process, caches warm."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            sys.executable,
            "-m",
            "rovbrush.orchestrator",
            "run",
            "nominal",
            "--out",
            folder,
            *(["--fmus", str(fmus)] if fmus else []),
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RunError(f"the nominal run in a process of its own failed: {done.stderr.strip()}")
        summary = json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))
    return {key: summary[key] for key in ("start_s", "peak_memory_MB")}


def show(rows: list[dict[str, Any]]) -> None:
    """The rows on the terminal."""
    table = Table(title=f"Cost of the master, medians of {REPEATS} runs", title_justify="left")
    for heading in (
        "system",
        "master",
        "recording",
        "us per macro step",
        "times real time",
        "start to first step [s]",
        "peak memory [MB]",
    ):
        table.add_column(heading, justify="left" if heading in ("system", "master") else "right")
    for r in rows:
        extra = [f"{r[key]:.3g}" if key in r else "" for key in ("start_s", "peak_memory_MB")]
        table.add_row(
            r["system"],
            r["master"],
            "on" if r["recording"] else "off",
            f"{r['us_per_macro_step']:.2f}",
            f"{r['real_time_factor']:.1f}",
            *extra,
        )
    console.print(table)
