"""Every shipped system of native FMUs as a C program: its rows are those of the run, bit by bit."""

from __future__ import annotations

import csv
import re
import subprocess
from pathlib import Path

import numpy as np
from rovbrush.components.build import COMPONENTS, HERE, build
from rovbrush.orchestrator.emit.folder import write_c
from rovbrush.orchestrator.results.files.csv import rate_names
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

NAME = "exported"
CLAIM = "a shipped system as a C program gives the rows of its run, bit by bit"
SYSTEMS = (
    "station_keeping", "test_stand", "nominal", "no_load", "constant_speed", "no_thrust", "open_water",
    "test_stand_battery", "hull_pass", "hull_pass_battery", "hull_pass_paper", "fouling_patch", "cup_nominal",
    "counter_rotating", "three_cups", "jam",
)  # fmt: skip
COUNT = len(SYSTEMS)
UNIT = "systems"
LIMIT = 600.0
SAMPLE = 0  # tests/orchestrator/emit has one of them
FINITE = True
STOP = "1.1 s"  # behind the event of `jam`


def built(system: str, folder: Path) -> Path:
    """The native FMUs of a system, for Linux, each made once in a folder."""
    text = (HERE.parent / "orchestrator" / "systems" / f"{system}.toml").read_text(encoding="utf-8")
    for name in sorted(set(COMPONENTS) & set(re.findall(r'"(\w+)"', text))):
        if not (folder / "native" / "fmi2" / f"{name}.fmu").is_file():
            build(HERE / name, folder, 0, ("linux64",))
    return folder / "native" / "fmi2"


def one(index: int, folder: Path) -> str:
    system = assemble(SYSTEMS[index], {}, STOP, built(SYSTEMS[index], folder.parent))
    write_c(system, folder / "c")
    subprocess.run(["make", "CC=gcc -w"], cwd=folder / "c", check=True, capture_output=True)
    (folder / "c" / "rows").mkdir()
    (program,) = (folder / "c").glob("*_run")
    subprocess.run([str(program), "rows"], cwd=folder / "c", check=True, capture_output=True)
    run = simulate(planned(system))
    if run.failure:
        return run.failure
    signals = Signals(run)
    for group, file in zip(run.plan.groups, rate_names(run.plan), strict=True):
        with (folder / "c" / "rows" / file).open(encoding="utf-8") as lines:
            head, *rows = csv.reader(lines)
        head = [re.sub(r" \[[^\]]*\]$", "", name) for name in head]  # without units
        cells = np.array(rows, dtype=float)
        for key in group.columns:
            name = ".".join(key)
            own, their = np.asarray(signals[name].values, dtype=float), cells[:, head.index(name)]
            if own.tobytes() != their.tobytes():
                return f"{SYSTEMS[index]}: {name} differs"
    return ""
