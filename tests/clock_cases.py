"""Systems of FMUs of `clock_build` with events of all kinds, and their runs: what every place to run them must give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from helpers import Part, plan_of
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate


class Case(NamedTuple):
    """`moved`: the components that run somewhere else."""

    parts: Mapping[str, Part]
    wires: Sequence[str]
    stop: str
    moved: str


CASES = {
    "clocked control": Case({"c": ("controller", "100 ms", {"k": 6.0}), "p": ("plant", "1 ms")},
                            ["p.x -> c.y", "c.u -> p.u"], "1 s", "c"),
    "plant elsewhere": Case({"c": ("controller", "100 ms", {"k": 6.0}), "p": ("plant", "1 ms")},
                            ["p.x -> c.y", "c.u -> p.u"], "1 s", "p"),
    "early returns": Case({"ball": ("ball", "10 ms")}, [], "2 s", "ball"),
    "time events": Case({"s": ("square", "100 ms")}, [], "2 s", "s"),
    "countdown": Case({"c": ("countdown", "1 s", {"limit": 12})}, [], "3 s", "c"),
    "output clock": Case({"a": ("producer", "100 ms"), "b": ("consumer", "250 ms")},
                         ["a.crossing -> b.sample", "a.count -> b.v"], "5 s", "a"),
    "triggered": Case({"a": ("producer", "100 ms"), "b": ("consumer", "250 ms")},
                      ["a.crossing -> b.sample", "a.count -> b.v"], "5 s", "b"),
    "both": Case({"a": ("producer", "100 ms"), "b": ("consumer", "250 ms")},
                 ["a.crossing -> b.sample", "a.count -> b.v"], "5 s", "ab"),
    "armed": Case({"a": ("producer", "100 ms", {"f": 2.0}), "c": ("countdown", "1 s", {"first": 0})},
                  ["a.crossing -> c.arm"], "2 s", "c"),
}  # fmt: skip
SCHEDULED = {
    "partitions": Case({"a": ("partitions", "100 ms", {"=u": 1.0}), "b": ("consumer", "1 s")},
                       ["a.alarm -> b.sample", "a.n_burst -> b.v"], "1 s", "a"),
    "partitions and plant": Case({"a": ("partitions", "10 ms", {}), "p": ("plant", "1 ms")},
                                 ["p.x -> a.u", "a.y -> p.u"], "500 ms", "ap"),
}  # fmt: skip


def plan_for(case: Case, folder: Path, fmus: Path, **of: Any) -> Plan:
    """The plan of a case; keywords are keys of the components that are moved."""
    return plan_of(folder, fmus, case.parts, case.wires, stop=case.stop, of=dict.fromkeys(case.moved, of))


def run_case(case: Case, folder: Path, fmus: Path, **of: Any) -> Run:
    """The run of a case; keywords are keys of the components that are moved."""
    keys = dict.fromkeys(case.moved, of) if of else None
    return simulate(plan_of(folder, fmus, case.parts, case.wires, stop=case.stop, of=keys))


def same(a: Run, b: Run) -> bool:
    """Whether two runs have the same bits in all rows and at all events."""
    rows = [[(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events] for run in (a, b)]
    return same_tables(a, b) and rows[0] == rows[1] and bool(rows[0])


def same_tables(a: Run, b: Run) -> bool:
    """Whether two runs have the same bits in all rows."""
    return all(x.tobytes() == y.tobytes() for x, y in zip(a.tables, b.tables, strict=True))
