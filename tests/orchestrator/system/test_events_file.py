# ruff: noqa: E501  one row per case
"""Events in a system file: what is read, in which units, and every way to write them wrong."""

from __future__ import annotations

import json
import zipfile
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from good_system import read
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_of
from rovbrush.orchestrator.plan.happening.scenario import check_scenario
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import apply_changes
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.request import Changes
from rovbrush.orchestrator.system.ssp.write import write_ssp

STAND = """\
format = 2
stop_time = "0.05 s"
connections = ["motor.omega_b -> brush.omega_b", "brush.T_brush -> motor.T_brush"]
[components.motor]
fmu = "dc_motor"
period = "0.5 ms"
inputs = { V_in = 12.0 }
[components.brush]
fmu = "filament_brush"
period = "0.5 ms"
inputs = { delta = 0.005, delta_dot = 0.0, v_rov = 0.05, friction_scale = 1.0, tilt_x = 0.0 }
"""
SET = '[[events]]\nat = "20 ms"\nset = { "brush.delta" = "3 mm", "motor.V_in" = 10 }\n'
FAULT = '[[events]]\nname = "drag"\nwhen = "motor.i > 20 A"\nafter = "1 ms"\nfault = "bias"\non = "motor.T_brush"\nvalue = "20 N cm"\nfor = "5 ms"\n'


def test_values_and_times_are_read_with_their_units(tmp_path: Path, fmus: Path) -> None:
    first, second = read(tmp_path, fmus, STAND + SET + FAULT).events
    assert first.name == "event 1" and first.at == Fraction(1, 50)
    assert dict(first.settings) == {("brush", "delta"): 0.003, ("motor", "V_in"): 10.0}
    assert second.when is not None and (second.when.signal, second.when.threshold, second.when.rising) == (
        ("motor", "i"),
        20.0,
        True,
    )
    assert second.fault is not None and dict(second.fault.values) == {("motor", "T_brush"): 0.2}
    assert (second.after, second.lasting, second.repeat) == (Fraction(1, 1000), Fraction(1, 200), False)


def test_a_fault_on_an_output_is_one_on_all_that_it_drives(tmp_path: Path, fmus: Path) -> None:
    event = read(
        tmp_path, fmus, STAND + FAULT.replace("motor.T_brush", "motor.omega_b").replace("20 N cm", "60 rpm")
    ).events[0]
    assert event.fault is not None and event.inputs == (("brush", "omega_b"),)
    assert event.fault.values["brush", "omega_b"] == pytest.approx(6.283185307179586)


