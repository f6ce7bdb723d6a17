"""The compiled loop and the interpreter are one source and give the same bits."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import column, plan_of
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate

LOOP = {
    "w": ("wave", "1 ms", {"c0": 0.3, "a": 2.0, "w": 90.0}),
    "slow": ("integrator", "5 ms", {"x_start": 1.0}),
    "mid": ("gain", "3 ms", {"k": -1.7, "offset": 0.01}),
    "fast": ("integrator", "1 ms", {"x_start": -0.5}),
}
WIRES = ["mid.y -> slow.u{0}", "slow.x -> fast.u{1}", "fast.x -> mid.u{2}"]
QUARTER_CAR = ({"w": ("wheel", "1 ms"), "c": ("chassis", "5 ms")}, ["c.v_c -> w.v_c", "w.F -> c.F"])


def equal(a: Run, b: Run) -> bool:
    same = [x.tobytes() == y.tobytes() for x, y in zip(a.tables, b.tables, strict=True)]
    return all(same) and (a.failure, a.end) == (b.failure, b.end)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(
    "transfers", [("", "", ""), (" (hold)",) * 3, (" (linear)",) * 3, (" (mean)", " (linear)", " (mean)")]
)
def test_compiled_loop_and_interpreter_agree_bitwise(
    algorithm: str, transfers: tuple[str, ...], tmp_path: Path, fmus: Path
) -> None:
    wires = [wire.format(*transfers) for wire in WIRES]
    plan = plan_of(tmp_path, fmus, LOOP, wires, stop="300 ms", algorithm=algorithm)
    compiled, interpreted = simulate(plan), simulate(plan, interpreted=True)
    assert equal(compiled, interpreted) and not compiled.failure
    assert all(np.ptp(column(compiled, f"{name}.x")[1]) > 1e-3 for name in ("slow", "fast"))


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_they_agree_on_the_quarter_car(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, *QUARTER_CAR, stop="200 ms", algorithm=algorithm)
    assert equal(simulate(plan), simulate(plan, interpreted=True))


@pytest.mark.parametrize("values", [{"raise_at": 0.0149}, {"nan_at": 0.0149}])
def test_they_stop_at_the_same_fault(values: dict[str, float], tmp_path: Path, fmus: Path) -> None:
    parts = {**LOOP, "bad": ("faulty", "5 ms", values)}
    plan = plan_of(tmp_path, fmus, parts, [wire.format("", "", "") for wire in WIRES], stop="300 ms")
    runs = [simulate(plan, interpreted) for interpreted in (False, True)]
    assert [run.end for run in runs] == [0.014, 0.014]
    assert [table.tobytes() for table in runs[0].tables] == [table.tobytes() for table in runs[1].tables]


def test_a_run_can_be_repeated_in_one_process(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, *QUARTER_CAR, stop="200 ms")
    assert equal(simulate(plan), simulate(plan))


def test_every_table_starts_at_zero_and_ends_at_the_stop(tmp_path: Path, fmus: Path) -> None:
    for stop in ("165 ms", "15 ms"):
        run = simulate(plan_of(tmp_path, fmus, LOOP, [wire.format("", "", "") for wire in WIRES], stop=stop))
        for name in ("slow.x", "mid.y", "fast.x"):
            t, values = column(run, name)
            assert t[0] == 0.0 and t[-1] == float(stop.split()[0]) / 1e3
            assert np.all(np.isfinite(values))
    parts = {"a": ("wave", "20 ms", {"c1": 1.0}), "b": ("integrator", "50 ms")}
    run = simulate(
        plan_of(tmp_path, fmus, {**parts, "c": ("wave", "30 ms", {"c1": 1.0})}, ["a.y -> b.u"], stop="600 ms")
    )
    assert [len(table) for table in run.tables] == [31, 21, 13]


def test_progress_reports_rising_times_up_to_the_stop(tmp_path: Path, fmus: Path) -> None:
    seen: list[float] = []
    simulate(plan_of(tmp_path, fmus, *QUARTER_CAR, stop="4 s"), progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 4.0
