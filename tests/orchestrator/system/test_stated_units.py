"""Units that an FMU leaves out can be stated; then they are checked and converted like any other."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import last
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.write import write_ssp

SYSTEM = """\
stop_time = "1 s"
connections = ["a.y -> b.u"]
[components.a]
fmu = "plain"
period = "10 ms"
inputs = { u = 0.0, temperature = 0.0, speed = 0.0 }
UNITS
[components.b]
fmu = "plain"
period = "10 ms"
inputs = { temperature = 0.0, speed = 0.0 }
units = { u = "s" }
"""


def system_of(folder: Path, fmus: Path, units: str) -> System:
    path = folder / "case.toml"
    path.write_text(SYSTEM.replace("UNITS", units), encoding="utf-8")
    return load_system(str(path), fmus)


def received(system: System) -> float:
    run = simulate(make_plan(system))
    assert not run.failure
    return last(run, "b.u")


def test_a_stated_unit_is_converted(tmp_path: Path, fmus: Path) -> None:
    assert received(system_of(tmp_path, fmus, "")) == 1.0  # nothing stated: taken as it is
    assert received(system_of(tmp_path, fmus, 'units = { y = "ms" }')) == 1e-3


def test_units_can_stand_in_a_file_of_their_own_and_travel_in_an_ssp(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "units.toml").write_text('y = "ms"\n')
    system = system_of(tmp_path, fmus, 'units = "units.toml"')
    assert received(system) == 1e-3
    write_ssp(system, tmp_path / "case.ssp")
    travelled = load_system(str(tmp_path / "case.ssp"))
    assert dict(travelled.components["a"].fmu.units) == {"y": "ms"}
    assert received(travelled) == 1e-3


@pytest.mark.parametrize(
    ("units", "hint"),
    [
        ('units = { y = "N" }', "the units do not fit: N cannot become s"),
        ('units = { yy = "s" }', "plain.fmu has no such variable; did you mean 'y'?"),
        ('units = { y = "furlong/fortnite" }', "is not understood"),
        ('units = { flag = "s" }', "is of type Boolean, which has no unit"),
        ("units = 3", "units must be a table, or the name of a file"),
        ('units = "nowhere.toml"', "cannot be read"),
    ],
)
def test_wrong_units_say_what_and_where(units: str, hint: str, tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(InputError) as error:
        system_of(tmp_path, fmus, units)
    assert hint in str(error.value)


def test_a_unit_that_contradicts_the_fmu_is_refused(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(
        'stop_time = "1 s"\n[components.g]\nfmu = "gain"\nperiod = "1 ms"\ninputs = { u = 1.0 }\nunits = { y = "N" }\n'
    )
    with pytest.raises(InputError, match=r"gain.fmu states 1 itself; remove 'N' \(case.toml, line 6\)"):
        load_system(str(path), fmus)
