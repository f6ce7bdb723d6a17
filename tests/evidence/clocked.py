"""Clocks tick at exact rational times however long a run is; the last case is clocked control of 10 000 s.

A controller at the ticks of its clock and a plant that is stepped at another rate are the recursion x(i + 1) =
x(i) + k T (1 - x(i)), with a clock that need not be a multiple of any step.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
from clock_build import clocked
from helpers import column, run_of
from rovbrush.orchestrator.fmu.types import decode

from . import seeded

NAME = "clocked"
CLAIM = "a clock of any rational period ticks at its whole multiples, and its controller is the recursion, for 10 000 s"
COUNT = 60
UNIT = "runs"
LIMIT = 3600.0  # s
SAMPLE = 2

LONG = Fraction(10_000), Fraction(1, 60), Fraction(1, 1000)  # s: a run, its clock, the steps of its plant


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    clock = Fraction(random.randint(1, 9), random.randint(20, 700))
    span, clock, step = LONG if index == COUNT - 1 else (200 * clock, clock, Fraction(random.choice((1, 2, 5)), 1000))
    clocked(folder / "controller.fmu", "controller", period=f"{clock.numerator}/{clock.denominator}")
    clocked(folder / "plant.fmu", "plant")
    k = float(Fraction(1, 10) / clock)
    parts = {"c": ("controller", f"{clock} s", {"k": k}), "p": ("plant", f"{step} s")}
    run = run_of(folder, folder, parts, ["p.x -> c.y", "c.u -> p.u"], stop=f"{span} s", record=["c.*"])
    count = span // clock
    exact = [float(i * clock) for i in range(count + 1)]
    told = [row.time for row in run.events if "c.tick ticks" in row.what]
    if told != exact:
        return f"{len(told)} ticks of {len(exact)}, the first that differs: {_first(told, exact)}"
    times, at = column(run, "c.at")
    late = np.abs(at - times) > np.spacing(np.maximum(times, 1e-3))
    if late.any():
        return f"at t = {times[late][0]!r} the FMU was told {at[late][0]!r}"
    kind = run.plan.system.components["c"].fmu.type_of("ticks")
    assert kind is not None
    ticks = decode(kind, column(run, "c.ticks")[1])
    if ticks.tolist() != list(range(1, count + 2)):
        return f"{ticks[-1]} ticks in the FMU, {count + 1} expected"
    u = column(run, "c.u")[1]
    wrong = np.abs(u / k - 0.9 ** np.arange(count + 1)).max()
    return "" if wrong < 1e-9 else f"the controller differs from the recursion by {wrong:.3g}"


def _first(told: list[float], exact: list[float]) -> str:
    pairs = zip(told, exact, strict=False)
    return next((f"{a!r} for {b!r}" for a, b in pairs if a != b), "none, some are missing")
