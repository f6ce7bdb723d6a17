"""Systems with FMUs for Model Exchange: one group in the plan, beside components for co-simulation."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path

import exchange_build
import numpy as np
import pytest
from helpers import rovbrush
from native_build import answers, needs_gcc
from rovbrush.orchestrator import FmuError, InputError, RunError, load
from rovbrush.orchestrator.integration.compiled import is_compiled
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
RELAY = """
format = 2
stop_time = "4 s"
connections = ["lag.x -> relay.y", "relay.on -> lag.on"]
[solver]
tolerance = 1e-10
{solver}
[components.relay]
fmu = "relay.fmu"
period = "10 ms"
parameters = {{ low = 0.3, high = 0.7 }}
[components.lag]
fmu = "lag.fmu"
period = "20 ms"
"""


def system(folder: Path, text: str, *names: str, version: int = 2) -> Path:
    for name in names:
        exchange_build.exchange(folder, name, version)
    path = folder / "system.toml"
    path.write_text(text, encoding="utf-8")
    return path


def planned(path: Path) -> Plan:
    return make_plan(load_system(str(path), path.parent))


def lag_system(folder: Path, more: str = "", component: str = "", version: int = 2) -> Path:
    text = f'format = 2\nstop_time = "1 s"\n{more}\n[components.lag]\nfmu = "lag.fmu"\nperiod = "10 ms"\n{component}\n'
    return system(folder, text, "lag", version=version)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("solver", ["", 'method = "cvode"'])
def test_a_relay_and_a_lag_switch_at_the_times_of_the_closed_form(tmp_path: Path, solver: str, version: int) -> None:
    result = load(system(tmp_path, RELAY.format(solver=solver), "relay", "lag", version=version)).run()
    assert result.summary["complete"]
    switched = np.unique(result["relay.t_switch"].values)[1:]
    up, half = math.log(1 / 0.3), math.log(0.7 / 0.3)
    assert switched == pytest.approx([up + k * half for k in range(len(switched))], abs=1e-8)
    assert np.array_equal(result["relay.y"].values, result["lag.x"].values)
    assert np.array_equal(result["lag.on"].values, result["relay.on"].values)


def test_the_plan_says_that_they_are_one_group_and_how_it_is_integrated(tmp_path: Path) -> None:
    text = explain(planned(system(tmp_path, RELAY.format(solver=""), "relay", "lag")))
    assert "relay, lag: one group, 1 state, integrated by dormand-prince (nothing says that it is stiff" in text
    assert "lag is stepped every 10 ms, with the other FMUs for Model Exchange" in text
    assert "continuous  solved in each evaluation of the states" in text
    assert "continuous  sent at events, when it can change" in text
    chosen = explain(planned(system(tmp_path, RELAY.format(solver='method = "cvode"'), "relay", "lag")))
    assert "integrated by cvode (stated in the system file)" in chosen


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi", "iterated"])
def test_a_component_for_co_simulation_drives_the_group_and_is_driven(tmp_path: Path, algorithm: str) -> None:
    """A mass (co-simulation, explicit Euler inside) on a lagged spring force of Model Exchange."""
    answers(tmp_path / "mass.fmu", "mass")
    text = f"""
format = 2
stop_time = "1 s"
algorithm = "{algorithm}"
connections = ["mass.x -> lag.push", "lag.x -> mass.F"]
[components.mass]
fmu = "mass.fmu"
period = "1 ms"
parameters = {{ x0 = 1.0 }}
[components.lag]
fmu = "lag.fmu"
period = "1 ms"
parameters = {{ tau = 0.1 }}
"""
    result = load(system(tmp_path, text, "lag")).run()
    from scipy.linalg import expm

    matrix = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [10.0, 0.0, -10.0]])
    exact = expm(matrix) @ [1.0, 0.0, 0.0]
    assert float(result["mass.x"][-1]) == pytest.approx(exact[0], rel=5e-3)
    assert float(result["lag.x"][-1]) == pytest.approx(exact[2], rel=5e-3)


def test_an_fmu_alone_runs_by_its_default_experiment(tmp_path: Path) -> None:
    path = exchange_build.exchange(tmp_path, "ball")
    result = load(path, stop="1 s", step="10 ms").set("ball.e", 0.5).run()
    t = math.sqrt(2 / 9.81)
    assert float(result["ball.h"].sel(time=0.4)) == pytest.approx(1.0 - 9.81 * 0.08, abs=1e-9)
    speed = 0.5 * 9.81 * t
    assert float(result["ball.v"].sel(time=0.6)) == pytest.approx(speed - 9.81 * (0.6 - t), abs=1e-9)


def test_an_fmu_of_both_kinds_is_taken_as_the_system_says(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "lag", both=True)
    path = lag_system(tmp_path, component='kind = "model-exchange"\ninputs = { push = 1.0 }')
    assert float(load(path).run()["lag.x"][-1]) == pytest.approx(1.0 - math.exp(-1.0), abs=1e-6)


@pytest.mark.parametrize("method", ["dormand-prince", "cvode", "rk4"])
def test_inputs_that_follow_tables_and_jump_cost_no_accuracy(tmp_path: Path, method: str) -> None:
    rows = "inputs = { push = { time = [0.0, 0.5, 0.5, 1.0], values = [1.0, 1.0, -1.0, -1.0] } }"
    path = lag_system(tmp_path, f'[solver]\nmethod = "{method}"\ntolerance = 1e-9', rows)
    x = 1.0 - math.exp(-0.5)
    assert float(load(path).run()["lag.x"][-1]) == pytest.approx(-1.0 + (x + 1.0) * math.exp(-0.5), abs=1e-7)


def test_a_sampled_input_acts_by_an_event_at_its_instant(tmp_path: Path) -> None:
    rows = "inputs = { on = { time = [0.0, 0.5, 1.0], values = [false, true, true] } }"
    path = lag_system(tmp_path, component=rows)
    result = load(path).run()
    assert float(result["lag.x"].sel(time=0.5)) == 0.0
    assert float(result["lag.x"][-1]) == pytest.approx(1.0 - math.exp(-0.5), abs=1e-6)


def test_what_is_set_by_hand_counts_from_the_next_step(tmp_path: Path) -> None:
    with load(lag_system(tmp_path)).start() as session:
        session.step("0.5 s")
        session.set("lag.push", 2.0)
        session.set("lag.tau", 0.5)
        session.step("0.5 s")
        assert session.get("lag.x") == pytest.approx(2.0 * (1.0 - math.exp(-1.0)), abs=1e-6)


def test_an_algebraic_loop_between_two_of_them_is_solved_at_all_times(tmp_path: Path) -> None:
    text = """
