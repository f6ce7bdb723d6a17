"""FMI 1.0, 2.0 and 3.0 begin where the run does and end at its stop, with a shorter last step where it must be."""

from __future__ import annotations

from pathlib import Path

import pytest
from first_fmi import first_fmu
from helpers import Part, plan_of
from native_build import FREE2, FREE3, feedthrough2, feedthrough3, needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc


@pytest.mark.sampled(2)
@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_three_versions_side_by_side_end_at_the_stop(algorithm: str, isolation: str, tmp_path: Path) -> None:
    feedthrough2(tmp_path / "feedthrough2.fmu")
    feedthrough3(tmp_path / "feedthrough3.fmu", BEGIN=-0.1)
    first_fmu(tmp_path / "first.fmu")
    parts: dict[str, Part] = {
        "a": ("first", "2 ms", {"=u": 1.5}), "b": ("feedthrough2", "3 ms", {**FREE2, "=u": 1.5}),
        "c": ("feedthrough3", "2 ms", {name: value for name, value in FREE3.items() if name != "=Float64_in"}),
    }  # fmt: skip
    of = {name: {"isolation": isolation} for name in parts}
    plan = plan_of(
        tmp_path, tmp_path, parts, ["a.x -> c.Float64_in"], stop="11/1000 s", start_time="-0.1 s",
        algorithm=algorithm, of=of,
    )  # fmt: skip
    for interpreted in (False, True):
        run = simulate(plan, interpreted)
        signals = Signals(run)
        assert not run.failure and run.end == 0.011
        for name in ("a.x", "b.x", "c.Float64_out"):
            assert (signals[name].time[0], signals[name].time[-1]) == (-0.1, 0.011)
        assert signals["a.x"].values[-1] == pytest.approx(1.5 * 0.111, rel=1e-12)
        assert signals["b.x"].values[-1] == pytest.approx(1.5 * 0.111, rel=1e-12)
        held = -2 if algorithm == "jacobi" else -1  # it copies its input when it steps
        assert signals["c.Float64_out"].values[-1] == signals["a.x"].values[held]


def test_one_of_fmi_1_alone_begins_where_its_experiment_does(tmp_path: Path) -> None:
    fmu = first_fmu(
        tmp_path / "their.fmu", changes={'startTime="0.0" stopTime="2.0"': 'startTime="-1.0" stopTime="2.0"'}
    )
    result = load(fmu).run()
    assert (float(result["their.x"]["time"][0]), result.run.end) == (-1.0, 2.0)
