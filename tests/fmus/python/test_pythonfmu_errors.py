"""What goes wrong inside an FMU made with pythonfmu arrives with its text, and the process lives."""

from __future__ import annotations

from math import inf, nan
from pathlib import Path

import numpy as np
import pytest
from helpers import last, plan_of, run_of
from pythonfmu_instance import started
from rovbrush.components.python.component import component_class
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.run.simulation import simulate


def test_an_exception_in_a_step_names_component_time_and_traceback_and_the_process_lives(
    tmp_path: Path, fmus: Path
) -> None:
    parts = {"good": ("integrator", "1 ms", {"=u": 1.0}), "bad": ("faulty", "5 ms", {"raise_at": 0.0149})}
    run = simulate(plan_of(tmp_path, fmus, parts))
    for expected in ("component bad", "t = 0.015 s", "Traceback", "gave up", "do_step at t = 0.01 s"):
        assert expected in run.failure
    assert [len(table) for table in run.tables] == [15, 3]  # rows until the last instant that all reached
    healthy = run_of(tmp_path, fmus, {**parts, "bad": ("faulty", "5 ms")})
    assert last(healthy, "good.x") == pytest.approx(1.0)


def test_percent_signs_in_messages_arrive_as_they_are(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "5 ms", {"raise_at": 0.02})}))
    assert "gave up: 100 % of %s%n broke" in run.failure


def test_an_exception_at_the_start_arrives_with_its_text(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(FmuError) as error:
        simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "5 ms", {"fail_at_start": True})}))
    for expected in ("component bad", "no start: 100 % of %s", "Traceback"):
        assert expected in str(error.value)
    run_of(tmp_path, fmus, {"bad": ("faulty", "5 ms")})


def test_a_parameter_out_of_range_is_refused_by_the_fmu_itself(fmus: Path) -> None:
    with (
        pytest.raises(FmuError, match=r"k = 1000000000.0 is out of range: -1e\+06 to 1e\+06 are allowed"),
        started(fmus / "gain.fmu", k=1e9),
    ):
        pass


def test_not_a_number_is_caught_with_component_variable_and_time(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "10 ms", {"nan_at": 0.0299})}))
    for expected in ("component bad", "output fragile", "nan", "t = 0.03 s"):
        assert expected in run.failure
    assert len(run.tables[0]) == 3 and np.all(np.isfinite(run.tables[0]))


def test_not_a_number_at_time_zero_is_refused(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(FmuError, match=r"component bad: output fragile is nan at time 0"):
        simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "10 ms", {"nan_at": 0.0})}))


@pytest.mark.parametrize(("mode", "status"), [(1, "Fatal"), (2, "Discard")])
def test_a_plain_pythonfmu_failure_leaves_the_process_alive(mode: int, status: str, tmp_path: Path, fmus: Path) -> None:
    inputs = {"=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    run = simulate(plan_of(tmp_path, fmus, {"p": ("plain", "1 ms", {"mode": mode, **inputs})}))
    if mode == 1:
        assert f"component p returned fmi2{status} in the step to t = 0.006 s" in run.failure
    else:  # pythonfmu says fmi2Terminated of a step that returns False
        assert not run.failure and "component p asked to end" in run.ended
    assert len(run.tables[0]) == 6
    assert mode != 1 or "100 % of %s%n gone" in run.failure
    assert last(run_of(tmp_path, fmus, {"p": ("plain", "1 ms", inputs)}), "p.y") == 1.0


@pytest.mark.parametrize(("time", "step"), [(0.0, 0.0), (0.0, -1e-3), (0.0, nan), (0.0, inf), (nan, 1e-3), (inf, 1e-3)])
def test_a_step_that_is_none_is_refused_and_leaves_all_as_it_was(time: float, step: float) -> None:
    motor = component_class("dc_motor")(instance_name="motor")
    motor.set_real([motor.memory.index["V_in"]], [12.0])
    motor.enter_initialization_mode()
    motor.exit_initialization_mode()
    before = motor.memory.values.tolist()
    assert not motor.do_step(time, step) and motor.memory.values.tolist() == before
    assert motor.do_step(0.0, 1e-3) and motor.memory.values.tolist() != before
