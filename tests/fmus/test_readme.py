"""What fmus/README.md promises: tables are the declarations, numbers come out, its C host verifies an import."""

from __future__ import annotations

import re
import shutil
import subprocess
import tomllib
import zipfile
from collections.abc import Iterator
from pathlib import Path

import fmpy
import numpy as np
import pytest
from helpers import ROOT
from rovbrush.components.build import COMPONENTS
from rovbrush.components.describe import BEGIN, README, described, main, section
from rovbrush.components.errors import BuildError
from rovbrush.components.native.compile import PLATFORMS
from rovbrush.orchestrator.boundary import write_boundary
from rovbrush.orchestrator.clock import duration
from rovbrush.orchestrator.simulation import require_complete, simulate
from rovbrush.orchestrator.studies.single import planned

SYSTEMS = ROOT / "orchestrator" / "systems"
RECORDED = {"motor": "dc_motor", "brush": "filament_brush", "vehicle": "rov_vehicle", "controller": "rov_controller"}


def rows(text: str) -> Iterator[list[str]]:
    """Cells of the table rows that begin with a name in backquotes or with a number."""
    for line in text.splitlines():
        if re.match(r"\| (`|\d)", line):
            yield [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def component_rows() -> dict[str, list[str]]:
    """Step and first run of each component, from the guide."""
    guide = README.read_text(encoding="utf-8").partition(BEGIN)[0]
    return {cells[0].strip("`"): cells for cells in rows(guide) if cells[0].strip("`") in COMPONENTS}


# --- tables ---


def test_variable_tables_are_those_of_the_declarations() -> None:
    text = README.read_text(encoding="utf-8")
    assert text == described(text), "run `python -m rovbrush.components.describe`"


@pytest.mark.parametrize("name", COMPONENTS)
def test_variable_table_agrees_with_the_file_that_is_handed_over(name: str, native: Path) -> None:
    description = fmpy.read_model_description(str(native / "fmi3" / f"{name}.fmu"))
    variables = [v for v in description.modelVariables if v.causality != "independent"]
    table = list(rows(section(name)))
    assert len(table) == len(variables)
    for cells, v in zip(table, variables, strict=True):
        reference, shown, causality, kind, unit = cells[:5]
        assert (int(reference), shown) == (v.valueReference, f"`{v.name}`")
        assert causality.replace("calculated parameter", "calculatedParameter") == v.causality
        assert unit == (v.unit or "")
        size = re.search(r"\[(\d+)\]", kind)
        assert [int(size[1])] == [int(d.start) for d in v.dimensions] if size else not v.dimensions


def test_tables_are_written_between_the_marks_only(tmp_path: Path) -> None:
    path = tmp_path / "README.md"
    path.write_text(f"before\n{BEGIN}\nof yesterday\n<!-- end of variables -->\nafter\n", encoding="utf-8")
    main(path)
    text = path.read_text(encoding="utf-8")
    assert text.startswith("before\n") and text.endswith("\nafter\n") and "of yesterday" not in text
    assert all(f"### {name}\n" in text for name in COMPONENTS)
    with pytest.raises(BuildError, match="put them into the file"):
        described("no marks")
    with pytest.raises(SystemExit, match="nowhere"):
        main(tmp_path / "nowhere.md")


# --- the guide's numbers ---


def test_every_component_has_the_step_of_the_shipped_systems() -> None:
    known: dict[str, set[str]] = {name: set() for name in COMPONENTS}
    for path in SYSTEMS.glob("*.toml"):
        for part in tomllib.loads(path.read_text(encoding="utf-8")).get("components", {}).values():
            known[part["fmu"]].add(part["period"])
    steps = {name: cells[2] for name, cells in component_rows().items()}
    assert list(steps) == list(COMPONENTS)
    assert all(step in known[name] for name, step in steps.items())


@pytest.mark.parametrize("name", COMPONENTS)
def test_first_run_gives_the_numbers_of_the_guide(name: str, native: Path) -> None:
    _, _, step, run = component_rows()[name]
    given, expected = (
        {key: float(value) for key, value in re.findall(r"`([\w\[\]]+)` = (-?[\d.]+)", part)}
        for part in run.split(": ")
    )
    found = fmpy.simulate_fmu(
        str(native / "fmi2" / f"{name}.fmu"),
        stop_time=2.0, output_interval=float(duration(step, name)), start_values=given, output=list(expected),
    )  # fmt: skip
    assert expected
    for key, value in expected.items():
        assert found[key][-1] == pytest.approx(value, rel=1e-6)  # seven digits are printed


# --- verify.c ---


@pytest.fixture(scope="module")
def recordings(native: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recordings of 0.1 s of `nominal`, on native FMUs."""
    folder = tmp_path_factory.mktemp("recordings")
    run = require_complete(simulate(planned("nominal", {}, "0.1 s", native / "fmi2", boundaries=tuple(RECORDED))))
    for component in RECORDED:
        write_boundary(run, component, folder)
    return folder


@pytest.fixture(scope="module")
def unpacked(native: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The unpacked FMUs and, beside them, the compiled program."""
    folder = tmp_path_factory.mktemp("unpacked")
    for name in RECORDED.values():
        with zipfile.ZipFile(native / "fmi2" / f"{name}.fmu") as archive:
            archive.extractall(folder / name)
    options = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-I", str(folder / "dc_motor" / "sources")]
    files = [str(README.parent / "verify.c"), "-o", str(folder / "verify"), "-lm", "-ldl"]
    subprocess.run([PLATFORMS["linux64"].compiler(), *options, *files], check=True)
    return folder


def verify(unpacked: Path, *words: str) -> subprocess.CompletedProcess[str]:
    command = [str(unpacked / "verify"), *words]
    return subprocess.run(command, capture_output=True, text=True, env={}, timeout=60, check=False)


@pytest.mark.parametrize("component", RECORDED)
def test_c_program_finds_every_output_equal(component: str, unpacked: Path, recordings: Path) -> None:
    run = verify(unpacked, str(unpacked / RECORDED[component]), str(recordings / component))
    assert run.returncode == 0, run.stdout + run.stderr
    outputs = (recordings / f"{component}_ref.csv").read_text().splitlines()[0].split(",")[1:]
    verdicts = [line.split() for line in run.stdout.splitlines()[2:]]
    assert [(words[0], words[-1]) for words in verdicts] == [(name, "equal") for name in outputs]


def test_c_program_names_the_output_that_is_outside(unpacked: Path, recordings: Path, tmp_path: Path) -> None:
    shutil.copytree(recordings, tmp_path, dirs_exist_ok=True)
    path = tmp_path / "motor_ref.csv"
    head, *lines = path.read_text().splitlines()
    cells = lines[100].split(",")
    place = head.split(",").index("omega_b")
    cells[place] = repr(float(cells[place]) * (1 + 1e-5))
    lines[100] = ",".join(cells)
    path.write_text("\n".join([head, *lines]) + "\n")
    run = verify(unpacked, str(unpacked / "dc_motor"), str(tmp_path / "motor"))
    outside = [line.split()[0] for line in run.stdout.splitlines() if line.endswith("outside")]
    assert (run.returncode, outside) == (1, ["omega_b"])
    assert verify(unpacked, str(unpacked / "dc_motor"), str(tmp_path / "motor"), "1e-4").returncode == 0


def test_c_program_shows_what_the_fmu_says_of_a_wrong_parameter(
    unpacked: Path, recordings: Path, tmp_path: Path
) -> None:
    shutil.copytree(recordings, tmp_path, dirs_exist_ok=True)
    path = tmp_path / "motor_parameters.csv"
    path.write_text(path.read_text().replace("R,parameter,0.08,", "R,parameter,-1,"))
    run = verify(unpacked, str(unpacked / "dc_motor"), str(tmp_path / "motor"))
    assert run.returncode == 1
    assert "dc_motor.R = -1 Ohm is out of range: 0.0001 to 100 Ohm are allowed" in run.stderr


def test_c_program_says_what_is_missing(unpacked: Path, recordings: Path) -> None:
    motor, recording = str(unpacked / "dc_motor"), str(recordings / "motor")
    for words, message in (
        ((motor,), "usage: verify FOLDER RECORDING"),
        ((str(unpacked / "nowhere"), recording), "nowhere/modelDescription.xml"),
        ((motor, str(recordings / "engine")), "engine_parameters.csv"),
        ((motor, str(recordings / "brush")), "the FMU has no variable L"),
    ):
        run = verify(unpacked, *words)
        assert run.returncode == 2 and message in run.stderr, run.stderr


def test_recorded_outputs_change_in_every_recording(recordings: Path) -> None:
    """The comparisons above are of something that moves."""
    for component in RECORDED:
        table = np.genfromtxt(recordings / f"{component}_ref.csv", delimiter=",", skip_header=1)
        assert np.count_nonzero(np.ptp(table[:, 1:], axis=0)) >= 3
