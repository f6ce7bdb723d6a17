"""What a system file may say of an autopilot: every mistake is an error that names the key, the value and the mend."""

from __future__ import annotations

from pathlib import Path

import pytest
from rovbrush.orchestrator.ardupilot.interface import Options
from rovbrush.orchestrator.ardupilot.servos import HEAVY
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

TEXT = """
format = 2
stop_time = "1 s"
[components.autopilot]
period = "2.5 ms"
inputs = { x_n = 0.0, y_n = 0.0, z_n = 0.0, phi = 0.0, theta = 0.0, psi = 0.0, u = 0.0, v = 0.0, w = 0.0, p = 0.0, \
q = 0.0, r = 0.0, f = [0.0, 0.0, -9.81] }
ardusub = { WHAT }
"""


def read(folder: Path, what: str = "", period: str = "2.5 ms", more: str = "") -> System:
    path = folder / "s.toml"
    path.write_text(TEXT.replace("WHAT", what).replace("2.5 ms", period) + more, encoding="utf-8")
    return load_system(str(path))


def test_an_empty_table_is_the_heavy_frame_at_port_9002(tmp_path: Path) -> None:
    fmu = read(tmp_path).components["autopilot"].fmu
    assert fmu.settings == Options(rate=400, port=9002, servos=(HEAVY,))  # type: ignore[attr-defined]
    assert fmu.expand("u_thruster") and fmu.expand("f") and not fmu.can_save_state
    assert fmu.variables["f[3]"].unit == "m/s2" and fmu.variables["frame"].causality == "output"


def test_all_that_can_be_said_of_it(tmp_path: Path) -> None:
    what = (
        'port = 0, host = "0.0.0.0", peer = "192.168.2.2", timeout = "1500 ms", origin = [1, 2.5, 10], '
        'rangefinders = 1, battery = true, servos = [{ output = "fan", channels = [10, 9], pulses = [1000, 2000], '
        'values = [0, 12], idle = 1, unit = "V" }]'
    )
    text = TEXT.replace("f = [", "rng_1 = 1.0, V_battery = 14.0, i_battery = 0.0, f = [")
    path = tmp_path / "s.toml"
    path.write_text(text.replace("WHAT", what).replace("2.5 ms", "20 ms"), encoding="utf-8")
    fmu = load_system(str(path)).components["autopilot"].fmu
    options = fmu.settings  # type: ignore[attr-defined]
    assert (options.rate, options.timeout, options.origin) == (50, 1.5, (1.0, 2.5, 10.0))
    assert options.servos[0].read((0,) * 8 + (1500, 2500)) == [12.0, 6.0] and options.servos[0].value(0) == 1.0
    assert fmu.variables["fan[2]"].unit == "V"


@pytest.mark.parametrize(
    ("what", "said"),
    [
        ("prot = 9002", "unknown key 'prot'; did you mean 'port'"),
        ("port = 99999", "port"),
        ('port = "9002"', "port"),
        ('timeout = "0 s"', "timeout"),
        ('timeout = "soon"', "timeout"),
        ('host = "my vehicle"', "host = 'my vehicle' is no address"),
        ('host = "0.0.0.0"', "host = '0.0.0.0' can be reached by others, and the protocol knows no token; .*peer ="),
        ('host = "0.0.0.0", peer = "all"', "peer = 'all' is no address"),
        ("origin = [0, 0]", "origin"),
        ("rangefinders = 7", "rangefinders"),
        ("servos = [{ channels = [1] }]", r"servos\[1\]: 'output' is missing"),
        ('servos = [{ output = "a", channels = [] }]', "channels"),
        ('servos = [{ output = "a", channels = [33] }]', "channels"),
        ('servos = [{ output = "a", channels = [1, 1] }]', "one of them twice"),
        ('servos = [{ output = "a", channels = [1], pulses = [1900, 1100] }]', "2 pulses and 3 values"),
        (
            'servos = [{ output = "a", channels = [1], pulses = [1900, 1100], values = [0, 1] }]',
            "must rise; 1100",
        ),
        ('servos = [{ output = "a", channels = [1], unit = "volts per" }]', "volts per"),
        ('servos = [{ output = "a", channels = [1] }, { output = "a", channels = [2] }]', "a is declared twice"),
        ('servos = [{ output = "x_n", channels = [1] }]', "x_n is declared twice"),
    ],
)
def test_what_cannot_be_is_an_error_with_its_place(what: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read(tmp_path, what)
    assert "autopilot" in str(caught.value) and "s.toml" in str(caught.value)


def test_localhost_is_the_loopback(tmp_path: Path) -> None:
    settings = read(tmp_path, 'host = "localhost"').components["autopilot"].fmu.settings  # type: ignore[attr-defined]
    assert settings.host == "127.0.0.1"


@pytest.mark.parametrize("period", ["3 ms", "0.2 s", "1/70000 s"])
def test_a_period_that_is_no_rate_is_an_error(period: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="whole number of Hz from 11 to 65535; take 1/"):
        read(tmp_path, period=period)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ('fmu = "rov_controller"', "exclude each other"),
        ('isolation = "process"', "isolation is for FMUs"),
        ('declare = { inputs = { a = "m" } }', "declare goes with python, udp or shared_memory; ardusub says it"),
    ],
)
def test_keys_that_go_with_others_are_refused(more: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "s.toml"
    path.write_text(TEXT.replace("WHAT", "").replace("[components.autopilot]\n", f"[components.autopilot]\n{more}\n"))
    with pytest.raises(InputError, match=said):
        load_system(str(path))
