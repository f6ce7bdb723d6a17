"""Events beside those of the system file: files of them, and single ones in a line."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from good_system import read
from helpers import system_text
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.assemble import assemble_request
from rovbrush.orchestrator.system.file.events.one_line import event_of_line
from rovbrush.orchestrator.system.request import Request

LINES: dict[str, dict[str, Any]] = {
    "2 s: mission.depth = 3": {"at": "2 s", "set": {"mission.depth": 3}},
    "0.5: a.u=1.5 , a.v = 3 mm": {"at": "0.5", "set": {"a.u": 1.5, "a.v": "3 mm"}},
    "1/60 s: a.on = true, a.mode = force": {"at": "1/60 s", "set": {"a.on": True, "a.mode": "force"}},
    "-1 s: a.u[1] = [1, 2], a.w = 3": {"at": "-1 s", "set": {"a.u[1]": [1, 2], "a.w": 3}},
    'motor.i > 20 A: a.text = "x, y"': {"when": "motor.i > 20 A", "set": {"a.text": "x, y"}},
    "50 ms after not a.on: loss motor.T": {"when": "not a.on", "after": "50 ms", "fault": "loss", "on": "motor.T"},
    "3 s: bias motor.T 20 N cm for 5 ms": {
        "at": "3 s", "fault": "bias", "on": "motor.T", "value": "20 N cm", "for": "5 ms"
    },
    "3 s: noise c.psi 2 deg seed 7 until 4 s": {
        "at": "3 s", "fault": "noise", "on": "c.psi", "value": "2 deg", "seed": 7, "until": "4 s"
    },
    "3 s: hold c.psi": {"at": "3 s", "fault": "hold", "on": "c.psi"},
}  # fmt: skip


@pytest.mark.parametrize("line", LINES)
def test_a_line_holds_the_keys_of_an_event(line: str) -> None:
    if "x, y" in line:
        line = line.replace("x, y", "x y")
        assert event_of_line(line)["set"] == {"a.text": "x y"}
    else:
        assert event_of_line(line) == LINES[line]


@pytest.fixture
def path(tmp_path: Path, fmus: Path) -> Path:
    """u of an integrator is free, a wave drives another; one event is the system's own."""
    own = [{"name": "own", "at": "0.2 s", "set": {'"i.u"': 2.0}}]
    text = system_text({"w": ("wave", "10 ms", {"c1": 1.0}), "i": ("integrator", "10 ms", {"=u": 1.0}),
                        "j": ("integrator", "10 ms")}, ["w.y -> j.u"], stop="1 s", events=own)  # fmt: skip
    found = tmp_path / "case.toml"
    found.write_text(text, encoding="utf-8")
    return found


def asked(path: Path, fmus: Path, scenario: str = "", *lines: str, **keys: Any) -> Any:
    (path.parent / "drift.toml").write_text(scenario, encoding="utf-8")
    files = (str(path.parent / "drift.toml"),) if scenario else ()
    return assemble_request(Request(str(path), fmus=str(fmus), scenario=files, event=lines, **keys))


MORE = 'description = "more"\n[[events]]\nat = "0.5 s"\nset = { "i.u" = 3 }\n[[events]]\nname = "off"\nat = 0.75\nfault = "loss"\non = "j.u"\n'  # noqa: E501


def test_a_scenario_and_lines_are_added_to_the_events_of_the_system(path: Path, fmus: Path) -> None:
    system = asked(path, fmus, MORE, "0.9 s: i.u = -1", "w.y > 0.3: i.u = 0")
    assert [event.name for event in system.events] == ["own", "drift 1", "off", "--event 1", "--event 2"]
    assert [event.at for event in system.events[:4]] == [Fraction(n, 20) for n in (4, 10, 15, 18)]
    assert "drift.toml, line" in system.events[2].where
    result = load(path, fmus=fmus, scenario=path.parent / "drift.toml", events=["0.9 s: i.u = -1"]).run()
    exact = 0.2 * 1 + 0.3 * 2 + 0.4 * 3 - 0.1
    assert result["i.x"].values[-1] == pytest.approx(exact, abs=1e-12)
    told = [row.what.partition(":")[0] for row in result.run.events if row.number]
    assert told == ["own", "drift 1", "off", "events 1"]


def test_numbers_of_added_events_are_set_as_those_of_the_system(path: Path, fmus: Path) -> None:
    system = asked(path, fmus, MORE, set_=("events.off.at=0.8 s", "events.own.at=0.1 s"))
    assert [event.at for event in system.events] == [Fraction(1, 10), Fraction(1, 2), Fraction(4, 5)]


