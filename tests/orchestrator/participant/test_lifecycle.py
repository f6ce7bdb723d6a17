"""The life of an FMU follows the standard's table: what is told to it, in which order, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from helpers import column, plan_of, read_system
from native_build import feedthrough2, feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant import lifecycle
from rovbrush.orchestrator.participant.base import CallError, Participant
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.participant.lifecycle import State
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
TIMEOUT = 60.0  # s


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file in which moody FMUs write what they are told."""
    path = tmp_path / "told.txt"
    monkeypatch.setenv("MOODY_LOG", str(path))
    return path


def told(log: Path) -> list[str]:
    return log.read_text().splitlines() if log.is_file() else []


def isolated(fmu: Fmu, name: str) -> Participant:
    return IsolatedInstance(fmu, name, TIMEOUT)


everywhere = pytest.mark.parametrize("start", [load, isolated], ids=["here", "isolated"])
Start = Callable[[Fmu, str], Participant]


def stepping(instance: Participant) -> Participant:
    instance.begin(1.0)
    instance.exit_initialization()
    return instance


def test_a_run_sets_up_the_experiment_first_and_frees_last(tmp_path: Path, log: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_SET='told("set")')
    run = simulate(plan_of(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"k": 2.0, "=u": 1.0})}, stop="2 ms"))
    assert not run.failure
    words = ["instantiate", "setup tolerance=1e-06 start=0 stop=0.002", "set", "set", "enter", "exit"]
    assert told(log) == [*words, "terminate", "free"]


def test_a_parameter_set_before_the_experiment_would_be_lost_and_is_not(tmp_path: Path) -> None:
    """An FMU may begin afresh in fmi2SetupExperiment."""
    moody(tmp_path / "moody.fmu", ON_SETUP="m->k = 1.0")
    parts = {"a": ("moody", "1 ms", {"k": 5.0, "=u": 1.0})}
    run = simulate(plan_of(tmp_path, tmp_path, parts, stop="2 ms"))
    assert column(run, "a.y")[1][-1] == pytest.approx(0.01)


def test_outputs_are_read_again_behind_initialization_mode(tmp_path: Path) -> None:
    """Row 0, what others get in the first step, and what the system requires of time 0."""
    moody(tmp_path / "moody.fmu", ON_EXIT="m->y = 7.0")
    parts = {"a": ("moody", "1 ms", {"=u": 0.0}), "b": ("moody", "1 ms")}
    run = simulate(plan_of(tmp_path, tmp_path, parts, ["a.y -> b.u"], stop="2 ms", algorithm="jacobi"))
    assert column(run, "a.y")[1][0] == 7.0
    assert column(run, "b.x")[1][1] == pytest.approx(0.007)


FATES: dict[str, tuple[dict[str, str], list[str]]] = {
    "refused in initialization": ({"ON_ENTER": "return fmi2Error"}, ["free"]),
    "discarded in initialization": ({"ON_EXIT": "return fmi2Discard"}, ["free"]),
    "fatal in initialization": ({"ON_ENTER": "return fmi2Fatal"}, []),
    "a parameter refused": ({"ON_SET": "return fmi2Error"}, ["free"]),
    "a step that failed": ({"ON_STEP": "if (m->steps > 2) return fmi2Error"}, ["free"]),
    "a step that was discarded": ({"ON_STEP": "if (m->steps > 2) return fmi2Discard"}, ["terminate", "free"]),
    "a fatal step": ({"ON_STEP": "if (m->steps > 2) return fmi2Fatal"}, []),
    "a step that goes on": ({"ON_STEP": "if (m->steps > 2) return fmi2Pending"}, ["cancel", "free"]),
    "a status of nobody": ({"ON_STEP": "if (m->steps > 2) return 99"}, ["free"]),
    "a get that failed": ({"ON_GET": "if (m->steps > 2) return fmi2Error"}, ["free"]),
    "termination refused": ({"ON_TERMINATE": "return fmi2Error"}, ["terminate", "free"]),
}


