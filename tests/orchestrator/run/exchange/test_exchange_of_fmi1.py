"""FMUs for Model Exchange of FMI 1.0: a ball against its closed form, beside later versions, and what it asks for."""

from __future__ import annotations

import math
from pathlib import Path

import exchange_build
import pytest
from first_exchange_build import ball1
from native_build import needs_gcc
from rovbrush.orchestrator import FmuError, load
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.windows.opening import windows_class
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
SYSTEM = """
format = 2
stop_time = "{stop}"
connections = {connections}
[solver]
tolerance = 1e-10
method = "{method}"
[components.ball]
fmu = "ball.fmu"
period = "10 ms"
isolation = "{isolation}"
{more}
"""


def system(
    folder: Path, more: str = "", method: str = "dormand-prince", stop: str = "2 s", isolation: str = "none",
    connections: str = "[]",
) -> Path:  # fmt: skip
    ball1(folder / "ball.fmu")
    path = folder / "system.toml"
    text = SYSTEM.format(stop=stop, connections=connections, method=method, isolation=isolation, more=more)
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.sampled(3)
@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("method", ["dormand-prince", "cvode", "rk4"])
def test_a_ball_bounces_as_by_its_closed_form(tmp_path: Path, method: str, isolation: str) -> None:
    result = load(system(tmp_path, method=method, isolation=isolation)).run()
    first, speed, t = math.sqrt(2 / 9.81), 0.7 * math.sqrt(2 * 9.81), 0.9
    assert result.summary["complete"]
    assert float(result["ball.h"].sel(time=0.4)) == pytest.approx(1 - 9.81 * 0.08, abs=1e-8)
    assert float(result["ball.h"].sel(time=t)) == pytest.approx(
        speed * (t - first) - 9.81 * (t - first) ** 2 / 2, abs=1e-8
    )
    assert float(result["ball.minus_v"].sel(time=t)) == pytest.approx(9.81 * (t - first) - speed, abs=1e-8)
    assert int(result["ball.hits"][-1]) == 4  # at 0.45, 1.08, 1.53 and 1.84 s


def test_its_impacts_are_where_they_must_be(tmp_path: Path) -> None:
    with Session(make_plan(load_system(str(system(tmp_path)), tmp_path))) as session:
        session.advance()
        assert session.group is not None
        first = math.sqrt(2 / 9.81)
        exact = [first, *(first + 2 * first * sum(0.7**j for j in range(1, k + 1)) for k in range(1, 4))]
        found = [event.time for event in session.group.events()]
        assert found[::2] == pytest.approx(exact, abs=1e-9), "and it leaves the ground behind each, which is an event"


def test_its_time_events_are_hit_and_its_wish_to_end_is_heard(tmp_path: Path) -> None:
    result = load(system(tmp_path, "parameters = { period = 0.03, end = 1.5005 }")).run()
    assert int(result["ball.n"].sel(time=0.3)) == 10
    assert "ball asked to end the simulation" in result.summary["ended"]
    assert float(result["ball.h"].time[-1]) == pytest.approx(1.5, abs=0.011)


def test_its_inputs_are_set_reals_at_all_times_and_others_at_events(tmp_path: Path) -> None:
    more = "inputs = { u = 9.81, on = { time = [0.0, 0.5, 1.0], values = [false, true, true] } }"
    result = load(system(tmp_path, more, stop="0.9 s")).run()
    assert float(result["ball.h"].sel(time=0.5)) == pytest.approx(1.0, abs=1e-12)
    assert float(result["ball.h"].sel(time=0.9)) == pytest.approx(1.0 - 9.81 * 0.08, abs=1e-9)


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("output", ["v", "minus_v"])
def test_it_is_one_group_with_later_versions(tmp_path: Path, version: int, output: str) -> None:
    """A lag behind its speed, whose sign an alias can turn: x' = v - x, v = -g t."""
    exchange_build.exchange(tmp_path, "lag", version)
    more = '[components.lag]\nfmu = "lag.fmu"\nperiod = "10 ms"'
    path = system(tmp_path, more, stop="0.4 s", connections=f'["ball.{output} -> lag.push"]')
    sign = 1.0 if output == "v" else -1.0
    x = -9.81 * (0.4 - 1.0 + math.exp(-0.4))
    assert float(load(path).run()["lag.x"][-1]) == pytest.approx(sign * x, abs=1e-8)
    assert "ball, lag: one group, 3 states" in explain(make_plan(load_system(str(path), tmp_path)))


def test_one_that_fails_is_named(tmp_path: Path) -> None:
    from rovbrush.orchestrator import RunError

    path = system(tmp_path, "inputs = { u = { time = [0.0, 1.0, 2.0], values = [1.0, 1e308, 1e308] } }")
    with pytest.raises(RunError, match="component ball"):
        load(path).run()


def test_check_finds_no_error_in_it(tmp_path: Path) -> None:
    assert check_fmu(ball1(tmp_path / "ball.fmu")).count("error") == 0


def test_its_own_tolerance_counts(tmp_path: Path) -> None:
    path = system(tmp_path, "tolerance = 1e-9")
    with Session(make_plan(load_system(str(path), tmp_path))) as session:
        assert session.instances["ball"].tolerance == 1e-9


def test_under_wine_it_is_refused_by_name(tmp_path: Path) -> None:
    with pytest.raises(FmuError, match=r"ball\.fmu: model exchange of FMI 1\.0 is not run under wine"):
        windows_class(Fmu.open(ball1(tmp_path / "ball.fmu")), False)
