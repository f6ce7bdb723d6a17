"""Shipped systems as one native FMU in a host in C, on Linux and under wine.

A mathematical library gives the sine, cosine, exponential... of a number by its own rules for the last bit, and that of
Windows is not that of Linux. So three things are claimed: on Linux the bits are those of the run; on Windows they are
those of Linux where both are compiled, from the sources inside of the FMU, with the same mathematical functions; and
with its own ones Windows differs by no more than rounding grows to.
"""

from __future__ import annotations

import re
import subprocess
import zipfile
from pathlib import Path

import numpy as np
from recorder import COMPILERS, ENDINGS, HOST, recorded
from rovbrush.orchestrator.emit.compiling import LINUX, OPTIONS, WINDOWS
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

from .exported import built

NAME = "exported_windows"
CLAIM = (
    "one FMU of a shipped system in a host in C: bits of the run on Linux, and on Windows with the same sine and cosine"
)
CASES = (("hull_pass", "2.0", 38.0), ("hull_pass", "3.0", 38.0), ("nominal", "2.0", 10.0), ("jam", "3.0", 4.0))
COUNT = len(CASES)
UNIT = "FMUs"
LIMIT = 900.0  # hull_pass, the longest, takes 290 s on two cores, nominal and jam 65 s, or 170 s beside other work
SAMPLE = 0  # tests/orchestrator/emit/test_written_fmu.py has a small one
FINITE = True
SAYS = True
EARLY = 1.1  # s: rounding has not grown far
NEAR = 1e-10  # of the largest value of an output, until then; see `_size`


def compiled(fmu: Path, platform: str) -> Path:
    """The library of an FMU made from the sources inside of it, with the mathematical functions of `same_math.c`."""
    work = fmu.parent / f"{fmu.stem}_sources"
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(work)
    listed = "modelDescription.xml", "sources/buildDescription.xml"
    texts = [(work / name).read_text(encoding="utf-8") for name in listed if (work / name).is_file()]
    files = [name for text in texts for name in re.findall(r'<(?:Source)?File name="(.*?)"', text)]
    _, _, _, shared, last = LINUX if platform == "linux" else WINDOWS
    made = fmu.parent / f"same{ENDINGS[platform]}"
    command = [COMPILERS[platform], *OPTIONS, "-fno-builtin-sincos", "-w", "-I.", *shared.split(), *files]
    command += [str(HOST / "same_math.c"), "-o", str(made), *last.split()]
    subprocess.run(command, cwd=work / "sources", check=True, capture_output=True)
    return made


def one(index: int, folder: Path) -> str:
    name, fmi, stop = CASES[index]
    system = assemble(name, {}, f"{stop} s", built(name, folder.parent))
    path = folder / "whole.fmu"
    export_fmu(system, path, fmi)
    step = float(min(c.period for c in system.components.values()))
    every = 10
    steps = round(stop / step)
    linux, windows = (recorded(path, platform, step, steps, every) for platform in ("linux", "windows"))
    if wrong := _unlike_the_run(system, linux, step * every):
        return f"{name}, FMI {fmi}, Linux: {wrong}"
    same = [recorded(path, platform, step, steps, every, compiled(path, platform)) for platform in ("linux", "windows")]
    if differing := [key for key in same[0] if same[0][key].tobytes() != same[1][key].tobytes()]:
        return f"{name}, FMI {fmi}: {', '.join(differing[:5])} differ with the same mathematical functions"
    until = round(EARLY / step / every) + 1
    far = {key: _distance(linux[key], windows[key], until, _size(key, linux, until)) for key in linux}
    worst = max(far, key=lambda key: far[key])
    other = [k for key in linux for k in np.flatnonzero(linux[key] != windows[key])[:1]]
    rows = len(next(iter(linux.values())))
    print(
        f"{name}, FMI {fmi}: {len(linux)} outputs, {rows} rows: Linux as the run, Windows as Linux with the same "
        f"mathematical functions, bit by bit; with its own first different at "
        f"{min(other) * step * every if other else stop:.9g} s, by at most {far[worst]:.1e} of {worst} within {EARLY} s"
    )
    return "" if far[worst] <= NEAR and rows > 100 else f"{name}, FMI {fmi}: {worst} differs by {far[worst]:.1e}"


def _unlike_the_run(system: object, rows: dict[str, np.ndarray], step: float) -> str:
    run = simulate(planned(system))  # type: ignore[arg-type]
    if run.failure:
        return run.failure
    signals, compared = Signals(run), 0
    for group, ticks in zip(run.plan.groups, run.ticks, strict=True):
        times = np.array([run.plan.clock.time(t) for t in ticks.tolist()])
        places = np.round(times / step).astype(int)
        there = np.abs(times - places * step) < 1e-9
        for key in group.columns:
            key_name = ".".join(key)
            if key in run.plan.layout.outputs and key_name in rows:
                own = np.asarray(signals[key_name].values, dtype=float)[there]
                compared += 1
                if own.tobytes() != rows[key_name][places[there]].tobytes():
                    return f"{key_name} differs from the run"
    return "" if compared > 50 else f"only {compared} signals were compared"


def _size(key: str, rows: dict[str, np.ndarray], until: int) -> float:
    """The largest value of an output; of a residual, in which energies cancel, that of its component's energies."""
    component, _, variable = key.partition(".")
    summed = [k for k in rows if k.startswith((f"{component}.E_", f"{component}.W_"))]
    keys = summed if variable == "energy_residual" else [key]
    return max(1e-300, *(float(np.abs(rows[k][:until]).max()) for k in keys))


def _distance(one_: np.ndarray, other: np.ndarray, until: int, size: float) -> float:
    """The largest difference, of a size."""
    return float(np.abs(one_[:until] - other[:until]).max()) / size
