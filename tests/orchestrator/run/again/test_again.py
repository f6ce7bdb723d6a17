"""FMUs that stay loaded from run to run give the bits of fresh ones."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.again.again import Again, why_anew
from rovbrush.orchestrator.run.again.quick_start import why_not_quick
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.bench.runs.sweeps import SYSTEM
from rovbrush.orchestrator.studies.sweep.workers.kept import Kept
from rovbrush.orchestrator.system.assemble import assemble

POINTS: tuple[dict[str, object], ...] = (
    {"motor.R": 0.08, "battery.soc_start": 0.5},
    {"motor.R": 0.12},
    {"battery.n_series": 3, "motor.T_brush": -2.0},
    {"motor.R": 0.08, "battery.soc_start": 0.5},
)


def motor_on_battery(folder: Path, native: Path, version: str = "fmi2") -> Plan:
    path = folder / "started.toml"
    path.write_text(SYSTEM)
    return make_plan(assemble(str(path), {}, "", native / version))


def same_runs(plan: Plan, points: tuple[dict[str, object], ...]) -> None:
    with Again(plan) as again:
        for point in points:
            values = plan.system.checked(point, "test")
            fresh = simulate(replace(plan, system=plan.system.with_checked(values)))
            for table, expected in zip(again.run(values).tables, fresh.tables, strict=True):
                assert np.array_equal(table.view(np.int64), expected.view(np.int64))


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_a_run_begun_again_is_that_of_fresh_fmus_bit_for_bit(version: str, native: Path, tmp_path: Path) -> None:
    plan = motor_on_battery(tmp_path, native, version)
    assert not why_anew(plan) and not why_not_quick(plan)
    same_runs(plan, POINTS)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_a_system_that_starts_slowly_is_the_same_too(algorithm: str, native: Path) -> None:
    system = assemble("test_stand", {}, "5 ms", native / "fmi2")
    plan = make_plan(replace(system, algorithm=algorithm))
    assert not why_anew(plan)
    same_runs(plan, ({"motor.R": 0.1}, {"motor.R": 0.08}, {"motor.R": 0.1}))


def test_fmus_of_which_nobody_knows_what_a_reset_brings_back_are_loaded_anew(fmus: Path, native: Path) -> None:
    assert "no native FMU of ours" in why_anew(make_plan(assemble("test_stand", {}, "5 ms", fmus)))
    assert "events" in why_anew(make_plan(assemble("jam", {}, "5 ms", native / "fmi2")))


def test_what_goes_wrong_in_a_kept_run_is_left_to_a_fresh_one(native: Path, tmp_path: Path) -> None:
    plan, kept = motor_on_battery(tmp_path, native), Kept()
    good = plan.system.checked({"motor.R": 0.08}, "test")
    wrong = plan.system.checked({"motor.T_brush": 1e308}, "test")
    before = kept.figures("a", plan, good)
    with pytest.raises(RovbrushError), Again(plan) as again:
        again.run(wrong)
    assert kept.figures("a", plan, wrong) is None
    assert kept.figures("a", plan, good) == before and before is not None
    kept.close()
