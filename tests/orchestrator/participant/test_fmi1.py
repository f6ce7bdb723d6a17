"""FMI 1.0 for co-simulation: one more participant, with the same bits wherever and however it runs."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from first_fmi import TOOL, first_fmu
from helpers import column, read_system, rovbrush, system_text
from native_build import feedthrough2, feedthrough3, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.types import decode
from rovbrush.orchestrator.participant.base import CallError, Participant, State
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
WIRES = [
    "a.y -> b.u", "a.x -> b.minus_v", "b.minus_x -> a.minus_v", "a.minus_n -> b.n_in", "a.on_out -> b.on_in",
    "a.s_out -> b.s_in", "a.mode_out -> b.mode_in",
]  # fmt: skip
GIVEN = {"gain": 2.0, "=u": 1.5, "=n_in": -7, "=on_in": True, "=s_in": 'hüll, "on"', "=mode_in": 3}


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return first_fmu(tmp_path_factory.mktemp("fmi1") / "first.fmu")


@pytest.fixture
def instance(first: Path) -> Participant:
    return load(Fmu.open(first), "a")


def pair(first: Path, **of: str) -> System:
    parts = {"a": (str(first), "1 ms", GIVEN), "b": (str(first), "1 ms", {"x0": 1.0})}
    return read_system(first.parent, first.parent, parts, WIRES, stop="10 ms", of={"b": of})


def values(run: Run, name: str) -> np.ndarray:
    """The column of `component.variable` in its type."""
    component, variable = name.split(".", 1)
    kind = run.plan.system.components[component].fmu.type_of(variable)
    assert kind is not None
    return decode(kind, np.ascontiguousarray(column(run, name)[1]))


def run_of(system: System, interpreted: bool = False) -> Run:
    run = simulate(make_plan(system), interpreted=interpreted)
    assert not run.failure, run.failure
    return run


def test_two_coupled_fmus_exchange_every_type_and_sign(first: Path) -> None:
    run = run_of(pair(first))
    expected = {
        "a.y": 3.0, "a.x": 0.015, "b.x": 1.03, "b.minus_x": -1.03, "a.z": 1.027, "b.z": -0.015,
        "a.n_out": -7, "a.minus_n": 7, "b.minus_n": -7, "b.mode_out": 3, "b.on_out": True,
    }  # fmt: skip
    for name, value in expected.items():
        assert values(run, name)[-1] == pytest.approx(value, rel=1e-12), name
    assert run.texts is not None
    assert run.texts.text(int(values(run, "b.s_out")[-1])) == 'hüll, "on"'


def test_the_first_row_is_that_behind_initialization(first: Path) -> None:
    run = run_of(pair(first))
    for name, value in {"a.y": 3.0, "b.u": 3.0, "b.y": 3.0, "b.x": 1.0, "b.minus_n": -7, "a.minus_v": -1.0}.items():
        assert values(run, name)[0] == value, name


@pytest.mark.parametrize("how", ["interpreted", "isolated"])
def test_however_it_runs_it_gives_the_same_bits(how: str, first: Path) -> None:
    expected = run_of(pair(first))
    run = run_of(pair(first, **({"isolation": "process"} if how == "isolated" else {})), how == "interpreted")
    for a, b in zip(expected.tables, run.tables, strict=True):
        assert a.tobytes() == b.tobytes()


def test_each_instance_has_static_data_of_its_own(first: Path) -> None:
    system = pair(first)
    for _ in range(2):
        run = run_of(system)
        assert run.calculated == {"a.calls": 1.0, "b.calls": 1.0}


def test_a_negated_alias_of_an_input_is_set_with_the_other_sign(instance: Participant) -> None:
    instance.set_up(1.0)
    instance.set_all({"minus_v": 4.0})
    instance.enter_initialization()
    assert instance.get("v") == -4.0
    instance.close()


def test_reading_initializes_it_once(instance: Participant) -> None:
    instance.set_up(1.0)
    instance.set_all({"gain": 2.0, "u": 3.0})
    instance.enter_initialization()
    assert instance.get("y") == 6.0
    instance.exit_initialization()
    assert instance.state is State.STEPPING
    with pytest.raises(CallError, match="it is a fixed parameter; after initialization only inputs"):
        instance.set("gain", 1.0)
    assert not instance.close()


def test_its_own_messages_reach_it_formatted(first: Path) -> None:
    for fmu in (first, first_fmu(first.parent / "shifted.fmu", SHIFTED=1)):
        instance = load(Fmu.open(fmu), "a", logging="warnings")
        assert instance.messages == ["instantiated 1"]
        instance.close()


def test_what_an_fmu_says_at_every_step_is_read_only_where_all_is_asked_for(first: Path) -> None:
    fmu = first_fmu(first.parent / "talker.fmu", TALK=1)
    for logging, lines in (("warnings", 1), ("all", 101)):
        instance = load(Fmu.open(fmu), "a", logging=logging)  # type: ignore[arg-type]
        instance.begin(1.0)
        instance.exit_initialization()
        for k in range(10):
            instance.step(k * 0.01, 0.01)
        assert len(instance.logged()) == lines, logging
        instance.close()


@pytest.mark.parametrize("interpreted", [False, True])
def test_a_ring_of_all_versions_passes_values_on_as_one_of_a_single_version(interpreted: bool, tmp_path: Path) -> None:
    first = first_fmu(tmp_path / "first.fmu", changes={'<Real declaredType="Speed"': "<Real"})
    second, third = feedthrough2(tmp_path / "second.fmu"), feedthrough3(tmp_path / "third.fmu")
    rings = {
        "mixed": [(str(first), "u", "y"), (str(second), "u", "y"), (str(third), "Float64_in", "Float64_out")],
        "alike": [(str(first), "u", "y")] * 3,
    }
    found = {}
    for name, ring in rings.items():
        parts = {f"c{k}": (fmu, "1 ms", {}) for k, (fmu, _, _) in enumerate(ring)}
        parts["s"] = (str(first), "1 ms", {"=u": 1.5, "x0": 0.1})
        wires = [f"c{k}.{ring[k][2]} -> c{k + 1}.{ring[k + 1][1]}" for k in range(2)]
        wires += ["s.minus_x -> c0.u", f"c2.{ring[2][2]} -> s.minus_v"]
        system = read_system(first.parent, first.parent, parts, wires, stop="10 ms")
        found[name] = column(run_of(system, interpreted), "s.z")[1]
    assert found["mixed"].tobytes() == found["alike"].tobytes()
    assert found["mixed"][-1] == pytest.approx(0.1 + 1.5 * 0.009, rel=1e-12)


def test_a_checkpoint_is_refused_by_name(
    first: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "case.toml").write_text(system_text({"a": (str(first), "1 ms", GIVEN)}, stop="10 ms"))
    monkeypatch.chdir(tmp_path)
    assert rovbrush(monkeypatch, "run", "case.toml", "--checkpoint", "2 ms", "--out", "results") == 2
    assert "component a" in (said := capsys.readouterr().err) and "cannot" in said, said


def test_it_begins_and_ends_where_it_is_told(first: Path) -> None:
    parts = {"a": (str(first), "1 ms", {"=u": 1.0})}
    system = read_system(first.parent, first.parent, parts, stop="2.0045 s", start_time="2 s")
    times, x = column(run_of(system), "a.x")
    assert (times[0], times[-1]) == (2.0, 2.0045)
    assert x[-1] == pytest.approx(0.0045, rel=1e-12)


def alone(first: Path, seconds: str = "10 ms", **parameters: float) -> System:
    values = {"=u": 1.0, "=minus_v": 0.0, **parameters}
    return read_system(first.parent, first.parent, {"a": (str(first), "1 ms", values)}, stop=seconds)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        (1, "component a returned fmiDiscard in the step to t = 0.005 s; it reached t = 0.00425 s"),
        (2, "component a returned fmiError in the step to t = 0.005 s\ninstantiated 1\nno solution at 0.004"),
        (3, "component a returned fmiFatal in the step to t = 0.005 s"),
        (6, "component a returned fmiPending in the step to t = 0.005 s; it goes on with the step by itself, which"),
        (4, "component a: output x became nan in the step to t = 0.005 s"),
    ],
)
def test_a_step_that_fails_is_named_with_its_reason(fault: int, words: str, first: Path) -> None:
    run = simulate(make_plan(alone(first, fault=fault, bad_at=0.0045)))
    assert run.failure.startswith(words)
    assert column(run, "a.x")[0][-1] == pytest.approx(0.004)


def test_a_crash_in_a_process_of_its_own_is_an_error_of_the_run(first: Path) -> None:
    system = read_system(
        first.parent, first.parent, {"a": (str(first), "1 ms", {"=u": 1.0, "fault": 5, "bad_at": 0.0045})},
        stop="10 ms", of={"a": {"isolation": "process"}},
    )  # fmt: skip
    run = simulate(make_plan(system))
    assert run.failure.startswith("component a: its process crashed with SIGABRT")


def test_what_needs_its_state_is_refused_by_name(first: Path) -> None:
    system = read_system(
        first.parent, first.parent, {"a": (str(first), "1 ms", GIVEN), "b": (str(first), "1 ms", {})}, WIRES,
        stop="10 ms", algorithm="iterated",
    )  # fmt: skip
    with pytest.raises(InputError, match=r"component a: .* cannot save its own \(canGetAndSetFMUState = false\)"):
        make_plan(system)


def test_a_tolerance_is_refused_with_the_reason(first: Path) -> None:
    system = read_system(
        first.parent, first.parent, {"a": (str(first), "1 ms", GIVEN)}, stop="10 ms", of={"a": {"tolerance": 1e-6}}
    )
    with pytest.raises(InputError, match=r"component a: FMI 1.0 takes no tolerance for co-simulation; leave it out"):
        make_plan(system)


def test_what_holds_no_model_is_refused(tmp_path: Path) -> None:
    fmu = first_fmu(tmp_path / "other.fmu", TOOL)
    words = "it passes calls on to Another Tool, which must be installed and started for it (CoSimulation_Tool)"
    with pytest.raises(FmuError, match=re.escape(words)):
        Fmu.open(fmu)


def test_one_that_says_nothing_of_co_simulation_must_have_the_functions_of_model_exchange(tmp_path: Path) -> None:
    fmu = Fmu.open(first_fmu(tmp_path / "other.fmu", ""))
    assert fmu.kind == "model-exchange"
    with pytest.raises(FmuError, match=r"component a: other\.fmu cannot be instantiated: .*InstantiateModel"):
        load(fmu, "a")


def test_an_fmu_that_is_told_what_it_does_not_know_gives_no_instance(first: Path) -> None:
    fmu = first_fmu(first.parent / "other.fmu", changes={'guid="{other}"': 'guid="{another}"'})
    with pytest.raises(FmuError, match=r"component a: other\.fmu cannot be instantiated: it gave no instance"):
        load(Fmu.open(fmu), "a")


def test_each_command_takes_it(first: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "case.toml").write_text(system_text({"a": (str(first), "1 ms", GIVEN)}, stop="10 ms"))
    monkeypatch.chdir(tmp_path)
    assert rovbrush(monkeypatch, "plan", "case.toml") == 0
    assert rovbrush(monkeypatch, "info", first) == 0
    assert rovbrush(monkeypatch, "run", first, "--stop", "10 ms", "--set", "mode_in=test", "--out", "alone") == 0
    assert rovbrush(monkeypatch, "run", "case.toml", "--out", "results") == 0
    found = json.loads((tmp_path / "results" / "summary.json").read_text())
    assert found["complete"] is True
    assert "instantiated 1" in (tmp_path / "results" / "messages.log").read_text()
