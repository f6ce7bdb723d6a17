"""The autopilot as a participant, with a fake one: what it is told, what acts when, and how a run ends."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from fixtures.fake_autopilot import Fakes, Faults
from helpers import column
from rovbrush.orchestrator.ardupilot.interface import Options
from rovbrush.orchestrator.errors import FmuError, RunError
from rovbrush.orchestrator.fmu.mock import Model, mock_fmu
from rovbrush.orchestrator.fmu.outside.autopilot import autopilot_fmu
from rovbrush.orchestrator.participant.ardusub.model import AutopilotModel
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System

STEP = Fraction(1, 400)


class Sinking(Model):
    """w = u1, z' = w: what it is told at an instant acts over the step that begins there."""

    def step(self, time: float, length: float) -> int | None:
        self.values["w"] = self.values["u1"]
        self.values["z_n"] += length * self.values["w"]
        return None


def plan_of(port: int = 0, stop: Fraction = 8 * STEP, period: Fraction = STEP, **options: Any) -> Plan:
    """An autopilot and a body that sinks."""
    fmu = autopilot_fmu("autopilot", Options(port=port, **options))
    body = mock_fmu("sinking", Sinking, ["u1"], ["z_n", "w"])
    wires = (
        Connection(("autopilot", "u_thruster[1]"), ("body", "u1"), transfer="hold"),
        Connection(("body", "z_n"), ("autopilot", "z_n"), transfer="hold"),
        Connection(("body", "w"), ("autopilot", "w"), transfer="hold"),
    )
    parts = {"body": Component("body", body, STEP), "autopilot": Component("autopilot", fmu, period)}
    about = {"components": parts, "connections": wires, "algorithm": "gauss-seidel", "order": ()}
    system = System("sinking", Path("s.toml"), "", stop, **about)  # type: ignore[arg-type]
    return make_plan(system)


@pytest.fixture
def fakes(monkeypatch: pytest.MonkeyPatch) -> Iterator[Fakes]:
    """Autopilots that are stopped when the test ends."""
    made = Fakes(monkeypatch)
    yield made
    made.stop()


def run(fakes: Fakes, faults: Faults | None = None, interpreted: bool = True, **keys: Any) -> Run:
    about = {key: keys.pop(key) for key in ("rate", "channels", "pilot") if key in keys}
    fakes.make(faults=faults, patience=0.05, **about)
    return simulate(plan_of(**{"timeout": 20.0} | keys), interpreted=interpreted)


def told(run: Run) -> str:
    return " ".join(run.notes)


@pytest.mark.parametrize("interpreted", [True, False])
def test_a_state_is_told_at_the_beginning_of_a_step_and_its_answer_acts_over_that_step(
    fakes: Fakes, interpreted: bool
) -> None:
    pulses = iter([1900, 1900, 1500, 1100, *[1500] * 20])
    done = run(fakes, interpreted=interpreted, pilot=lambda _: [next(pulses), *[1500] * 15])
    assert not done.failure
    states = fakes[0].states[:8]
    assert [state["timestamp"] for state in states] == [k / 400 for k in range(8)]
    depth = [0, 1, 2, 2, 1, 1, 1, 1]  # steps at full speed so far
    assert [state["position"][2] for state in states] == pytest.approx([d / 400 for d in depth])
    assert [state["velocity"][2] for state in states] == [0, 1, 1, 0, -1, 0, 0, 0]
    assert list(column(done, "autopilot.frame")[1]) == list(range(9))  # a row shows what acted before it
    assert list(column(done, "body.z_n")[1]) == pytest.approx([d / 400 for d in [*depth, 1]])


def test_a_run_with_lost_late_doubled_packets_and_garbage_gives_the_rows_of_a_quiet_one(
    fakes: Fakes,
) -> None:
    def down(state: dict[str, Any]) -> list[int]:
        return [round(1900 - 3e4 * state["position"][2]), *[1500] * 15]

    quiet = run(fakes, pilot=down, stop=40 * STEP)
    faults = Faults(lose={3}, double={5, 6}, late={9}, garbage={12: b"x", 13: b"y" * 40})
    loud = run(fakes, faults, pilot=down, stop=40 * STEP)
    for name in ("body.z_n", "autopilot.u_thruster[1]", "autopilot.frame"):
        assert list(column(quiet, name)[1]) == list(column(loud, name)[1])
    assert "41 frames, 0 lost, 0 doubled" in told(quiet)
    assert "41 frames, 0 lost, 2 doubled, 1 late, 2 no servo packets" in told(loud)
    assert "99 % below" in told(loud)


def test_a_restart_of_the_autopilot_is_gone_on_with_and_told(fakes: Fakes) -> None:
    done = run(fakes, Faults(restart=20), stop=40 * STEP)
    assert not done.failure and "1 restart of the autopilot" in told(done)
    frames = list(column(done, "autopilot.frame")[1])
    assert frames == [*range(20), *range(21)]


def test_an_autopilot_that_stops_answering_ends_the_run_and_the_rows_are_kept(fakes: Fakes) -> None:
    done = run(fakes, Faults(silent=6), timeout=1.0)
    assert "stopped answering: nothing came to UDP 127.0.0.1:" in done.failure
    assert "after its frame 5" in done.failure and "autopilot" in done.failure
    assert list(column(done, "autopilot.frame")[1]) == [0, 1, 2, 3, 4, 5]


def test_a_wrong_rate_ends_the_run_and_names_sim_rate_hz(fakes: Fakes) -> None:
    done = run(fakes, rate=1200)
    assert "the autopilot's frames come at 1200 Hz, but the period of 2.5 ms is 400 Hz" in done.failure
    assert "SIM_RATE_HZ to 400" in done.failure
    assert len(column(done, "autopilot.frame")[1]) >= 2


def test_the_rate_is_that_of_the_period(fakes: Fakes) -> None:
    done = run(fakes, rate=100, period=Fraction(1, 100), stop=Fraction(1, 10))
    assert not done.failure and "11 frames, 0 lost" in told(done)


def test_nobody_at_the_port_is_an_error_that_says_what_to_start() -> None:
    with pytest.raises(FmuError, match=r"autopilot: .*no autopilot was heard at UDP \S+ for 0\.05 s; start .*ArduSub"):
        simulate(plan_of(timeout=0.05), interpreted=True)


def test_a_port_in_use_is_an_error_before_time_0() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
        with pytest.raises(
            FmuError, match=rf"component autopilot: .* cannot listen at UDP 127\.0\.0\.1:{port} \(Address"
        ):
            simulate(plan_of(port), interpreted=True)


def test_a_state_that_is_no_number_is_not_told(fakes: Fakes) -> None:
    fakes.make()
    fmu = autopilot_fmu("autopilot", Options(port=0))
    model = AutopilotModel(fmu.starts(), fmu.settings)
    model.set_up(0.0, None)
    model.initialized()
    model.set({"z_n": float("nan")})
    with pytest.raises(RunError, match="position is nan, which cannot be told to the autopilot"):
        model.step(0.0, 0.0025)
    model.close()


def test_a_second_interrupt_ends_a_wait_in_good_order(fakes: Fakes, monkeypatch: pytest.MonkeyPatch) -> None:
    fakes.make()
    fmu = autopilot_fmu("autopilot", Options(port=0))
    model = AutopilotModel(fmu.starts(), fmu.settings)
    model.set_up(0.0, None)
    model.initialized()

    def insist(_line: bytes) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(model.link, "exchange", insist)
    with pytest.raises(RunError, match="interrupted while it waited for the autopilot"):
        model.step(0.0, 0.0025)
    model.close()