format = 2
stop_time = "0.5 s"
connections = ["b.y -> a.push", "a.y -> b.push"]
[components.a]
fmu = "lag.fmu"
period = "10 ms"
parameters = { d = 0.5 }
[components.b]
fmu = "lag.fmu"
period = "10 ms"
parameters = { d = -0.4 }
"""
    exchange_build.exchange(tmp_path, "lag")
    path = system(tmp_path, text)
    result = load(path).run()
    assert float(abs(result["a.push"] - result["b.y"]).max()) < 1e-12
    assert float(abs(result["b.push"] - result["a.y"]).max()) < 1e-12


MOODY = """
format = 2
stop_time = "1 s"
[components.moody]
fmu = "moody.fmu"
period = "100 ms"
parameters = {{ fault = {fault} }}
"""
FAULTS = {
    1: "component moody: at t = .* derivative der.x. is not finite",
    2: "component moody: at t = .* fmi2GetDerivatives answered fmi2Discard",
    3: "component moody: at t = .* it chatters: more than 1000 events in one step, the last of event indicator 1",
    4: "the events at t = 0.55 s do not settle: after 1000 rounds moody still asks for another one",
    5: "component moody: at t = .* fmi2GetDerivatives answered fmi2Error",
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_failure_names_the_fmu_and_keeps_the_rows(tmp_path: Path, fault: int) -> None:
    with pytest.raises(RunError, match=FAULTS[fault]) as raised:
        load(system(tmp_path, MOODY.format(fault=fault), "moody")).run()
    assert raised.value.result["moody.x"].values == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("fault", FAULTS)
def test_a_failure_in_a_process_of_its_own_gives_the_same_reason(tmp_path: Path, fault: int) -> None:
    """Its events are its own there, so its rounds too."""
    text = MOODY.format(fault=fault) + 'isolation = "process"\n'
    words = FAULTS[fault] if fault != 4 else "component moody: at t = .* an event does not settle: after 100 rounds"
    with pytest.raises(RunError, match=words):
        load(system(tmp_path, text, "moody")).run()


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("fault", [6, 9])
def test_one_that_asks_to_end_ends_the_run_well(tmp_path: Path, fault: int, version: int) -> None:
    result = load(system(tmp_path, MOODY.format(fault=fault), "moody", version=version)).run()
    assert re.search(r"moody asked to end the simulation at t = 0\.(55|6) s", result.summary["ended"])
    assert float(result["moody.x"][-1]) <= 0.6


def test_another_transfer_between_two_of_them_is_refused(tmp_path: Path) -> None:
    text = RELAY.format(solver="").replace("lag.x -> relay.y", "lag.x -> relay.y (linear)")
    with pytest.raises(InputError, match="whose connections are solved at all times; leave out 'linear'"):
        planned(system(tmp_path, text, "relay", "lag"))


def test_a_run_that_goes_on_from_a_checkpoint_gives_the_same_bits(tmp_path: Path) -> None:
    for solver in ("", 'method = "cvode"\nrestart = true'):
        plan = planned(system(tmp_path, RELAY.format(solver=solver), "relay", "lag"))
        with Session(plan) as whole:
            whole.advance()
        with Session(plan) as first:
            first.advance(until_tick=plan.clock.stop // 2)
            write_checkpoint(first, tmp_path)
        with Session(plan) as second:
            read_checkpoint(tmp_path).restore(second)
            second.advance()
            assert not second.failure
            assert second.memory.z.tobytes() == whole.memory.z.tobytes()
            rows = [[(r.time, r.number, r.what, r.cells.tobytes()) for r in s.run().events] for s in (whole, second)]
            assert rows[0] == rows[1] and len(rows[0]) > 10


def test_what_only_co_simulation_can_do_is_refused(tmp_path: Path) -> None:
    from rovbrush.orchestrator.exchange.container import write_container

    path = system(tmp_path, RELAY.format(solver=""), "relay", "lag")
    with pytest.raises(InputError, match="is taken for model exchange, and a container can hold"):
        write_container(load_system(str(path), tmp_path), tmp_path / "c.fmu")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
def test_one_in_a_process_of_its_own_is_a_group_by_itself(tmp_path: Path) -> None:
    path = lag_system(tmp_path, component='isolation = "process"\ninputs = { push = 1.0 }')
    assert float(load(path).run()["lag.x"][-1]) == pytest.approx(1.0 - math.exp(-1.0), abs=1e-6)
    assert explain(planned(path)).count("integrated by") == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("isolation", ["none", "process"])
def test_the_kind_that_was_chosen_counts_wherever_the_fmu_runs(isolation: str, tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "lag", both=True)
    chosen = f'kind = "model-exchange"\nisolation = "{isolation}"\ninputs = {{ push = 1.0 }}'
    path = lag_system(tmp_path, component=chosen)
    assert float(load(path).run()["lag.x"][-1]) == pytest.approx(1.0 - math.exp(-1.0), abs=1e-6)


def test_a_run_tells_where_a_model_proved_stiff(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "oscillator")
    text = 'format = 2\nstop_time = "20 s"\n[components.o]\nfmu = "oscillator.fmu"\nperiod = "1 s"\n'
    path = system(tmp_path, text + "parameters = { mu = 1000.0 }\n")
    notes = load(path).run().summary["notes"]
    assert any("o: steps were limited by stability at t = " in note for note in notes)


def test_one_that_cannot_be_loaded_beside_the_others_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It would have a process of its own then, where its connections to the others cannot be solved."""
    from rovbrush.orchestrator.participant import opening

    path = system(tmp_path, RELAY.format(solver=""), "relay", "lag")
    monkeypatch.setattr(opening, "why_not_here", lambda c: "it keeps static data" if c.name == "lag" else "")
    with pytest.raises(FmuError, match=r"component lag: lag.fmu was used in this process before"):
        load(path).run()


