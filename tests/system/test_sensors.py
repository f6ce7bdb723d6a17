"""Sensors between vehicle and controller: as built nobody notices them; with errors and delay the loop does."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column
from rovbrush.components.rov_sensors.parameters import NOMINAL
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.shipped import SYSTEMS

STATION = (SYSTEMS / "station_keeping.toml").read_text(encoding="utf-8")
SETTINGS = re.compile(r"\[components\.sensors\.parameters\]\n(?:.+\n)*")
MOTION = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r", "thrust[1]", "thrust[5]")


def station(fmus: Path, folder: Path, text: str, **changes: float) -> Run:
    """Four seconds of a variant of `station_keeping`."""
    path = folder / "station.toml"
    path.write_text(text, encoding="utf-8")
    return run_of(fmus, str(path), "4 s", **changes)


def run_of(fmus: Path, system: str, stop: str, **changes: float) -> Run:
    run = simulate(make_plan(assemble(system, {f"sensors.{k}": v for k, v in changes.items()}, stop, fmus)))
    assert not run.failure, run.failure
    return run


def test_block_of_the_readme_is_that_of_the_system() -> None:
    guide = (Path(__file__).parents[2] / "components" / "rov_sensors" / "README.md").read_text(encoding="utf-8")
    values = [re.findall(r"^(\w+ = [^#\n]*?) *(?:#.*)?$", SETTINGS.findall(text)[0], re.M) for text in (guide, STATION)]
    assert values[0] == values[1]
    assert {line.split(" = ")[0] for line in values[0]} <= set(vars(NOMINAL))


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_sensors_as_they_are_built_change_no_bit(algorithm: str, fmus: Path, tmp_path: Path) -> None:
    text = SETTINGS.sub("", STATION).replace("gauss-seidel", algorithm)
    names = {"F_tool": "F_disturb", "M_tool": "M_disturb"}
    direct = re.sub(r'  "vehicle\.\w+ -> sensors.*\n', "", text)
    direct = re.sub(r"sensors\.(\w+)_m ->", lambda found: f"vehicle.{names.get(found[1], found[1])} ->", direct)
    direct = re.sub(r"\[components\.sensors\]\n(?:.+\n)*", "", direct).replace('"sensors", ', "")
    direct = direct.replace(', "sensors.y_n_m"', "")
    direct = re.sub(r'"sensors\.\w+", ?', "", direct)
    if algorithm == "jacobi":
        text, direct = (re.sub(r"order = .*\n", "", one) for one in (text, direct))
    with_sensors, without = station(fmus, tmp_path, text), station(fmus, tmp_path, direct)
    for name in MOTION:
        seen, expected = (column(run, f"vehicle.{name}")[1] for run in (with_sensors, without))
        np.testing.assert_array_equal(seen, expected, err_msg=name)


def test_station_is_kept_within_millimetres(fmus: Path, measured: Measured) -> None:
    run = run_of(fmus, "station_keeping", "20 s")
    t, x = column(run, "vehicle.x_n")
    rms = float(np.sqrt(np.mean(x[t > 10.0] ** 2)))
    # The bias of the DVL alone, over the position gain of 1/s, is 1 mm.
    measured("station_keeping: distance from the station (rms, mm)", 1e3 * rms, "2")
    assert rms < 2e-3


def test_a_longer_delay_makes_the_vehicle_swing(fmus: Path) -> None:
    rates = []
    for delay in (0.0, 0.1):
        t, q = column(run_of(fmus, "station_keeping", "10 s", delay=delay), "vehicle.q")
        rates.append(float(np.sqrt(np.mean(q[t > 5.0] ** 2))))
    assert rates[0] < 0.02
    assert rates[1] > 0.5


def test_another_seed_gives_another_run(fmus: Path) -> None:
    one, other = (column(run_of(fmus, "station_keeping", "1 s", seed=seed), "sensors.u_m")[1] for seed in (1, 2))
    assert np.mean(one[5:] != other[5:]) > 0.9