@pytest.mark.sampled(8)
@pytest.mark.parametrize("process", ["", "isolation"], ids=["here", "isolated"])
@pytest.mark.parametrize(("actions", "end"), FATES.values(), ids=FATES.keys())
def test_terminate_comes_below_error_only_and_free_unless_fatal(
    actions: dict[str, str], end: list[str], process: str, tmp_path: Path, log: Path
) -> None:
    moody(tmp_path / "moody.fmu", **actions)
    system = read_system(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"k": 2.0, "=u": 0.0})}, stop="5 ms")
    if process:
        path = tmp_path / "case.toml"
        path.write_text(path.read_text().replace("[components.a]\n", '[components.a]\nisolation = "process"\n'))
        from rovbrush.orchestrator.system.file.reader import load_system

        system = load_system(str(path), tmp_path)
    try:
        simulate(make_plan(system))
    except FmuError as error:
        assert str(error).startswith("component a: cannot")
    words = [word for word in told(log) if word in ("cancel", "terminate", "free")]
    assert words == end
    assert told(log).count("instantiate") == 1


def test_a_hundred_failed_starts_leave_no_instance(tmp_path: Path, log: Path) -> None:
    fmu = Fmu.open(moody(tmp_path / "moody.fmu", ON_ENTER="return fmi2Error"))
    for _ in range(100):
        instance = load(fmu, "a")
        with pytest.raises(CallError, match="cannot enter initialization"):
            instance.begin(1.0)
        assert instance.close() == ""
    assert told(log).count("free") == told(log).count("instantiate") == 100


@pytest.mark.sampled(20)
@pytest.mark.parametrize("interpreted", [False, True], ids=["compiled", "interpreted"])
@pytest.mark.parametrize("call", ["ON_STEP", "ON_GET", "ON_SET"])
@pytest.mark.parametrize("status", [-1, 6, 7, 16, 17, 18, 32, 99, 256, -(2**31), 2**31 - 1])
def test_a_status_that_fmi_does_not_know_ends_the_run_by_its_number(
    status: int, call: str, interpreted: bool, tmp_path: Path
) -> None:
    moody(tmp_path / "moody.fmu", **{call: f"if (m->steps > 2) return {status}"})
    parts = {"a": ("moody", "1 ms"), "b": ("moody", "1 ms")}
    plan = plan_of(tmp_path, tmp_path, parts, ["a.x -> b.u", "b.x -> a.u"], stop="9 ms")
    run = simulate(plan, interpreted)
    assert f" returned status {status}, which FMI does not know in the step to t = " in run.failure
    assert run.end <= 0.003


@everywhere
@pytest.mark.parametrize("status", [-1, 7, 99])
def test_so_does_one_before_the_loop(status: int, start: Start, tmp_path: Path) -> None:
    instance = start(Fmu.open(moody(tmp_path / "moody.fmu", ON_EXIT=f"return {status}")), "a")
    instance.begin(1.0)
    with pytest.raises(CallError, match=rf"cannot leave initialization \(status {status}, which FMI does not know\)"):
        instance.exit_initialization()
    assert instance.close() == ""


EARLY: dict[str, Callable[[Participant], Any]] = {
    "step from t = 0 s": lambda i: i.step(0.0, 1e-3),
    "leave initialization": lambda i: i.exit_initialization(),
    "get x": lambda i: i.get("x"),
}
LATE: dict[str, Callable[[Participant], Any]] = {
    "enter initialization": lambda i: i.enter_initialization(),
    "set up the experiment": lambda i: i.set_up(1.0),
    "leave initialization": lambda i: i.exit_initialization(),
}


@everywhere
def test_calls_out_of_turn_never_reach_the_fmu(start: Start, tmp_path: Path, log: Path) -> None:
    instance = start(Fmu.open(moody(tmp_path / "moody.fmu", ON_SET='told("set")', ON_STEP='told("step")')), "a")
    for what, call in EARLY.items():
        with pytest.raises(CallError) as error:
            call(instance)
        assert f"cannot {what} while it is instantiated (FMI 2.0, section 4.2.4)" in str(error.value)
    stepping(instance)
    for what, call in LATE.items():
        with pytest.raises(CallError) as error:
            call(instance)
        assert f"cannot {what} while it is between two steps" in str(error.value)
    with pytest.raises(CallError, match=r"cannot set k: it is a fixed parameter; after initialization only inputs"):
        instance.set("k", 3.0)
    assert instance.close() == ""
    with pytest.raises(CallError, match="it is freed"):
        instance.get("x")
    assert [word for word in told(log) if word in ("set", "step")] == []


