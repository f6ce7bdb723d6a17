"""fmus/verify.c, the host that verifies an import without Python: compiled as its head says, on recordings."""

from __future__ import annotations

import shutil
import subprocess
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from helpers import ROOT, Measured
from rovbrush.components.build import COMPONENTS
from rovbrush.components.native.compile import PLATFORMS

VERIFY = ROOT / "fmus" / "verify.c"
RECORDINGS = ROOT / "fmus" / "recordings"
BOUND = "1e-9"  # the C library of a platform rounds sin, exp and others its own way in the last digit
Run = Callable[..., "subprocess.CompletedProcess[str]"]


def compiled(sources: Path, version: str, target: Path, platform: str = "linux64") -> Path:
    """The program for FMUs of one version."""
    options = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-I", str(sources)]
    options += ["-DFMI3"] if version == "fmi3" else []
    libraries = ["-lm", "-ldl"] if platform == "linux64" else []
    command = [PLATFORMS[platform].compiler(), *options, str(VERIFY), "-o", str(target), *libraries]
    subprocess.run(command, check=True)
    return target


@pytest.fixture(scope="module", params=["fmi2", "fmi3"])
def version(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module")
def unpacked(version: str, native: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The unpacked FMUs of a version and, beside them, the compiled program."""
    folder = tmp_path_factory.mktemp("unpacked")
    for name in COMPONENTS:
        with zipfile.ZipFile(native / version / f"{name}.fmu") as archive:
            archive.extractall(folder / name)
    compiled(folder / "dc_motor" / "sources", version, folder / "verify")
    return folder


def verify(unpacked: Path, *words: str) -> subprocess.CompletedProcess[str]:
    command = [str(unpacked / "verify"), *words]
    return subprocess.run(command, capture_output=True, text=True, env={}, timeout=60, check=False)


def rows(run: subprocess.CompletedProcess[str]) -> dict[str, list[str]]:
    """Error, magnitude and verdict by output."""
    return {words[0]: words[1:] for words in map(str.split, run.stdout.splitlines()[2:])}


def recorded_outputs(name: str) -> list[str]:
    return (RECORDINGS / f"{name}_ref.csv").read_text().splitlines()[0].split(",")[1:]


@pytest.mark.parametrize("name", COMPONENTS)
def test_every_output_of_the_shipped_recordings_is_found_within(
    name: str, version: str, unpacked: Path, measured: Measured
) -> None:
    run = verify(unpacked, str(unpacked / name), str(RECORDINGS / name), BOUND, BOUND)
    assert run.returncode == 0, run.stdout + run.stderr
    found = rows(run)
    assert list(found) == recorded_outputs(name)
    assert {cells[-1] for cells in found.values()} <= {"equal", "within"}
    worst = max(float(error) / float(scale) for error, scale, _ in found.values() if float(scale))
    measured(f"verify.c on the shipped recordings, {version}: error of an output's magnitude", worst, BOUND)


def test_windows_program_finds_the_same_of_the_win64_binaries(
    version: str, unpacked: Path, wine: Run, measured: Measured
) -> None:
    program = compiled(unpacked / "dc_motor" / "sources", version, unpacked / "verify.exe", "win64")
    for name in COMPONENTS:
        run = wine(program, str(unpacked / name), str(RECORDINGS / name), BOUND, BOUND)
        assert run.returncode == 0, run.stdout + run.stderr
        assert list(rows(run)) == recorded_outputs(name)
        worst = max(float(error) / float(scale) for error, scale, _ in rows(run).values() if float(scale))
        measured(f"verify.exe under wine, {version}: error of an output's magnitude", worst, BOUND)


@pytest.mark.parametrize(("name", "output"), [("dc_motor", "omega_b"), ("rov_controller", "u_thruster[3]")])
def test_the_output_that_is_outside_is_named(name: str, output: str, unpacked: Path, tmp_path: Path) -> None:
    shutil.copytree(RECORDINGS, tmp_path, dirs_exist_ok=True)
    path = tmp_path / f"{name}_ref.csv"
    head, *lines = path.read_text().splitlines()
    row = len(lines) // 2
    cells = lines[row].split(",")
    place = head.split(",").index(output)
    cells[place] = repr(float(cells[place]) * (1 + 1e-2))
    lines[row] = ",".join(cells)
    path.write_text("\n".join([head, *lines]) + "\n")
    run = verify(unpacked, str(unpacked / name), str(tmp_path / name), BOUND, BOUND)
    outside = [output for output, cells in rows(run).items() if cells[-1] == "outside"]
    assert (run.returncode, outside) == (1, [output])
    assert verify(unpacked, str(unpacked / name), str(tmp_path / name), "0.02", BOUND).returncode == 0


def test_what_the_fmu_says_of_a_wrong_parameter_is_shown(unpacked: Path, tmp_path: Path) -> None:
    shutil.copytree(RECORDINGS, tmp_path, dirs_exist_ok=True)
    path = tmp_path / "dc_motor_parameters.csv"
    text = path.read_text()
    assert "R,parameter,0.08," in text
    path.write_text(text.replace("R,parameter,0.08,", "R,parameter,-1,"))
    run = verify(unpacked, str(unpacked / "dc_motor"), str(tmp_path / "dc_motor"))
    assert run.returncode == 1
    assert "dc_motor.R = -1 Ohm is out of range: 0.0001 to 100 Ohm are allowed" in run.stderr


def test_what_is_missing_is_said(unpacked: Path) -> None:
    motor, recording = str(unpacked / "dc_motor"), str(RECORDINGS / "dc_motor")
    for words, message in (
        ((motor,), "usage: verify FOLDER RECORDING"),
        ((str(unpacked / "nowhere"), recording), "nowhere/modelDescription.xml"),
        ((motor, str(RECORDINGS / "engine")), "engine_parameters.csv"),
        ((motor, str(RECORDINGS / "filament_brush")), "the FMU has no variable L"),
    ):
        run = verify(unpacked, *words)
        assert run.returncode == 2 and message in run.stderr, run.stderr


def test_a_program_for_the_other_version_says_what_it_lacks(version: str, unpacked: Path, native: Path) -> None:
    other = {"fmi2": "fmi3", "fmi3": "fmi2"}[version]
    folder = unpacked / "other"
    with zipfile.ZipFile(native / other / "dc_motor.fmu") as archive:
        archive.extractall(folder)
    run = verify(unpacked, str(folder), str(RECORDINGS / "dc_motor"))
    assert run.returncode == 2
    assert f"modelDescription.xml lacks {'guid' if version == 'fmi2' else 'instantiationToken'}" in run.stderr