WRONG: dict[str, tuple[str, str, str, list[str]]] = {
    "neither time nor crossing": (SET, 'at = "20 ms"\n', "", ["event 1: it needs either a time", "case.toml, line 12"]),
    "both": (SET, 'at = "20 ms"\n', 'at = "20 ms"\nwhen = "motor.i > 1"\n', ["event 1: it needs either a time"]),
    "neither set nor fault": (SET, SET[SET.index("set") :], "", ["event 1: it needs either values to set"]),
    "no time": (SET, '"20 ms"', '"soon"', ["event 1: at = 'soon' is not a time", "line 13"]),
    "unknown key": (SET, "at =", "att =", ["event 1: unknown key 'att'; did you mean 'at'?", "line 13"]),
    "empty set": (SET, SET[SET.index("set") :], "set = {}\n", ["it needs either values to set"]),
    "set no table": (SET, SET[SET.index("set") :], "set = 3\n", ["event 1: set must be a table", "line 14"]),
    "unknown variable": (SET, "brush.delta", "brush.detla", ["event 1: set: no variable is called 'brush.detla'; did you mean 'brush.delta'?", "line 14"]),
    "unknown component": (SET, "brush.delta", "brusch.delta", ["no variable is called 'brusch.delta'; did you mean 'brush.delta'?"]),
    "driven input": (SET, '"motor.V_in"', '"motor.T_brush"', ["motor.T_brush is driven by the connection brush.T_brush -> motor.T_brush", 'fault and on = "motor.T_brush"']),
    "output": (SET, '"motor.V_in"', '"motor.i"', ["set: motor.i is of causality output and variability continuous; only inputs and tunable parameters"]),
    "fixed parameter": (SET, '"motor.V_in"', '"motor.R"', ["set: motor.R is of causality parameter and variability fixed; only inputs and tunable parameters"]),
    "wrong unit": (SET, '"3 mm"', '"3 kg"', ["event 1: set: brush.delta = 3 kg", "line 14"]),
    "not a finite number": (SET, '"3 mm"', "nan", ["event 1: set: brush.delta = nan is not a finite number"]),
    "text": (SET, '"3 mm"', '"deep"', ["event 1: set: brush.delta = deep is not a finite number"]),
    "after a time": (SET, "set =", 'after = "1 ms"\nset =', ["event 1: after goes with a crossing"]),
    "every time": (SET, "set =", "repeat = true\nset =", ["event 1: repeat goes with a crossing"]),
    "set for a while": (SET, "set =", 'for = "1 ms"\nset =', ["event 1: for goes with a fault", "a second event can set the values back"]),
    "value of no fault": (SET, "set =", "value = 1\nset =", ["event 1: value goes with a fault"]),
    "two of a name": (FAULT, FAULT, FAULT + FAULT, ["event drag: there are two events of this name"]),
    "no crossing": (FAULT, "motor.i > 20 A", "motor.i", ['event drag: when = "motor.i" is no crossing', "line 14"]),
    "other comparison": (FAULT, "motor.i > 20 A", "motor.i >= 20 A", ["is no crossing"]),
    "two signals": (FAULT, "motor.i > 20 A", "motor.i > motor.T_motor", ["event drag: when: 'motor.T_motor' is no number that motor.i could cross"]),
    "unknown signal": (FAULT, "motor.i >", "motor.ii >", ["event drag: when: no variable is called 'motor.ii'; did you mean 'motor.i'?"]),
    "input watched": (FAULT, "motor.i > 20 A", "motor.T_brush > 1", ["motor.T_brush is an input; take the output that drives it, brush.T_brush"]),
    "parameter watched": (FAULT, "motor.i > 20 A", "motor.R > 1", ["motor.R is of causality parameter and type Real; take a numeric output or local"]),
    "wrong unit of a crossing": (FAULT, "20 A", "20 V", ["event drag: when: motor.i = 20 V"]),
    "not finite": (FAULT, "20 A", "inf", ["'inf' is no number that motor.i could cross"]),
    "unknown fault": (FAULT, '"bias"', '"bais"', ["event drag: unknown fault 'bais'; did you mean 'bias'?", "line 16"]),
    "fault of nothing": (FAULT, 'on = "motor.T_brush"\n', "", ['event drag: fault = "bias" needs on = "component.input"', "line 16"]),
    "unknown signal to break": (FAULT, 'on = "motor.T_brush"', 'on = "motor.T_bruch"', ["on: no variable is called 'motor.T_bruch'; did you mean 'motor.T_brush'?"]),
    "free input to break": (FAULT, 'on = "motor.T_brush"', 'on = "motor.V_in"', ["on: motor.V_in cannot break: no connection drives it; set it instead"]),
    "output that drives nothing": (FAULT, 'on = "motor.T_brush"', 'on = "motor.i"', ["on: motor.i cannot break: it drives no input"]),
    "no value": (FAULT, 'value = "20 N cm"\n', "", ['event drag: fault = "bias" needs a value']),
    "value of hold": (FAULT, '"bias"', '"hold"', ['event drag: fault = "hold" needs no value; leave it out']),
    "unit of a factor": (FAULT, '"bias"', '"scale"', ["value = '20 N cm' is no finite number without a unit"]),
    "wrong unit of a value": (FAULT, "20 N cm", "20 A", ["event drag: value = 20 A"]),
    "value not finite": (FAULT, '"20 N cm"', "inf", ["event drag: value = inf is no finite number"]),
    "value a switch": (FAULT, '"20 N cm"', "true", ["event drag: value = True is no finite number"]),
    "negative deviation": (FAULT, '"bias"\non = "motor.T_brush"\nvalue = "20', '"noise"\non = "motor.T_brush"\nvalue = "-20', ["the standard deviation of the noise and cannot be negative"]),
    "seed of no noise": (FAULT, "value =", "seed = 3\nvalue =", ['seed goes with fault = "noise"']),
    "seed no whole number": (FAULT, "value =", "seed = 1.5\nvalue =", ["seed", "must be a whole number from 0 to 2^63 - 1"]),
    "seed too large": (FAULT, "value =", "seed = 9223372036854775808\nvalue =", ["must be a whole number from 0 to 2^63 - 1"]),
    "two ends": (FAULT, "for =", 'until = "1 s"\nfor =', ["either 'until' or 'for' says how long it lasts"]),
    "end before the beginning": (FAULT, 'when = "motor.i > 20 A"\nafter = "1 ms"', 'at = "1 s"', []),
    "for no time": (FAULT, '"5 ms"', '"-5 ms"', ["event drag: for = -5 ms is not a positive time"]),
    "events no list": (SET, "[[events]]", "[events]", ["events must be a list"]),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_one_error_that_says_what_and_where(case: str, tmp_path: Path, fmus: Path) -> None:
    block, old, new, words = WRONG[case]
    assert old in block
    text = block.replace(old, new, 1)
    if case == "end before the beginning":
        text, words = text.replace('for = "5 ms"', 'until = "1 ms"'), ["event drag: until = 1 ms is not after at = 1 s"]
    with pytest.raises(InputError) as error:
        read(tmp_path, fmus, STAND + text)
    assert "case.toml" in str(error.value)
    for word in words:
        assert word in str(error.value)


def test_an_input_that_follows_a_table_is_not_set_too(tmp_path: Path, fmus: Path) -> None:
    table = STAND.replace("V_in = 12.0", "V_in = { time = [0, 1], values = [12, 12] }")
    with pytest.raises(InputError, match=r"event 1: set: motor\.V_in follows .*; remove that, or write it there"):
        read(tmp_path, fmus, table + SET)
    system = read(tmp_path, fmus, STAND + SET)
    motor = system.components["motor"]
    followed = read(tmp_path, fmus, table).components["motor"].series["V_in"]
    with pytest.raises(InputError, match=r"event 1 sets motor\.V_in, which follows .* \(case\.toml, line 1[234]\)"):
        make_plan(system.with_component(motor.with_series("V_in", followed)))


def test_noise_cannot_be_judged_by_doing_a_step_twice(tmp_path: Path, fmus: Path) -> None:
    noise = FAULT.replace('"bias"', '"noise"')
    system = replace(read(tmp_path, fmus, STAND + noise), algorithm="adaptive")
    with pytest.raises(InputError, match="event drag: algorithm 'adaptive' judges a step by doing it twice"):
        make_plan(system)


def test_events_come_back_from_an_ssp_and_do_the_same(tmp_path: Path, fmus: Path) -> None:
    system = read(tmp_path, fmus, STAND + SET + FAULT)
    path = write_ssp(system, tmp_path / "stand.ssp")
    with zipfile.ZipFile(path) as archive:
        assert json.dumps("motor.i > 20 A")[1:-1] in archive.read("SystemStructure.ssd").decode().replace("&gt;", ">")
    again = load_system(str(path))
    assert [replace(event, where="") for event in again.events] == [replace(event, where="") for event in system.events]
    runs = [simulate(make_plan(one)) for one in (system, again)]
    assert [row[:3] for row in runs[0].events] == [row[:3] for row in runs[1].events] != []
    assert runs[0].tables[0].tobytes() == runs[1].tables[0].tobytes()


def test_a_container_refuses_events(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match=r"a container cannot hold events, and the system has event 1 \(case"):
        write_container(read(tmp_path, fmus, STAND + SET), tmp_path / "c.fmu")


def test_what_is_solved_inside_the_group_of_model_exchange_cannot_break(tmp_path: Path, fmus: Path) -> None:
    system = read(tmp_path, fmus, STAND + FAULT)
    for name in ("motor", "brush"):
        component = system.components[name]
        system = system.with_component(replace(component, fmu=replace(component.fmu, kind="model-exchange")))
    with pytest.raises(InputError, match=r"event drag: brush.T_brush -> motor.T_brush is solved inside the group"):
        check_scenario(system, algorithm_of(system))


def test_events_are_checked_anew_where_a_component_is_replaced(tmp_path: Path, fmus: Path) -> None:
    system = read(tmp_path, fmus, STAND + SET + FAULT)
    same = apply_changes(system, Changes(fmus=(("motor", str(fmus / "dc_motor.fmu")),)))
    assert [replace(event, where="") for event in same.events] == [replace(event, where="") for event in system.events]
    drive = Changes(fmus=(("motor", str(fmus / "constant_speed.fmu")),))
    with pytest.raises(InputError, match=r"event drag: when: no variable is called 'motor\.i'"):
        apply_changes(system, drive)