def test_what_is_out_of_turn_can_be_tried_on_purpose(tmp_path: Path) -> None:
    instance = load(Fmu.open(moody(tmp_path / "moody.fmu")), "a")
    with instance.unguarded():
        instance.step(0.0, 1e-3)
    with pytest.raises(CallError):
        instance.exit_initialization()
    instance.close()


def test_get_after_set_between_steps_is_the_one_deviation() -> None:
    assert lifecycle.allowed(2, "get", State.INPUTS_SET) and frozenset({State.INPUTS_SET}) == lifecycle.GET_AFTER_SET
    strict = lifecycle.ALLOWED[2]["get"] - lifecycle.GET_AFTER_SET
    assert strict == {
        State.INITIALIZING, State.STEPPING, State.STEP_FAILED, State.STEP_CANCELED, State.TERMINATED, State.FAILED
    }  # fmt: skip


@pytest.mark.parametrize("version", [2, 3])
def test_nothing_is_allowed_behind_a_fatal_error_or_when_freed(version: int) -> None:
    for action, states in lifecycle.ALLOWED[version].items():
        assert not states & {State.DEAD, State.FREED}, action
        assert action in ("ask", "cancel") or State.STEP_PENDING not in states
    for state in State:
        assert lifecycle.allowed(version, "terminate", state) <= lifecycle.allowed(version, "free", state)


def test_a_step_is_final_only_where_nobody_goes_back(tmp_path: Path, log: Path) -> None:
    """fmi2DoStep's noSetFMUStatePriorToCurrentPoint: true in a plain run, false where steps are repeated."""
    moody(tmp_path / "moody.fmu", ON_STEP='told(final ? "final" : "open")')
    parts = {"a": ("moody", "1 ms"), "b": ("moody", "1 ms")}
    for algorithm, word in (("jacobi", "final"), ("iterated", "open")):
        log.unlink(missing_ok=True)
        run = simulate(
            plan_of(tmp_path, tmp_path, parts, ["a.x -> b.u", "b.x -> a.u"], stop="3 ms", algorithm=algorithm)
        )
        assert not run.failure and {w for w in told(log) if w in ("final", "open")} == {word}
    log.unlink()
    instance = stepping(load(Fmu.open(tmp_path / "moody.fmu"), "a"))
    instance.step(0.0, 1e-3)
    assert "open" in told(log)
    instance.close()


def test_a_requirement_is_looked_at_behind_initialization(tmp_path: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_EXIT="m->y = 7.0")
    read_system(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"=u": 0.0})}, stop="2 ms")
    path = tmp_path / "case.toml"
    path.write_text(
        path.read_text() + '[[require]]\nvalue = "a.y"\nmaximum = 1.0\nmessage = "y is too large"\n', encoding="utf-8"
    )
    from rovbrush.orchestrator.system.file.reader import load_system

    with pytest.raises(InputError, match=r"y is too large: a\.y = 7"):
        simulate(make_plan(load_system(str(path), tmp_path)))


@pytest.mark.parametrize("make", [feedthrough2, feedthrough3])
def test_a_restored_state_brings_its_mode_back(make: Callable[[Path], Path], tmp_path: Path) -> None:
    instance = stepping(load(Fmu.open(make(tmp_path / f"{make.__name__}.fmu")), "a"))
    kept = instance.save()
    instance.step(0.0, 1e-3)
    instance.set_all({"u": 1.0} if make is feedthrough2 else {"Float64_in": 1.0})
    assert instance.state is State.INPUTS_SET
    instance.restore(kept)
    assert instance.state is State.STEPPING
    instance.close()
