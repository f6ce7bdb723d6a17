"""A run that fails in its first step has its row of time 0, whatever the algorithm, and every product of it."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import pytest
from helpers import plan_of
from rovbrush.orchestrator.results.files.writing import write_results
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.run.simulation import simulate

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
ALGORITHMS: dict[str, dict[str, Any]] = {
    "jacobi": {},
    "gauss-seidel": {},
    "iterated": {"iteration": {"inputs": "end"}},
    "ecco": {"bonds": [BOND]},
    "adaptive": {},
}


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_failure_in_the_first_step_leaves_the_row_of_time_0(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms"), "f": ("faulty", "2 ms", {"raise_at": 0.0})}
    run = simulate(plan_of(tmp_path, fmus, parts, WIRES, stop="1 s", algorithm=algorithm, **ALGORITHMS[algorithm]))
    assert "component f" in run.failure and "in the step to t = 0.002 s" in run.failure
    assert run.end == 0.0 and [len(table) for table in run.tables] == [1]
    summary = summarize(run)
    assert summary["complete"] is False and summary["macro_steps"] == 0
    json.dumps(summary, allow_nan=False)
    write_results(run, tmp_path, summary)
    with (tmp_path / "result.csv").open(encoding="utf-8") as file:
        assert len(list(csv.reader(file))) == 2
