"""Every file that people write has one reader: a slip of any kind is one error, with file, line and nearest name."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.recordings.shipped import RUNS, read_runs
from rovbrush.orchestrator.paper.specification import SPECIFICATION, read_specification
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_of
from rovbrush.orchestrator.studies.sweep.file import SWEEPS, sweep_file
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.shipped import SYSTEMS
from rovbrush.orchestrator.system.replace.mapping import load_mapping

STAND = (SYSTEMS / "test_stand.toml").read_text(encoding="utf-8")
SYSTEM = STAND.replace('parameters = "paper"', 'parameters = "beside.toml"')
CALIBRATED = (SYSTEMS / "paper.toml").read_text(encoding="utf-8")
MAPPING = """\
[variables]
V_in = "supply.voltage"
torque = { name = "tau", sign = -1, unit = "N.m" }
[parameters]
gain = 1.0
"""
UNITS = SYSTEM.replace('fmu = "dc_motor"', 'fmu = "dc_motor"\nunits = "units.toml"')


def write(tmp_path: Path, name: str, text: str) -> Path:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


def system(tmp_path: Path, fmus: Path, text: str) -> Any:
    write(tmp_path, "beside.toml", CALIBRATED)
    return algorithm_of(load_system(str(write(tmp_path, "case.toml", text)), fmus))


def parameters(tmp_path: Path, fmus: Path, text: str) -> Any:
    path = write(tmp_path, "stand.toml", SYSTEM.replace('"beside.toml"', '"case.toml"'))
    write(tmp_path, "case.toml", text)
    return load_system(str(path), fmus)


def units(tmp_path: Path, fmus: Path, text: str) -> Any:
    write(tmp_path, "beside.toml", CALIBRATED)
    write(tmp_path, "case.toml", text)
    path = write(tmp_path, "stand.toml", UNITS.replace('"units.toml"', '"case.toml"'))
    return load_system(str(path), fmus)


def alone(read: Callable[[Path], Any]) -> Callable[[Path, Path, str], Any]:
    return lambda tmp_path, _fmus, text: read(write(tmp_path, "case.toml", text))


def own(path: Path) -> str:
    return path.read_text(encoding="utf-8")


SETTINGS = SYSTEM + '\n[iteration]\ntolerance = 1e-6\nmethod = "aitken"\n[ecco]\nminimum = "1 ms"\n'
READERS: dict[str, tuple[Callable[[Path, Path, str], Any], str]] = {
    "system": (system, SYSTEM),
    "settings": (system, SETTINGS),
    "parameter": (parameters, CALIBRATED),
    "unit": (units, 'T_brush = "N.m"\n'),
    "mapping": (alone(load_mapping), MAPPING),
    "sweep": (alone(lambda path: sweep_file(str(path))), own(SWEEPS / "friction.toml")),
    "calibration": (alone(read_specification), own(SPECIFICATION)),
    "recordings": (alone(read_runs), own(RUNS)),
}
# reader, what stands there, what is written instead, what is told before the place
SLIPS = {
    "system: unknown key": ("system", "stop_time =", "stop_tine =", "did you mean 'stop_time'?"),
    "system: wrong type": ("system", "connections = [", "record = 3\nconnections = [", "record must be a list"),
    "system: wrong place": ("system", "connections = [", 'period = "1 ms"\nconnections = [', "unknown key 'period'"),
    "component: unknown key": ("system", 'fmu = "dc_motor"', 'fmu = "dc_motor"\nperid = 1', "did you mean 'period'?"),
    "component: wrong place": ("system", 'fmu = "dc_motor"', 'fmu = "dc_motor"\nalgorithm = "jacobi"', "'algorithm'"),
    "settings: unknown key": ("settings", "tolerance", "tolerence", "did you mean 'tolerance'?"),
    "settings: wrong type": ("settings", "1e-6", '"small"', "iteration: tolerance = 'small' must be a number above 0"),
    "settings: wrong range": ("settings", "1e-6", "inf", "iteration: tolerance = inf must be a number above 0"),
    "settings: wrong word": ("settings", '"aitken"', '"aitkin"', "unknown method 'aitkin'; did you mean 'aitken'?"),
    "settings: wrong time": ("settings", '"1 ms"', "true", "ecco: minimum"),
    "settings: wrong place": ("settings", "minimum =", "max_iterations = 3\nminimum =", "ecco: unknown key"),
    "settings: misfit": ("settings", "minimum =", "grow = 0.5\nminimum =", "ecco: shrink = 0.2 must be below 1"),
    "parameter: unknown key": ("parameter", "\nk_v =", "\nk_w =", "k_w"),
    "parameter: wrong type": ("parameter", "\nk_v =", "\nk_v = {}\nk_z =", "brush: k_v must be"),
    "parameter: wrong place": ("parameter", "\n[", "\nk_c = 1.0\n[", "'k_c' must be a table of values"),
    "parameter: unknown table": ("parameter", "[brush]", "[bursh]", "no component 'bursh'; did you mean 'brush'?"),
    "unit: unknown key": ("unit", "T_brush", "T_brsh", "did you mean 'T_brush'?"),
    "unit: wrong type": ("unit", '"N.m"', "5", "unit of T_brush must be text"),
    "unit: wrong place": ("unit", "T_brush", "[motor]\nT_brush", "unit of motor must be text"),
    "mapping: unknown key": ("mapping", "sign =", "sing =", "did you mean 'sign'?"),
    "mapping: wrong type": ("mapping", "sign = -1", 'sign = "-"', "torque: sign = '-' must be 1 or -1"),
    "mapping: wrong range": ("mapping", "sign = -1", "sign = 2", "torque: sign = 2 must be 1 or -1"),
    "mapping: wrong place": ("mapping", "[variables]", 'V_in = "v"\n[variables]', "unknown key 'V_in'"),
    "sweep: unknown key": ("sweep", "system =", 'sytem = "x"\nsystem =', "unknown key 'sytem'; did you mean 'system'?"),
    "sweep: wrong type": ("sweep", "system =", 'seed = "x"\nsystem =', "seed must be a whole number"),
    "sweep: wrong range": ("sweep", "system =", "random = -1\nsystem =", "random must be a whole number, 0 or more"),
    "sweep: wrong place": ("sweep", "system =", 'algorithm = "jacobi"\nsystem =', "unknown key 'algorithm'"),
    "calibration: unknown key": ("calibration", "bound =", "bond =", "targets F_z_mean: unknown key 'bond'"),
    "calibration: wrong type": ("calibration", "log = true", "log = 1", "free brush.k_c: log must be true or false"),
    "calibration: wrong range": ("calibration", "scale = 0.02", "scale = 0", "scale = 0 must be a number above 0"),
    "calibration: wrong place": ("calibration", "write =", "held_ = 1\nwrite =", "unknown key 'held_'"),
    "recordings: unknown key": ("recordings", "stop =", "stopp =", "run 1: unknown key 'stopp'; did you mean 'stop'?"),
    "recordings: wrong type": ("recordings", 'stop = "20 ms"', "stop = []", "run 1: stop must be a time"),
    "recordings: wrong place": ("recordings", "[[run]]", 'system = "x"\n[[run]]', "unknown key 'system'"),
}  # fmt: skip


@pytest.mark.parametrize("reader", READERS)
def test_what_is_right_is_read(reader: str, tmp_path: Path, fmus: Path) -> None:
    read, text = READERS[reader]
    read(tmp_path, fmus, text)


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_one_error_with_file_and_line(slip: str, tmp_path: Path, fmus: Path) -> None:
    reader, old, new, told = SLIPS[slip]
    read, text = READERS[reader]
    assert old in text
    with pytest.raises(InputError, match=re.escape(told)) as caught:
        read(tmp_path, fmus, text.replace(old, new, 1))
    assert re.search(r"\(case\.toml, line \d+\)|case\.toml: '\w+' is missing", str(caught.value)), caught.value


def test_every_reader_meets_every_kind_of_slip() -> None:
    kinds = ("unknown key", "wrong type", "wrong place")
    assert {f"{reader}: {kind}" for reader in READERS for kind in kinds} <= set(SLIPS)
