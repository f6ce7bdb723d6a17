"""What was set counts, and what was promised is kept: parameters read back, no time behind the stop."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from helpers import plan_of, read_system
from native_build import FREE3, feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.types import TYPES
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.start.read_back import same
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
here_and_there = pytest.mark.parametrize("isolation", ["none", pytest.param("process", marks=needs_fork)])


def plan(folder: Path, isolation: str = "none", **actions: str) -> Plan:
    moody(folder / "m.fmu", **actions)
    path = read_system(folder, folder, {"m": ("m.fmu", "1 ms", {"k": 0.1, "=u": 1.0})}, stop="2 ms").path
    path.write_text(path.read_text().replace("[components.m]\n", f'[components.m]\nisolation = "{isolation}"\n'))
    return make_plan(load_system(str(path), folder))


LOST = {
    "put back when initialization begins": {"ON_ENTER": "m->k = 1.0"},
    "put back when initialization ends": {"ON_EXIT": "m->k = 1.0"},
    "never taken": {"ON_SET": "if (r[0] == K) return fmi2OK"},
    "clipped": {"ON_SET": "if (r[0] == K) { m->k = 0.2; return fmi2OK; }"},
    "kept with too few digits": {"ON_SET": "if (r[0] == K) { m->k = (float)v[0]; return fmi2OK; }"},
}


@pytest.mark.parametrize("actions", LOST.values(), ids=LOST.keys())
@here_and_there
def test_a_parameter_that_is_not_what_was_set_is_an_error_with_both_values(
    isolation: str, actions: dict[str, str], tmp_path: Path
) -> None:
    with pytest.raises(FmuError, match=r"component m: parameter k was set to 0\.1 and is (1\.0|0\.2|0\.1000\d+) after"):
        simulate(plan(tmp_path, isolation, **actions))


@pytest.mark.parametrize("actions", [{}, {"ON_SETUP": "m->k = 1.0"}, {"ON_EXIT": "m->k *= 1.0 + 2.3e-16"}])
def test_one_that_was_kept_but_for_its_rounding_is_none(actions: dict[str, str], tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, **actions))
    assert not run.failure and not run.notes


@here_and_there
def test_one_that_cannot_be_read_is_a_note(isolation: str, tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, isolation, ON_GET="if (r[0] == K) return fmi2Error"))
    assert not run.failure and run.ended == ""
    assert len(run.notes) == 1 and "component m: parameter k cannot be read back" in run.notes[0]


@pytest.mark.parametrize(
    ("kind", "value", "found", "expected"),
    [
        ("Float32", 0.1, 0.10000000149011612, True), ("Float32", 0.1, 0.1001, False),
        ("Float64", 0.1, 0.10000000149, False), ("Float64", 0.0, 0.0, True), ("Float64", 0.0, 1e-300, False),
        ("Int64", 2**53 + 1, 2**53, False), ("Boolean", True, True, True), ("String", "a", "a ", False),
    ],
)  # fmt: skip
def test_values_are_one_where_their_type_cannot_tell_them_apart(
    kind: str, value: float | str, found: float | str, expected: bool
) -> None:
    assert same(TYPES[3][kind], value, found) is expected


def test_parameters_of_arrays_come_back_from_an_fmi_3_fmu(tmp_path: Path) -> None:
    feedthrough3(tmp_path / "f.fmu")
    system = read_system(tmp_path, tmp_path, {"f": ("f", "1 ms", {**FREE3, "M": [4.0, 3.0, 2.0, 1.0]})}, stop="2 ms")
    assert not simulate(make_plan(system)).failure


BEYOND = "if (t + h > m->promised) return fmi2Error"
STOPS = [("0.3 s", "0.1 s"), ("0.7 s", "1/60 s"), ("0.7 s", "0.1 s"), ("1.1 s", "0.1 s"), ("7 s", "0.07 s")]


@pytest.mark.sampled(8)
@pytest.mark.parametrize(("stop", "period"), STOPS)
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "iterated"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_no_step_ends_behind_the_stop_that_was_promised(
    interpreted: bool, algorithm: str, stop: str, period: str, tmp_path: Path
) -> None:
    moody(tmp_path / "m.fmu", ON_STEP=BEYOND)
    parts = {"m": ("m", period, {"=u": 1.0})}
    assert not simulate(plan_of(tmp_path, tmp_path, parts, stop=stop, algorithm=algorithm), interpreted).failure


@pytest.mark.parametrize("steps", [3, 7, 10, 49])
def test_nor_does_one_of_a_driver_in_python(steps: int, tmp_path: Path) -> None:
    h = 0.1
    instance = load(Fmu.open(moody(tmp_path / "m.fmu", ON_STEP=BEYOND)), "m")
    instance.begin(steps / 10)
    instance.exit_initialization()
    for k in range(steps):
        instance.step(k * h, h)
    assert instance.close() == ""
