"""Motor parameters from noisy logs: how often the 95 % intervals hold the values with which the logs were made."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from rovbrush.components.build import HERE, build
from rovbrush.orchestrator import load
from rovbrush.orchestrator.studies.fit.experiment import Recipe
from rovbrush.orchestrator.studies.fit.fit import Options, fit

from . import seeded

NAME = "fit"
CLAIM = "R, K_t and B_m of the motor from noisy logs: of 100 seeds each one's 95 % interval holds it in 89 to 99"
COUNT = 1
UNIT = "series of 100 logs"
LIMIT = 1800.0
SAMPLE = 0
FINITE = True

SEEDS, BETWEEN = 100, (89, 99)
TRUE = {"motor.R": 0.09, "motor.K_t": 0.0172, "motor.B_m": 8e-4}
VARY = ("motor.R=0.04:0.2", "motor.K_t=0.01:0.03", "motor.B_m=2e-4:3e-3:log")
NOISE = {"motor.i": 1.0, "motor.omega_b": 0.05}  # A, rad/s: standard deviations
SYSTEM = """
format = 2
stop_time = "3 s"
[components.motor]
fmu = "dc_motor"
period = "5 ms"
inputs = { V_in = { time = [0.0, 1.0, 1.0, 2.0, 2.0, 3.0], values = [6.0, 6.0, 12.0, 12.0, 9.0, 9.0] }, T_brush = { \
time = [0.0, 1.5, 1.5, 2.5, 2.5, 3.0], values = [0.0, 0.0, 8.0, 8.0, 2.0, 2.0] } }
"""


def prepare(folder: Path) -> None:
    build(HERE / "dc_motor", folder, 0, ("linux64",))
    (folder / "motor.toml").write_text(SYSTEM, encoding="utf-8")


def log(folder: Path, seed: int) -> Path:
    """What a data logger would have written: every 10 ms, with Gaussian noise."""
    result = load(folder / "motor.toml", fmus=fmus(folder), values=TRUE, record=list(NOISE)).run()
    random = np.random.default_rng(seed)
    times = result["motor.i"].time.values[::2]
    columns = [result[name].values[::2] + sigma * random.normal(size=len(times)) for name, sigma in NOISE.items()]
    path = folder / f"log{seed}.csv"
    rows = "".join(",".join(map(repr, map(float, row))) + "\n" for row in zip(times, *columns, strict=True))
    path.write_text(f"time,{','.join(NOISE)}\n{rows}", encoding="utf-8")
    return path


def fmus(folder: Path) -> Path:
    return next(path.parent for path in folder.rglob("dc_motor.fmu") if path.parent.name == "fmi2")


def held(folder: Path, seeds: range) -> dict[str, int]:
    """How many intervals hold the true value, by parameter."""
    options = Options(VARY, [",".join(NOISE)], fmus=fmus(folder))
    found = dict.fromkeys(TRUE, 0)
    for seed in seeds:
        for one in fit(str(folder / "motor.toml"), [Recipe(log(folder, seed))], options).estimates:
            found[one.name] += one.low <= TRUE[one.name] <= one.high
    return found


def one(index: int, folder: Path) -> str:
    first = seeded(NAME, index).randrange(10**6)
    found = held(folder.parent, range(first, first + SEEDS))
    print(json.dumps(found))
    good = all(BETWEEN[0] <= count <= BETWEEN[1] for count in found.values())
    return "" if good else f"of {SEEDS} intervals hold the true value: {found}"
