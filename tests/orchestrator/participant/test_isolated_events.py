"""Event mode, clocks and partitions in a process of its own: the same bits, and its end is an error that names it."""

from __future__ import annotations

import os
from fractions import Fraction
from pathlib import Path

import exchange_build
import pytest
from clock_build import built, clocked
from clock_cases import CASES, SCHEDULED, run_case, same, same_tables
from helpers import plan_of, run_of
from native_build import FAULTS3, answers, feedthrough3, needs_gcc
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.base import AskedToEndError
from rovbrush.orchestrator.participant.here.event_mode import EventModeInstance
from rovbrush.orchestrator.participant.isolated.events import IsolatedEvents
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [
    needs_gcc,
    pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS"),
    pytest.mark.sampled(4),
]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("clocks"))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", [*CASES, *SCHEDULED])
def test_events_in_a_process_of_its_own_give_the_same_bits(name: str, tmp_path: Path, fmus: Path) -> None:
    case = (CASES | SCHEDULED)[name]
    here, there = run_case(case, tmp_path, fmus), run_case(case, tmp_path, fmus, isolation="process")
    assert not here.failure and not there.failure and same(here, there)


@pytest.mark.parametrize(("fault", "words"), [
    (1, "its process crashed with SIGSEGV"), (2, "its process did not answer within 1 s and was ended"),
    (3, "its process ended by itself with exit code 3"),
])  # fmt: skip
def test_what_ends_its_process_at_an_event_is_named_and_rows_are_kept(
    fault: int, words: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"s": ("trouble", "100 ms", {"fault": fault})}
    keys = {"isolation": "process", "timeout": "1 s"}
    run = simulate(plan_of(tmp_path, fmus, parts, stop="1 s", of={"s": keys}))
    assert run.failure.startswith("component s: its process") and words in run.failure
    assert "in the call `update discrete states`" in run.failure
    assert len(run.tables[0]) == 5 and [row.time for row in run.events][-1] == 0.5  # at 0, 0.1 ... 0.4 s


def test_it_answers_as_the_same_fmu_does_here(fmus: Path) -> None:
    """Whoever drives it by hand sees the same clocks, partitions and next instants."""
    fmu = Fmu.open(fmus / "countdown.fmu")
    here, there = EventModeInstance(fmu, "c"), IsolatedEvents(fmu, "c", 10.0)
    try:
        found = []
        for instance in (here, there):
            told: list[object] = []
            instance.begin(10.0)
            instance.exit_initialization()
            for _ in range(5):
                due = instance.next_instant() or Fraction(0)
                instance.enter_event_mode()
                told += [due, instance.happen(due), instance.active, instance.update(), instance.active]
                instance.leave_event_mode()
            state = instance.save()
            told.append(instance.next_instant())
            instance.enter_event_mode()
            told += [instance.happen(instance.next_instant() or Fraction(0)), instance.update()]
            instance.restore(state)
            told += [instance.next_instant(), instance.state]
            found.append(told)
        assert found[0] == found[1]
    finally:
        here.close()
        there.close()


def test_an_fmu_that_may_be_there_only_once_has_its_events_in_a_process_of_its_own(tmp_path: Path, fmus: Path) -> None:
    """The second one of a system, and the first one of a second run in this process."""
    once = 'canBeInstantiatedOnlyOncePerProcess="true"'
    clocked(tmp_path / "once.fmu", "controller", flags=once)
    plain, alone = (
        {"c": (fmu, "100 ms", {"k": 6.0}), "d": (fmu, "100 ms", {"k": 2.0}), "p": ("plant", "1 ms")}
        for fmu in ("controller", str(tmp_path / "once.fmu"))
    )
    wires = ["p.x -> c.y", "c.u -> d.y", "d.u -> p.u"]
    expected = run_of(tmp_path, fmus, plain, wires, stop="500 ms")
    for _ in range(2):
        found = run_of(tmp_path, fmus, alone, wires, stop="500 ms")
        assert same(expected, found)
    assert any("c runs in a process of its own" in note for note in found.notes)


def test_an_isolated_fmu_that_asks_to_end_is_one_that_does_so_here(tmp_path: Path) -> None:
    fmu = Fmu.open(feedthrough3(tmp_path / "asks.fmu"))
    instance = IsolatedInstance(fmu, "a", 10.0)
    try:
        instance.set_up(1.0)
        instance.set_own({"fault": FAULTS3["terminate"], "bad_at": 0.5})
        instance.enter_initialization()
        instance.exit_initialization()
        with pytest.raises(AskedToEndError, match="component a asked to end"):
            for k in range(10):
                instance.step(0.1 * k, 0.1)
    finally:
        instance.close()


EXCHANGE = {
    "alone": ("ball", ""),
    "driven": ("lag", 'connections = ["mass.x -> m.push", "m.x -> mass.F"]\n'),
}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("method", ["dormand-prince", "cvode", "rk4"])
@pytest.mark.parametrize("name", EXCHANGE)
def test_an_isolated_fmu_of_model_exchange_is_integrated_as_the_system_says(
    name: str, method: str, version: int, tmp_path: Path
) -> None:
    model, wires = EXCHANGE[name]
    exchange_build.exchange(tmp_path, model, version)
    answers(tmp_path / "mass.fmu", "mass")
    text = f'format = 2\nstop_time = "1 s"\n{wires}[solver]\ntolerance = 1e-9\nmethod = "{method}"\n'
    text += f'[components.m]\nfmu = "{model}.fmu"\nperiod = "10 ms"\n'
    text += '[components.mass]\nfmu = "mass.fmu"\nperiod = "10 ms"\nparameters = { x0 = 1.0 }\n'
    runs = []
    for key in ("", 'isolation = "process"\n'):
        (tmp_path / "system.toml").write_text(text.replace("[components.m]\n", f"[components.m]\n{key}"))
        plan = make_plan(load_system(str(tmp_path / "system.toml"), tmp_path))
        assert f"integrated by {method} (stated in the system file)" in explain(plan)
        runs.append(simulate(plan))
    assert not runs[0].failure and not runs[1].failure and same_tables(*runs)


def test_why_an_isolated_fmu_of_model_exchange_failed_is_told_as_here(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "moody")
    said = []
    for key in ("", 'isolation = "process"\n'):
        text = f'format = 2\nstop_time = "1 s"\n[components.m]\nfmu = "moody.fmu"\nperiod = "10 ms"\n{key}'
        (tmp_path / "system.toml").write_text(f"{text}parameters = {{ fault = 1 }}\n")
        said.append(simulate(make_plan(load_system(str(tmp_path / "system.toml"), tmp_path))).failure)
    assert said[0] == said[1] and "derivative der(x) is not finite" in said[0]
