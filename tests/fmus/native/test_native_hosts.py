"""Native FMUs in hosts with no Python: a few lines of C with an empty environment, and the win64 binary under wine."""

from __future__ import annotations

import subprocess
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path

import fmpy
import numpy as np
import pytest
from driven import DrivenFmu
from helpers import FIXTURES, Measured
from rovbrush.components.build import COMPONENTS
from rovbrush.components.native.compile import PLATFORMS

Start = Callable[..., "subprocess.CompletedProcess[str]"]  # program and its arguments
HEADERS = Path(fmpy.__file__).parent / "c-code"
# Step size [s], steps, and inputs or parameters that make something happen.
RUNS: dict[str, tuple[float, int, Mapping[str, float]]] = {
    "filament_brush": (1e-3, 400, {"omega_b": 15.7, "delta": 0.005}),
    "cup_brush": (1e-3, 400, {"omega_b": 15.7, "delta": 0.005}),
    "dc_motor": (1e-3, 400, {"V_in": 12.0, "T_brush": -15.0}),
    "rov_vehicle": (5e-3, 400, {"F_x": -40.0, "F_z": -20.0, "M_y": 2.0}),
    "rov_controller": (2e-2, 400, {"z_n": 0.3, "theta": 0.2, "psi": 0.4}),
    "mission": (5e-2, 400, {"x_n": -0.3}),
    "constant_speed": (1e-3, 400, {"V_in": 12.0, "T_brush": -3.0}),
    "tool_frame": (1e-3, 400, {"delta": 0.005, "tilt_x": 0.02, "tilt_y": 0.01, "q": 0.1}),
    "battery": (1e-2, 400, {"i": 60.0, "i_other": 5.0}),
    "hull_fouling": (5e-2, 400, {"s": 0.3, "delta": 0.003, "omega_b": 15.0, "W_friction": 50.0}),
    "rov_sensors": (5e-3, 400, {"u": 0.3, "psi": 3.0, "rate_dvl": 15.0, "noise_dvl": 0.01, "delay": 0.012}),
}
WIN64_TOLERANCE = 1e-12  # another C library rounds sin, exp and others differently in the last digit


def host(version: str, folder: Path, windows: bool = False) -> Path:
    """The C host, compiled."""
    target = folder / f"host_{version}{'.exe' if windows else ''}"
    compiler = PLATFORMS["win64" if windows else "linux64"].compiler()
    define = ["-DFMI3"] if version == "fmi3" else []
    command = [compiler, "-O1", *define, str(FIXTURES / "host" / "host.c"), "-I", str(HEADERS), "-o", str(target)]
    subprocess.run([*command, *([] if windows else ["-ldl"])], check=True, capture_output=True)
    return target


@pytest.fixture(scope="module", params=["fmi2", "fmi3"])
def version(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def bare(program: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """The program with an empty environment."""
    command = [str(program), *words]
    return subprocess.run(command, capture_output=True, text=True, env={}, timeout=120, check=False)


def c_outputs(fmu: Path, start: Start, program: Path, library: str, words: list[str]) -> np.ndarray:
    """The library unpacked and run by the host; its outputs."""
    with zipfile.ZipFile(fmu) as archive:
        path = archive.extract(library, program.parent)
    run = start(program, path, *words)
    assert run.returncode == 0, (run.returncode, run.stderr[-2000:])
    return np.array([float.fromhex(line) for line in run.stdout.split()])


def python_outputs(fmu: Path, name: str, folder: Path) -> tuple[np.ndarray, list[str]]:
    """The same run by fmpy, and the words that make the C host do it."""
    h, steps, given = RUNS[name]
    driven = DrivenFmu(fmu, folder, {})
    variables = driven.description.modelVariables
    for key in given:
        if driven.fmi3 and next(v for v in variables if v.name == key).dimensions:
            raise ValueError(f"{key} is an array; the host sets scalars")
    driven.start(given)
    for k in range(steps):
        driven.slave.doStep(k * h, h)
    # The host reads scalars: the leading run of them among the outputs.
    scalars = [v for v in variables if v.causality in ("output", "calculatedParameter") and not v.dimensions]
    first = scalars[0].valueReference
    scalars = [v for k, v in enumerate(scalars) if v.valueReference == first + k]
    get = driven.slave.getFloat64 if driven.fmi3 else driven.slave.getReal
    values = np.array(get([v.valueReference for v in scalars]))
    words = [driven.description.guid, repr(h), str(steps), str(len(scalars)), str(first)]
    words += [f"{next(v.valueReference for v in variables if v.name == key)}={value!r}" for key, value in given.items()]
    driven.close()
    return values, words


@pytest.mark.parametrize("name", COMPONENTS)
def test_c_host_with_an_empty_environment_gets_the_same_bits(
    name: str, version: str, native: Path, tmp_path: Path
) -> None:
    fmu = native / version / f"{name}.fmu"
    expected, words = python_outputs(fmu, name, tmp_path / "fmu")
    platform = PLATFORMS["linux64"]
    library = f"binaries/{platform.fmi2 if version == 'fmi2' else platform.fmi3}/{name}.so"
    seen = c_outputs(fmu, bare, host(version, tmp_path), library, words)
    assert np.all(np.isfinite(expected)) and np.any(expected != 0.0)
    assert np.array_equal(seen, expected)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", COMPONENTS)
def test_win64_binary_runs_under_wine(
    name: str, version: str, native: Path, tmp_path: Path, wine: Start, measured: Measured
) -> None:
    fmu = native / version / f"{name}.fmu"
    expected, words = python_outputs(fmu, name, tmp_path / "fmu")
    platform = PLATFORMS["win64"]
    library = f"binaries/{platform.fmi2 if version == 'fmi2' else platform.fmi3}/{name}.dll"
    seen = c_outputs(fmu, wine, host(version, tmp_path, windows=True), library, words)
    scale = np.maximum(np.abs(expected), 1e-3 * np.max(np.abs(expected)))
    difference = float(np.max(np.abs(seen - expected) / scale))
    measured(f"{name} win64 under wine against linux64, {version}: relative difference", difference, "1e-12")
    assert difference <= WIN64_TOLERANCE
