"""Macro steps whose length follows from the energy that the coupling makes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import Measured, column, edited, plan_of, read_system, run_of
from quarter_car import exact
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.files.writing import write_results
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
ECCO = {"tolerance": 0.01, "relative": 0.01, "minimum": "50 us", "maximum": "20 ms"}


def car(
    tmp_path: Path, fmus: Path, period: str = "2 ms", algorithm: str = "ecco", stop: str = "4 s", **keys: Any
) -> Run:
    parts = {"w": ("wheel", period), "c": ("chassis", period)}
    return run_of(tmp_path, fmus, parts, WIRES, stop=stop, algorithm=algorithm, **{"bonds": [BOND], **keys})


def worst_z_w(run: Run) -> float:
    times, z_w = column(run, "w.z_w")
    return float(np.max(np.abs(z_w - exact(times)["z_w"])))


def test_no_more_steps_than_fixed_ones_and_at_most_six_tenths_of_their_error(
    tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    fixed, adaptive = car(tmp_path, fmus, algorithm="jacobi"), car(tmp_path, fmus, ecco=ECCO)
    steps = len(adaptive.tables[0]) - 1
    measured("quarter car, ECCO: macro steps", steps, "2000, those of 2 ms")
    measured("quarter car, ECCO: error of z_w against that of 2 ms", worst_z_w(adaptive) / worst_z_w(fixed), "0.6")
    assert steps <= 2000
    assert worst_z_w(adaptive) <= 0.6 * worst_z_w(fixed)


@pytest.mark.parametrize("stop", ["4 s", "1/3 s", "123.4567 ms", "1 ms"])
def test_times_are_exact_and_the_last_is_the_stop(stop: str, tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, ecco=ECCO, stop=stop)
    times, step = column(run, "coupling.step")
    assert times[0] == 0.0 and times[-1] == float(run.plan.system.stop) == run.end
    np.testing.assert_allclose(np.diff(times), step[1:], rtol=1e-9)
    assert run.ticks[0][-1] == run.plan.clock.stop


@pytest.mark.parametrize("stop", ["4 s", "34 ms", "34.9 ms", "100.1 ms"])
def test_steps_stay_between_their_limits(stop: str, tmp_path: Path, fmus: Path) -> None:
    """The last two too: what is left before the stop is shared between them where it is more than the largest step."""
    run = car(tmp_path, fmus, ecco={**ECCO, "minimum": "0.5 ms", "maximum": "3 ms", "tolerance": 10.0}, stop=stop)
    step = column(run, "coupling.step")[1][1:]
    assert np.min(step) >= 0.5e-3 and np.max(step) <= 3e-3
    assert run.end == float(run.plan.system.stop)


def test_steps_vary(tmp_path: Path, fmus: Path) -> None:
    step = column(car(tmp_path, fmus, ecco={**ECCO, "minimum": "0.5 ms", "maximum": "3 ms"}), "coupling.step")[1][1:]
    assert np.ptp(step) > 2e-3


def test_a_smaller_tolerance_takes_more_steps_and_errs_less(tmp_path: Path, fmus: Path) -> None:
    runs = [car(tmp_path, fmus, "0.2 ms", ecco={**ECCO, "tolerance": t, "relative": t}) for t in (0.1, 0.01, 0.001)]
    steps, errors = [len(run.tables[0]) for run in runs], [worst_z_w(run) for run in runs]
    assert steps == sorted(steps) and errors == sorted(errors, reverse=True)


def test_compiled_loop_and_interpreter_agree_bitwise(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(
        tmp_path, fmus, {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}, WIRES,
        stop="300 ms", algorithm="ecco", bonds=[BOND], ecco=ECCO,
    )  # fmt: skip
    compiled, interpreted = simulate(plan), simulate(plan, interpreted=True)
    assert compiled.tables[0].tobytes() == interpreted.tables[0].tobytes()


def test_the_books_hold_with_varying_steps(tmp_path: Path, fmus: Path) -> None:
    """What the trapezoidal books say lies near what exact counters say: both of one run."""
    exactly = {**BOND, "name": "counted", "impulse": "w.J", "displacement": "c.z_c"}
    run = car(tmp_path, fmus, ecco=ECCO, bonds=[BOND, exactly])
    sides = [column(run, f"coupling.{name}_flow_side")[1] for name in ("strut", "counted")]
    np.testing.assert_allclose(sides[0], sides[1], atol=1e-9)  # the chassis moves with constant acceleration
    assert column(run, "coupling.strut_made")[1][1:].sum() == pytest.approx(column(run, "coupling.strut_total")[1][-1])


def test_results_have_their_own_times(tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, ecco=ECCO, stop="100 ms")
    write_results(run, tmp_path, summarize(run))
    table = xarray.open_dataset(tmp_path / "result.nc", group="varying_steps", engine="h5netcdf")
    assert table.attrs["period"] == "varies" and np.array_equal(table["time"], column(run, "w.F")[0])
    assert len((tmp_path / "result.csv").read_text().splitlines()) == len(run.tables[0]) + 1


def test_the_plan_explains_the_steps(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
    text = explain(plan_of(tmp_path, fmus, parts, WIRES, algorithm="ecco", bonds=[BOND]))
    for words in (
        "the first step is 2 ms",
        "every macro step again",
        "step        w by the macro step",
        "gauge",
        "control",
    ):
        assert words in text


def test_an_fmu_whose_steps_may_not_vary_is_refused_by_name_and_flag(tmp_path: Path, fmus: Path) -> None:
    flag = "canHandleVariableCommunicationStepSize"
    stiff = edited(fmus / "wheel.fmu", tmp_path / "stiff.fmu", {}, {f'{flag}="true"': f'{flag}="false"'})
    parts = {"w": (str(stiff), "2 ms"), "c": ("chassis", "2 ms")}
    with pytest.raises(InputError, match=rf"component w: algorithm 'ecco' needs steps .*stiff\.fmu.*{flag} = false"):
        plan_of(tmp_path, fmus, parts, WIRES, algorithm="ecco", bonds=[BOND])


@pytest.mark.parametrize(
    ("periods", "keys", "message"),
    [
        (("2 ms", "2 ms"), {"bonds": []}, "judges the energy made at power bonds; declare one"),
        (("2 ms", "1 ms"), {}, "steps all components together.*w 2 ms, c 1 ms"),
        (("2 ms", "2 ms"), {"ecco": {"minimum": "3 ms"}}, "period 2 ms is the first step and must be between"),
        (("2 ms", "2 ms"), {"ecco": {"minimum": "x"}}, "ecco: minimum = 'x' is not a time"),
        (("2 ms", "2 ms"), {"ecco": {"grow": 0.5}}, "grow = 0.5 above"),
        (("2 ms", "2 ms"), {"ecco": {"tolerances": 0.5}}, "unknown key 'tolerances'; did you mean 'tolerance'"),
    ],
)
def test_what_cannot_be_is_refused(
    periods: tuple[str, str], keys: dict[str, Any], message: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"w": ("wheel", periods[0]), "c": ("chassis", periods[1])}
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, WIRES, algorithm="ecco", **{"bonds": [BOND], **keys})


def test_a_boundary_cannot_be_recorded_where_steps_vary(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
    read_system(tmp_path, fmus, parts, WIRES, algorithm="ecco", bonds=[BOND])
    with pytest.raises(InputError, match="--record-boundary needs steps of one length"):
        planned(assemble(str(tmp_path / "case.toml"), {}, fmus=fmus, boundaries=("w",)), ("w",))
