"""A quarter car by every algorithm, for tests of runs in pieces."""

from __future__ import annotations

from pathlib import Path

from helpers import Part, plan_of
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.tables import Run

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
ECCO = {"tolerance": 0.01, "relative": 0.01, "minimum": "50 us", "maximum": "20 ms"}
ALGORITHMS = {
    "jacobi": {},
    "gauss-seidel": {},
    "iterated": {"iteration": {"method": "aitken"}},
    "iterated to the end": {"iteration": {"inputs": "end", "sweep": "gauss-seidel"}},
    "ecco": {"bonds": [BOND], "ecco": ECCO},
    "adaptive": {"adaptive": {"tolerance": 0.005}},
}


def car(tmp_path: Path, fmus: Path, algorithm: str, stop: str = "300 ms") -> Plan:
    """A quarter car that is to be run by an algorithm of them."""
    periods = ("2 ms", "2 ms") if algorithm in ("ecco", "adaptive") else ("1 ms", "3 ms")
    parts: dict[str, Part] = {"w": ("wheel", periods[0]), "c": ("chassis", periods[1])}
    return plan_of(tmp_path, fmus, parts, WIRES, stop=stop, algorithm=algorithm.split()[0], **ALGORITHMS[algorithm])


def same(a: Run, b: Run) -> bool:
    """Whether two runs have the same bits in all rows."""
    return [t.tobytes() for t in a.tables] == [t.tobytes() for t in b.tables] and a.end == b.end