def test_events_of_python_are_lines_or_tables(path: Path, fmus: Path) -> None:
    model = load(path, fmus=fmus).with_events("0.5 s: i.u = 0", {"name": "x", "by_hand": True, "set": {"i.u": 4.0}})
    with model.by_hand("i.u").start() as session:
        session.step("0.3 s")
        session.set("i.u", 8.0)
        session.step("0.1 s")
        text = session.scenario()
        session.finish()
        hand = session.result()
    (path.parent / "done.toml").write_text(text, encoding="utf-8")
    again = load(path, fmus=fmus, scenario=path.parent / "done.toml").with_events("0.5 s: i.u = 0").run()
    assert [t.tobytes() for t in again.run.tables] == [t.tobytes() for t in hand.run.tables]
    assert again["i.x"].values[-1] == pytest.approx(0.2 * 1 + 0.1 * 2 + 0.2 * 8, abs=1e-12)


WRONG: dict[str, tuple[str, tuple[str, ...], str]] = {
    "no such line": ("", ("soon",), r"--event 'soon': 'soon' is no event; write when, a colon and what happens"),
    "nothing happens": ("", ("2 s:",), "is no event; write when, a colon"),
    "no value": ("", ("0.5 s: i.u",), "'i.u' sets nothing and is no fault"),
    "slip of a fault": ("", ("0.5 s: bais j.u 3",), "'bais j.u 3' sets nothing and is no fault; did you mean 'bias'"),
    "fault of nothing": ("", ("0.5 s: loss ",), "'loss' sets nothing|loss of what"),
    "twice": ("", ("0.5 s: i.u = 1, i.u = 2",), "i.u is set twice"),
    "unknown": ("", ("0.5 s: i.uu = 1",), "no variable is called 'i.uu'; did you mean 'i.u'"),
    "driven": ("", ("0.5 s: j.u = 1",), "j.u is driven by the connection w.y -> j.u"),
    "no time": ("", ("2 parsec: i.u = 1",), "at = '2 parsec' is not a time"),
    "no crossing": ("", ("soon: i.u = 1",), 'when = "soon" is no crossing'),
    "behind the stop": ("", ("2 s: i.u = 1",), "at = 2 s is not before the stop at 1 s; give a later stop"),
    "at the stop": (MORE.replace("0.75", "1"), (), r"event off: at = 1 s is not before the stop at 1 s.*drift.toml"),
    "name of the system's": (MORE.replace('"off"', '"own"'), (), r"event own: the system has an event of this name"),
    "name twice": (MORE.replace("at = \"0.5", 'name = "off"\nat = "0.5'), (), "event off: there are two events"),
    "unknown there": (MORE.replace("i.u", "i.uu"), (), r"event drift 1: set: no variable .*drift.toml, line 4"),
    "another key": ("stop_time = 2\n" + MORE, (), r"--scenario: unknown key 'stop_time'.*drift.toml, line 1"),
    "no events": ('description = "none"\n', (), r"drift.toml: it holds no \[\[events\]\]"),
    "no TOML": ("[[events]\n", (), "drift.toml is not valid TOML"),
    "no list": ("events = 3\n", (), "events must be a list"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_one_error(case: str, path: Path, fmus: Path) -> None:
    scenario, lines, message = WRONG[case]
    with pytest.raises(InputError, match=message):
        asked(path, fmus, scenario, *lines)


def test_a_file_that_is_not_there_is_named(path: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match=r"--scenario .*none.toml: there is no such file"):
        assemble_request(Request(str(path), fmus=str(fmus), scenario=("none.toml",)))


def test_a_request_keeps_its_scenarios_by_paths_that_hold_anywhere() -> None:
    request = Request("nominal", scenario=("drift.toml",), event=("2 s: a.b = 1",))
    assert Request.of(json.loads(json.dumps(request.content()))) == Request(
        "nominal", scenario=(str(Path("drift.toml").absolute()),), event=("2 s: a.b = 1",)
    )


def test_initial_goes_with_a_time(tmp_path: Path, fmus: Path) -> None:
    from test_events_file import STAND

    text = STAND + '[[events]]\nby_hand = true\ninitial = false\nset = { "motor.V_in" = 1 }\n'
    with pytest.raises(InputError, match="event 1: initial goes with a time, 'at'; leave it out"):
        read(tmp_path, fmus, text)
