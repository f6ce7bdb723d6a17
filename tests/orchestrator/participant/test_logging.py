"""What FMUs log: what is asked of them, what it costs, where it is kept, and what is told where they are silent."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from helpers import system_text
from native_build import FAULTS2, FREE2, feedthrough2, moody, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.message_filter import AT_A_TIME, AT_FIRST
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.participant.messages import MOST, Messages
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.files.writing import MESSAGES, write_results
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
DECLARED = ("logAll", "logStatusWarning", "logStatusError", "logEvents")
here_and_there = pytest.mark.parametrize(
    "isolation",
    ["none", pytest.param("process", marks=pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork"))],
)


def plan(folder: Path, stop: str = "10 ms", extra: str = "", **actions: str) -> Plan:
    moody(folder / "m.fmu", **actions)
    text = system_text({"m": ("m.fmu", "1 ms", {"=u": 1.0})}, [], stop)
    path = folder / "case.toml"
    path.write_text(text.replace("[components.m]\n", f"[components.m]\n{extra}"), encoding="utf-8")
    return make_plan(load_system(str(path), folder))


def told(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("MOODY_LOG", str(folder / "told.txt"))
    return folder / "told.txt"


def test_an_fmu_is_asked_for_the_warnings_and_worse_that_it_declares(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = told(tmp_path, monkeypatch)
    load(Fmu.open(moody(tmp_path / "m.fmu", categories=DECLARED)), "m", "warnings").close()
    assert file.read_text().splitlines()[:2] == ["instantiate", "log logStatusWarning logStatusError"]


def test_an_fmu_that_declares_no_such_category_is_asked_for_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = told(tmp_path, monkeypatch)
    load(Fmu.open(moody(tmp_path / "m.fmu", categories=("logEvents",))), "m", "warnings").close()
    assert file.read_text().splitlines() == ["instantiate", "free"]


def test_logging_all_is_asked_for_and_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = told(tmp_path, monkeypatch)
    run = simulate(plan(tmp_path, "2 ms", 'logging = "all"\n', ON_STEP='say(fmi2OK, "steps", m->steps)'))
    assert file.read_text().splitlines()[1] == "log all"
    assert run.messages == ["m: OK [steps]: it is 1%", "m: OK [steps]: it is 2%"]


@here_and_there
def test_warnings_are_kept_with_category_and_arguments_and_the_rest_is_not(isolation: str, tmp_path: Path) -> None:
    act = 'say(fmi2OK, "steps", 1); if (m->steps == 2) say(fmi2Warning, "logStatusWarning", 2.5)'
    run = simulate(plan(tmp_path, "3 ms", f'isolation = "{isolation}"\n', ON_STEP=act))
    assert run.messages == ["m: Warning [logStatusWarning]: it is 2.5%"]


@here_and_there
def test_a_talkative_fmu_is_heard_at_first_and_counted_then(isolation: str, tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, "3 s", f'isolation = "{isolation}"\n', ON_STEP="say(fmi2Warning, 0, m->steps)"))
    kept = [line for line in run.messages if "Warning" in line]
    assert kept[0] == "m: Warning: it is 1%" and kept[AT_FIRST - 1] == f"m: Warning: it is {AT_FIRST}%"
    assert run.messages[-1] == f"m: {3000 - len(kept)} more messages, not kept"


def test_the_last_words_before_an_error_are_told_however_much_was_said_before(tmp_path: Path) -> None:
    chatter = f"for (int i = 0; i < {5 * AT_FIRST}; i++) say(fmi2Warning, 0, 1.0)"
    path = moody(tmp_path / "m.fmu", ON_ENTER=chatter, ON_STEP="say(fmi2Error, 0, 42.0); return fmi2Error")
    instance = load(Fmu.open(path), "m", "warnings")
    instance.begin(1.0)
    instance.exit_initialization()
    instance.look()
    with pytest.raises(FmuError, match="it is 42%"):
        instance.step(0.0, 0.1)
    assert AT_A_TIME > 1
    instance.close()
    assert instance.logged()[-1] == f"m: {4 * AT_FIRST + 1} more messages, not kept"


def test_an_fmu_that_forgets_its_environment_is_still_heard(tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, "1 ms", ON_STEP="callbacks.componentEnvironment = 0; say(fmi2Warning, 0, 7)"))
    assert run.messages == ["m: Warning: it is 7%"]


@here_and_there
def test_an_error_without_a_word_says_how_to_hear_one(isolation: str, tmp_path: Path) -> None:
    silent = simulate(plan(tmp_path, "1 ms", f'isolation = "{isolation}"\n', ON_STEP="return fmi2Error"))
    assert 'run again with logging = "all" under [components.m]' in silent.failure
    asked = simulate(
        plan(tmp_path, "1 ms", f'isolation = "{isolation}"\nlogging = "all"\n', ON_STEP="return fmi2Error")
    )
    assert "run again" not in asked.failure
    spoke = 'say(fmi2Error, "logStatusError", 3); return fmi2Error'
    talking = simulate(plan(tmp_path, "1 ms", f'isolation = "{isolation}"\n', ON_STEP=spoke))
    assert "run again" not in talking.failure and "it is 3%" in talking.failure


def test_an_fmu_that_refuses_in_silence_says_so_before_time_0(tmp_path: Path) -> None:
    with pytest.raises(FmuError, match='it gave no reason: run again with logging = "all"'):
        simulate(plan(tmp_path, ON_ENTER="return fmi2Error"))


def test_messages_lie_beside_the_rows_and_those_of_an_earlier_run_do_not(tmp_path: Path) -> None:
    loud = simulate(plan(tmp_path, "1 ms", ON_STEP="say(fmi2Warning, 0, 7)"))
    write_results(loud, tmp_path / "out", {})
    assert (tmp_path / "out" / MESSAGES).read_text() == "m: Warning: it is 7%\n"
    write_results(simulate(plan(tmp_path, "1 ms")), tmp_path / "out", {})
    assert not (tmp_path / "out" / MESSAGES).exists()


def test_messages_of_two_fmus_are_told_apart(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "f.fmu")
    parts = {n: ("f.fmu", "1 ms", {**FREE2, "fault": FAULTS2["warning"], "bad_at": 0.0}) for n in ("a", "b")}
    text = system_text(parts, [], "1 ms")
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    run = simulate(make_plan(load_system(str(tmp_path / "case.toml"), tmp_path)))
    assert [line.split(":")[0] for line in run.messages] == ["a", "b"]


@pytest.mark.parametrize(("extra", "expected"), [("", "1e-06"), ("tolerance = 1e-9\n", "1e-09")])
@here_and_there
def test_the_tolerance_of_the_system_file_comes_before_that_of_the_fmu(
    isolation: str, extra: str, expected: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = told(tmp_path, monkeypatch)
    simulate(plan(tmp_path, "1 ms", f'isolation = "{isolation}"\n{extra}'))
    assert f"setup tolerance={expected} start=0 stop=0.001" in file.read_text()


def test_so_many_messages_are_kept_and_one_line_each() -> None:
    messages = Messages("warnings")
    for k in range(MOST["warnings"] + 3):
        messages.add(1, "", f"first {k}\nsecond")
    lines = messages.lines("m", unread=4)
    assert len(lines) == MOST["warnings"] + 1 and lines[-1] == "m: 7 more messages, not kept"
    assert lines[0] == "m: Warning: first 0\n    second"


def test_an_instance_that_was_isolated_tells_its_messages_once(tmp_path: Path) -> None:
    instance = IsolatedInstance(Fmu.open(moody(tmp_path / "m.fmu", ON_ENTER="say(fmi2Warning, 0, 1)")), "m", 30.0)
    instance.begin(1.0)
    instance.exit_initialization()
    assert instance.logged() == ["m: Warning: it is 1%"]
    instance.close()
