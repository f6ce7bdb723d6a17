"""Systems of FMUs as other tools export them, beside other masters, the bare calls and, of Model Exchange, one alone.

The FMUs are made here, of C: motors with hundreds of variables, outputs that follow inputs at once, and messages after
every step (fmus/exported.c, by the equations of tests/fixtures/modelica/DcMotor.mo); oscillators for Model Exchange;
two FMUs with thousands of signals.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....system.file.reader import load_system
from ....system.model import System
from ..fmus.exchange import exchange_fmu, oscillator
from ..fmus.native import SOURCES, description2, native_fmu, ring
from ..fmus.systems import Case
from ..peers.masters import measured, per_step, rovbrush_loop

INNER = 300  # local variables of a motor
MOTORS, OSCILLATORS, SIGNALS = 8, 10, 10_000
OUTPUTS = ("current", "speed", "heat", "v_left")


def motor(target: Path, logs: bool = False) -> Path:
    """A motor as an exported model, with its variables and, if it `logs`, a message after every step."""
    scalar = '<ScalarVariable name="{}" valueReference="{}" causality="{}" variability="continuous"{}><Real{}/>'
    names = [(name, "input", "", ' start="0"') for name in ("v", "tau_load")]
    names += [(name, "output", ' initial="calculated"', "") for name in OUTPUTS]
    inner = ("i", "w", *(f"inner[{k + 1}]" for k in range(INNER)))
    names += [(name, "local", ' initial="calculated"', "") for name in inner]
    variables = [
        f"{scalar}</ScalarVariable>".format(name, k, kind, first, start)
        for k, (name, kind, first, start) in enumerate(names)
    ]
    xml = description2(target.stem, variables, range(3, 3 + len(OUTPUTS)))
    return native_fmu(target, [SOURCES / "exported.c"], xml, 2, {"INNER": INNER, **({"LOG": 1} if logs else {})})


def motors(folder: Path, logs: bool = False, stop: str = "20 s") -> System:
    """Motors in a row: each gets the voltage that the one before it leaves, which follows its input at once."""
    fmu = motor(folder / ("talkative.fmu" if logs else "exported.fmu"), logs)
    wires = "".join(f'  "m{k}.v_left -> m{k + 1}.v",\n' for k in range(MOTORS - 1))
    tables = "".join(f'[components.m{k}]\nfmu = "{fmu.name}"\nperiod = "1 ms"\n' for k in range(MOTORS))
    return _system(folder / f"{fmu.stem}.toml", f"[\n{wires}]", f"{tables}[components.m0.inputs]\nv = 12.0\n", stop)


def oscillators(folder: Path, count: int, stop: str = "20 s") -> System:
    """Oscillators for Model Exchange in a row: each is driven by the one before it."""
    fmu = exchange_fmu(folder / "swings.fmu", oscillator(), 2)
    wires = "".join(f'  "o{k}.y -> o{k + 1}.u",\n' for k in range(count - 1))
    tables = "".join(f'[components.o{k}]\nfmu = "{fmu.name}"\nperiod = "1 ms"\n' for k in range(count))
    return _system(folder / f"swings{count}.toml", f"[\n{wires}]", tables, stop)


def _system(path: Path, wires: str, tables: str, stop: str) -> System:
    text = f'format = 2\nalgorithm = "jacobi"\nstop_time = "{stop}"\nconnections = {wires}\n{tables}'
    path.write_text(text, encoding="utf-8")
    return load_system(str(path))


def foreign_rows(folder: Path, hosts: Sequence[str], quick: bool) -> Iterator[tuple[float, dict[str, Any]]]:
    """Rows, each with the share that is done; `ratio` to the bare calls of the same system without recording.

    Raises RunError without a C compiler.
    """
    stop = "2 s" if quick else "20 s"
    wide = load_system(str(ring(folder, 2, SIGNALS // 2, stop="200 ms" if quick else "1 s")))
    cases = [
        Case(f"{MOTORS} exported motors, {INNER} variables", motors(folder, stop=stop), 300),
        Case(f"{MOTORS} that log at every step", motors(folder, True, stop), 300),
        Case(f"{SIGNALS} signals", replace(wide, algorithm="jacobi"), 5 if quick else 20),
    ]
    for k, case in enumerate(cases):
        others = [] if quick and case.system is cases[-1].system else list(hosts)  # which take minutes to wire so many
        rows = measured(case, others, quick)
        for row in with_ratios(rows):
            yield (k + 1) / (len(cases) + 1), row
    yield 1.0, _exchange_row(folder, stop, quick)


def with_ratios(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each row with what it takes in times of the bare calls, None where it failed."""
    bare = next(row["us_per_macro_step"] for row in rows if row["master"] == "calls alone")
    costs = [row["us_per_macro_step"] for row in rows]
    return [{**row, "ratio": cost and cost / bare} for row, cost in zip(rows, costs, strict=True)]


def _exchange_row(folder: Path, stop: str, quick: bool) -> dict[str, Any]:
    """A chain for Model Exchange, in times of as many of its FMUs that are alone."""
    costs: dict[int, list[float]] = {1: [], OSCILLATORS: []}
    systems = {count: replace(oscillators(folder, count, stop), record=(), bonds=()) for count in costs}
    rounds = 1 if quick else 5
    for _ in range(rounds):
        for count, system in systems.items():
            costs[count].append(per_step(system, rovbrush_loop, 1))
    one, all_of_them = (statistics.median(costs[count]) for count in (1, OSCILLATORS))
    return {
        "system": f"{OSCILLATORS} oscillators for Model Exchange", "recording": False, "runs": rounds,
        "master": "rovbrush, to as many alone", "us_per_macro_step": all_of_them,
        "ratio": all_of_them / (OSCILLATORS * one),
    }  # fmt: skip
