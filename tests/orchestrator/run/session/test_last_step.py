"""A stop that is no multiple of a period: the last step is shorter and ends there, and all else stays what it is."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import quarter_car
from car_runs import ALGORITHMS, BOND, ECCO, WIRES, car
from helpers import Part, edited, plan_of, rovbrush
from native_build import moody, needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate

Rates = tuple[str, str]
RATES = [("3 ms", "5 ms"), ("5 ms", "3 ms"), ("2 ms", "2 ms"), ("2 ms", "6 ms"), ("6 ms", "2 ms")]
STOPS = ["53.5 ms", "46 ms", "1 ms", "7.5 ms", "32.25 ms"]
FIXED_ONLY = {'canHandleVariableCommunicationStepSize="true"': 'canHandleVariableCommunicationStepSize="false"'}
FIXED = {**FIXED_ONLY, ' stepSize="0.001"': ""}


def line(
    tmp_path: Path, fmus: Path, rates: Rates, stop: str, transfer: str = "", start: str = "0 s", **keys: object
) -> Plan:
    """A signal that is straight (with `c2` a parabola) into an integrator."""
    wave = {"c1": 2.0, "c2": 30.0 if transfer == "quadratic" else 0.0}
    parts: dict[str, Part] = {"w": ("wave", rates[0], wave), "i": ("integrator", rates[1])}
    wire = f"w.y -> i.u ({transfer})" if transfer else "w.y -> i.u"
    return plan_of(tmp_path, fmus, parts, [wire], stop=stop, start_time=start, **keys)


def exact(t: np.ndarray, c2: float = 0.0) -> np.ndarray:
    return t**2 + c2 * t**3 / 3


def seconds(text: str) -> float:
    return float(Fraction(text.removesuffix(" ms")) / 1000)


@pytest.mark.sampled(30)
@pytest.mark.parametrize("stop", STOPS)
@pytest.mark.parametrize("rates", RATES)
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi", "iterated"])
def test_the_rows_of_every_rate_end_at_the_stop(
    algorithm: str, rates: Rates, stop: str, tmp_path: Path, fmus: Path
) -> None:
    plan = line(tmp_path, fmus, rates, stop, algorithm=algorithm)
    runs = [simulate(plan, interpreted) for interpreted in (False, True)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]
    run, signals = runs[0], Signals(runs[0])
    assert not run.failure and run.end == seconds(stop)
    for name, rate in (("w.y", rates[0]), ("i.x", rates[1])):
        end, h = (Fraction(text.removesuffix(" ms")) / 1000 for text in (stop, rate))
        regular = [float(k * h) for k in range(int(end / h) + 1)]
        assert signals[name].time.tolist() == [*regular, *([float(end)] if end % h else [])]
    assert signals["w.y"].values[-1] == pytest.approx(2.0 * run.end, rel=1e-14)


@pytest.mark.sampled(100)
@pytest.mark.parametrize("start", ["0 s", "-1/3 s"])
@pytest.mark.parametrize("stop", STOPS)
@pytest.mark.parametrize("rates", RATES)
@pytest.mark.parametrize(
    ("algorithm", "transfer"),
    [
        ("gauss-seidel", "linear"), ("jacobi", "linear"), ("gauss-seidel", "mean"), ("jacobi", "mean"),
        ("gauss-seidel", "quadratic"), ("jacobi", "quadratic"), ("jacobi", "interpolate"), ("iterated", ""),
    ],
)  # fmt: skip
def test_a_transfer_is_as_exact_in_a_shorter_step(
    algorithm: str, transfer: str, rates: Rates, stop: str, start: str, tmp_path: Path, fmus: Path
) -> None:
    """What is straight (a parabola for `quadratic`) is integrated exactly over the last step, however short."""
    fast, slow = (float(rate.split()[0]) for rate in rates)
    if (transfer == "mean" and fast > slow) or (transfer == "interpolate" and fast < slow):
        pytest.skip("there is no such transfer")
    begin = Fraction(start.split()[0])
    end = f"{begin + Fraction(stop.split()[0]) / 1000} s"
    signals = Signals(simulate(line(tmp_path, fmus, rates, end, transfer, start, algorithm=algorithm)))
    t, x = signals["i.x"].time, signals["i.x"].values
    wanted = exact(t, 30.0 if transfer == "quadratic" else 0.0)
    settled = 3 if transfer in ("linear", "quadratic") else 1  # before, there are no earlier samples
    if len(t) > settled + fast / slow * (settled > 1):
        assert x[-1] - x[-2] == pytest.approx(wanted[-1] - wanted[-2], rel=1e-9, abs=1e-14)
    if transfer in ("mean", "") or algorithm == "iterated":
        assert x[-1] == pytest.approx(wanted[-1] - wanted[0], rel=1e-11, abs=1e-15), "no impulse is made or lost"


def test_a_mean_of_a_source_that_steps_later_loses_nothing(tmp_path: Path, fmus: Path) -> None:
    """What one mean extrapolates is taken back from the next, which is shorter."""
    for stop in STOPS:
        plan = line(tmp_path, fmus, ("2 ms", "2 ms"), stop, "mean", order=["i", "w"])
        signals = Signals(simulate(plan))
        first = 0.002 if seconds(stop) > 0.002 else seconds(stop)  # of which there is no earlier sample at all
        lost = exact(np.array([first]))[0] if len(signals["i.x"].time) == 2 else 0.0
        assert signals["i.x"].values[-1] == pytest.approx(exact(signals["i.x"].time)[-1] - lost, rel=1e-9, abs=1e-12)


def bits(run: Run, names: list[str]) -> list[bytes]:
    return [Signals(run)[name].values.tobytes() for name in names]


def test_a_shorter_step_is_that_of_an_algorithm_whose_steps_vary(tmp_path: Path, fmus: Path) -> None:
    """ECCO that is kept at its largest step makes Jacobi steps, and ends at any stop: signals, works and energies."""
    parts: dict[str, Part] = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
    keys = {"bonds": [BOND], "ecco": {**ECCO, "tolerance": 1e9, "maximum": "2 ms"}}
    runs = [
        simulate(plan_of(tmp_path, fmus, parts, WIRES, stop="301.25 ms", algorithm=algorithm, **keys))
        for algorithm in ("jacobi", "ecco")
    ]
    names = [name for name in Signals(runs[0]).places]
    assert {"coupling.strut_made", "coupling.strut_total", "w.F", "c.v_c"} <= set(names)
    assert bits(runs[0], names) == bits(runs[1], names)
    assert Signals(runs[0])["w.F"].time.tobytes() == Signals(runs[1])["w.F"].time.tobytes()


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("stop", ["301 ms", "2.5 ms", "302.3 ms"])
def test_every_algorithm_ends_there_with_an_error_as_in_whole_steps(
    algorithm: str, stop: str, tmp_path: Path, fmus: Path
) -> None:
    plan = car(tmp_path, fmus, algorithm, stop)
    run = simulate(plan)
    assert not run.failure and run.end == seconds(stop)
    signals, longer = Signals(run), Signals(simulate(make_plan(replace(plan.system, stop=Fraction(306, 1000)))))
    for name, state in (("w.z_w", "z_w"), ("c.z_c", "z_c")):
        usual = np.max(np.abs(longer[name].values - quarter_car.exact(longer[name].time)[state]))
        assert abs(signals[name].values[-1] - quarter_car.exact(np.array([run.end]))[state][0]) <= usual
    if algorithm.startswith("iterated"):
        assert signals["coupling.residual"].values[-1] <= 1e-8
        assert signals["coupling.iterations"].values[-1] >= 1.0
        assert len(signals["coupling.iterations"].values) == 1 + int(np.ceil(seconds(stop) / 0.003))


@pytest.mark.parametrize("sweep", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize("inputs", ["mean", "end"])
@pytest.mark.parametrize("rates", [("1 ms", "3 ms"), ("3 ms", "1 ms"), ("2 ms", "3 ms")])
def test_iterated_by_newton_and_by_aitken_agree_in_the_last_step(
    rates: Rates, inputs: str, sweep: str, tmp_path: Path, fmus: Path
) -> None:
    parts: dict[str, Part] = {"w": ("wheel", rates[0]), "c": ("chassis", rates[1])}
    found = []
    for method in ("newton", "aitken"):
        settings = {"method": method, "inputs": inputs, "sweep": sweep, "tolerance": 1e-12}
        plan = plan_of(tmp_path, fmus, parts, WIRES, stop="43.7 ms", algorithm="iterated", iteration=settings)
        run = simulate(plan)
        assert not run.failure
        found.append(np.concatenate([table[-1] for table in run.tables])[:3])
        assert "iterations of the last step" in explain(plan, None)
    assert found[0] == pytest.approx(found[1], rel=1e-8)


@needs_gcc
@pytest.mark.parametrize(
    ("start", "stop", "period"), [("0 s", "1 s", "0.3 s"), ("-0.1 s", "0.6 s", "0.15 s"), ("2 s", "2.05 s", "1/60 s")]
)
@pytest.mark.parametrize("algorithm", ["jacobi", "iterated"])
def test_the_fmu_is_told_steps_that_end_at_the_stop_and_never_behind(
    algorithm: str, start: str, stop: str, period: str, tmp_path: Path
) -> None:
    moody(
        tmp_path / "m.fmu", ON_STEP="if (t + h > m->promised) return fmi2Error; m->x = t + h; m->y = h; return fmi2OK"
    )
    for interpreted in (False, True):
        parts: dict[str, Part] = {"m": ("m", period, {"=u": 1.0})}
        plan = plan_of(tmp_path, tmp_path, parts, stop=stop, start_time=start, algorithm=algorithm)
        signals = Signals(simulate(plan, interpreted))
        begin, end, h = (Fraction(text.split()[0]) for text in (start, stop, period))
        assert signals["m.x"].values[-1] == pytest.approx(float(end), abs=1e-15)
        assert signals["m.y"].values[-1] == pytest.approx(float((end - begin) % h or h), rel=1e-12)


def test_who_makes_a_shorter_step_is_said(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    plan = line(tmp_path, fmus, ("2 ms", "5 ms"), "11 ms")
    text = explain(plan, None)
    assert "the last step of w, i is a shorter one of 1 ms, which ends at the stop" in text
    assert ", in the last 1 ms)" in text and "i from 0 s by 1 ms" in text
    assert "shorter" not in explain(line(tmp_path, fmus, ("2 ms", "5 ms"), "10 ms"))
    case = tmp_path / "case.toml"
    assert rovbrush(monkeypatch, "run", case, "--stop", "11 ms", "--fmus", fmus, "--out", tmp_path / "out") == 0
    assert "the last step of w, i is a shorter one of 1 ms" in " ".join(capsys.readouterr().out.split())
    assert (tmp_path / "out" / "result.csv").read_text().splitlines()[-1].startswith("0.011,")


def test_an_fmu_of_fixed_steps_names_the_stops_that_suit_it(tmp_path: Path, fmus: Path) -> None:
    edited(fmus / "integrator.fmu", tmp_path / "fixed.fmu", {}, FIXED)
    edited(fmus / "wave.fmu", tmp_path / "wave.fmu", {})
    parts: dict[str, Part] = {"w": ("wave", "3 ms"), "i": ("fixed", "5 ms")}
    said = (
        r"component i: period 5 ms does not divide the stop time 12 ms, and fixed\.fmu cannot make a shorter last step "
        r".*; stop at 10 ms or 15 ms"
    )
    with pytest.raises(InputError, match=said):
        plan_of(tmp_path, tmp_path, parts, ["w.y -> i.u"], stop="12 ms")
    run = simulate(plan_of(tmp_path, tmp_path, parts, ["w.y -> i.u"], stop="10 ms"))
    assert not run.failure and Signals(run)["w.y"].time.tolist() == [0.0, 0.003, 0.006, 0.009, 0.01]
    with pytest.raises(InputError, match=r"the time from 1 s to 1\.012 s, .* stop at 1\.01 s or 1\.015 s"):
        plan_of(tmp_path, tmp_path, parts, ["w.y -> i.u"], stop="1.012 s", start_time="1 s")


def test_figures_of_merit_weigh_the_last_step_by_its_length(tmp_path: Path, fmus: Path) -> None:
    plan = line(
        tmp_path, fmus, ("4 ms", "4 ms"), "10 ms",
        summary={"window": {}, "m": "mean w.y", "r": "rms w.y", "p": "positive w.y", "f": "frequency w.y"},
    )  # fmt: skip
    found = summarize(simulate(plan))
    assert found["m"] == pytest.approx(0.01) and found["p"] == pytest.approx(0.01)
    assert found["macro_steps"] == 3 and found["simulated_s"] == 0.01


@needs_gcc
@pytest.mark.parametrize(("fixed", "end"), [(False, 2.0), (True, 2.2)])
def test_an_fmu_alone_ends_where_its_experiment_does_if_it_can(fixed: bool, end: float, tmp_path: Path) -> None:
    moody(tmp_path / "their.fmu")
    experiment = 'startTime="1" stopTime="2" stepSize="0.3" tolerance="1e-6"'
    changes = {'tolerance="1e-6"': experiment, **(FIXED_ONLY if fixed else {})}
    result = load(edited(tmp_path / "their.fmu", tmp_path / "m.fmu", {}, changes)).run()
    assert result.run.end == end and result["m.x"]["time"].values[0] == 1.0


def test_a_run_of_whole_steps_has_no_operation_more(tmp_path: Path, fmus: Path) -> None:
    for algorithm in ALGORITHMS:
        plan = car(tmp_path, fmus, algorithm)
        assert len(plan.last) == 0 and plan.clock.rest == 0 and not plan.short_steps()