def test_who_compiles_for_half_a_minute_is_told_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    exchange_build.exchange(tmp_path, "ball")
    run = ("run", tmp_path / "ball.fmu", "--stop", "10 ms", "--force", "--out", tmp_path / "out")
    assert rovbrush(monkeypatch, *run) == 0
    capsys.readouterr()
    assert rovbrush(monkeypatch, *run) == 0  # in a second run nothing is left
    assert "first run" not in capsys.readouterr().out
    monkeypatch.setattr("rovbrush.orchestrator.integration.compiled._hash", lambda _: "of other sources")
    assert not is_compiled()
    monkeypatch.undo()
    monkeypatch.setattr("rovbrush.orchestrator.integration.compiled.is_compiled", lambda: False)
    assert rovbrush(monkeypatch, *run) == 0
    assert "the first run compiles the solver of model exchange" in capsys.readouterr().out


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
@pytest.mark.parametrize("high", [0.619, *np.linspace(0.31, 0.79, 9).round(3).tolist()])
def test_a_switch_behind_an_algebraic_loop_is_never_missed(high: float, method: str, tmp_path: Path) -> None:
    """x' = (gain on + y - x) / tau with y = x + d y, until y reaches `high`: rounding of the loop may leave y short of
    it where the solver has found the crossing, as it does with 0.619."""
    d, tau, gain = 0.135, 0.760, 0.5
    text = f"""
format = 2
stop_time = "1.2 s"
connections = ["lag.y -> relay.y", "lag.y -> lag.push", "relay.on -> lag.on"]
solver = {{ tolerance = 1e-9, method = "{method}" }}
[components.relay]
fmu = "relay.fmu"
period = "20 ms"
parameters = {{ low = -0.2, high = {high} }}
[components.lag]
fmu = "lag.fmu"
period = "10 ms"
parameters = {{ d = {d}, tau = {tau}, gain = {gain} }}
"""
    k, b = d / (1.0 - d) / tau, gain / tau
    switched = math.log1p(k * high * (1.0 - d) / b) / k
    result = load(system(tmp_path, text, "relay", "lag", version=3)).run()
    assert int(result["relay.switches"][-1]) == 1
    assert float(result["relay.t_switch"][-1]) == pytest.approx(switched, abs=2e-9)
