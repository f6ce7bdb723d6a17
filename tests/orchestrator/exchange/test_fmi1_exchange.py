"""FMI 1.0 in the place of a component, under its tests, replayed, and written to others."""

from __future__ import annotations

from pathlib import Path

import pytest
from first_fmi import first_fmu, motor1
from helpers import FIXTURES, column, read_system, rovbrush, system_text
from native_build import needs_gcc
from rovbrush import Result
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.component_tests.verdicts import make_bench
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
MAP = FIXTURES / "foreign_motor.toml"
LACKING = """omega_m T_motor P_electrical P_copper P_friction P_gear P_shaft W_electrical W_copper W_friction W_gear
W_shaft E_stored energy_residual gear_stages gear_efficiency gear_speed_eps current_limit i_start omega_b_start
max_step H_spin T_housing J_housing rotor_sense"""


@pytest.fixture(scope="module")
def motor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return motor1(tmp_path_factory.mktemp("motor") / "motor1.fmu")


def test_a_sound_motor_passes_the_tests_of_the_component(motor: Path) -> None:
    verdicts = list(make_bench(motor, "dc_motor", MAP).judge())
    assert not [(v.claim, v.text) for v in verdicts if v.verdict == "failed"]
    assert sum(v.verdict == "passed" for v in verdicts) >= 12


def test_it_runs_replayed_and_in_the_place_of_a_component(
    motor: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    parts = {"motor": ("dc_motor", "1 ms", {"=V_in": 12.0, "=T_brush": -0.5})}
    (tmp_path / "case.toml").write_text(system_text(parts, stop="0.5 s"))
    run = ["run", "case.toml", "--fmus", fmus, "--out"]
    assert rovbrush(monkeypatch, *run, "ours", "--record-boundary", "motor") == 0
    assert rovbrush(monkeypatch, *run, "theirs", "--replace", f"motor={motor}", "--map", f"motor={MAP}") == 0
    ours, theirs = (Result.open(tmp_path / name)["motor.omega_b"] for name in ("ours", "theirs"))
    assert float(theirs[-1]) == pytest.approx(float(ours[-1]), rel=1e-6)
    mapped = MAP.read_text().replace('"ratio"', '""')  # ours is that of one stage of two
    (tmp_path / "map.toml").write_text(mapped + "".join(f'{name} = ""\n' for name in LACKING.split()))
    assert rovbrush(monkeypatch, "replay", motor, "ours", "--map", "map.toml", "--rtol", "1e-3") == 0


def test_an_ssp_takes_it_along_and_gives_the_same_bits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fmu = first_fmu(tmp_path / "first.fmu")
    parts = {name: (str(fmu), "1 ms", {"=u": 1.5, "=n_in": -7}) for name in "ab"}
    system = read_system(tmp_path, tmp_path, parts, ["a.minus_x -> b.minus_v"], stop="10 ms")
    assert rovbrush(monkeypatch, "export", tmp_path / "case.toml", "--ssp", "--out", tmp_path / "case.ssp") == 0
    runs = [simulate(make_plan(found)) for found in (system, load_system(str(tmp_path / "case.ssp")))]
    for name in ("b.z", "a.minus_x", "b.minus_n"):
        a, b = (column(run, name)[1] for run in runs)
        assert a.tobytes() == b.tobytes(), name


def test_a_container_refuses_it_by_name(tmp_path: Path) -> None:
    fmu = first_fmu(tmp_path / "first.fmu")
    system = read_system(tmp_path, tmp_path, {"a": (str(fmu), "1 ms", {"=u": 1.5})}, stop="10 ms")
    with pytest.raises(InputError, match=r"component a: first\.fmu is of FMI 1\.0, and a container can hold FMI 2\.0"):
        write_container(system, tmp_path / "whole.fmu")
