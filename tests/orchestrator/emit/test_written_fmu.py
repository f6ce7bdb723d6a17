"""A system as one native FMU: the bits of its run in any host, and what an FMU must be able to do."""

from __future__ import annotations

import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
import pytest
from emit_cases import Masses, alone, run_of_system, unlike
from helpers import column, edited, python, rovbrush, system_text
from native_build import needs_gcc
from recorder import recorded
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.system.file.reader import load_system
from windows_build import needs_wine

pytestmark = needs_gcc
VERSIONS = ("2.0", "3.0")


@pytest.fixture(scope="module", params=VERSIONS)
def whole(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, carried: Path) -> Path:
    """The masses as one FMU."""
    from emit_cases import PARTS, WIRES
    from helpers import read_system

    folder = tmp_path_factory.mktemp("whole")
    system = read_system(folder, carried, PARTS, WIRES, stop="0.1 s", algorithm="gauss-seidel")
    export_fmu(system, folder / "whole.fmu", request.param)
    return folder / "whole.fmu"


def test_one_fmu_has_the_bits_of_the_run(whole: Path, masses: Masses) -> None:
    assert unlike(alone(whole), run_of_system(masses())) == []


HOST = """
import sys
from fmpy import simulate_fmu
import numpy as np
file, step, out = sys.argv[1:]
rows = simulate_fmu(file, stop_time=0.1, step_size=float(step), output_interval=float(step),
                    output=["a.x", "b.x", "f.F", "f.back"])
np.savez(out, **{n: rows[n] for n in rows.dtype.names})
"""


@pytest.mark.parametrize("step", [0.002, 0.004, 0.02])
def test_another_host_may_step_it_by_any_instants_of_the_plan(
    step: float, whole: Path, masses: Masses, tmp_path: Path
) -> None:
    done = python(HOST, str(whole), repr(step), str(tmp_path / "rows.npz"))
    assert done.returncode == 0, done.stderr
    run = run_of_system(masses())
    with np.load(tmp_path / "rows.npz") as rows:
        for name in ("a.x", "b.x", "f.F", "f.back"):
            times, own = column(run, name)
            both = np.isin(np.round(times / 0.001), np.round(rows["time"] / 0.001))
            there = np.isin(np.round(rows["time"] / 0.001), np.round(times / 0.001))
            assert own[both].tobytes() == rows[name][there].tobytes()


def test_parameters_are_set_by_their_names(whole: Path, masses: Masses) -> None:
    run = run_of_system(masses().with_values({"b.m": 3.25}, "test"))
    assert unlike(alone(whole, **{"whole.b.m": 3.25}), run) == []


def test_what_the_system_requires_of_the_start_is_required_of_its_fmu(carried: Path, tmp_path: Path) -> None:
    parts = {"a": ("mass", "1 ms", {"x0": 0.1})}
    (tmp_path / "case.toml").write_text(
        system_text(parts, [], "5 ms")
        + '[[require]]\nvalue = "a.x"\nmaximum = 0.5\nmessage = "100 % beyond the wall"\n'
        + '[[require]]\nvalue = "a.m"\nminimum = "a.x0"\nmessage = "too light"\notherwise = "warning"\n'
    )
    export_fmu(load_system(str(tmp_path / "case.toml"), carried), tmp_path / "whole.fmu")
    assert not alone(tmp_path / "whole.fmu", **{"whole.a.m": 0.05}, stop="5 ms").failure
    with pytest.raises(FmuError, match=r"100 % beyond the wall: a.x = 0.75 at the start, allowed are -inf to 0.5"):
        alone(tmp_path / "whole.fmu", **{"whole.a.x0": 0.75}, stop="5 ms")


@needs_wine
def test_its_library_for_windows_has_the_bits_of_the_run_under_wine(
    whole: Path, masses: Masses, tmp_path: Path
) -> None:
    """Where no function of the mathematical library is called."""
    folder = tmp_path / "windows"
    folder.mkdir()
    linux = [name for name in zipfile.ZipFile(whole).namelist() if "linux" in name]
    assert len(linux) == 1
    edited(whole, folder / "whole.fmu", dict.fromkeys(linux))
    assert unlike(alone(folder / "whole.fmu"), run_of_system(masses())) == []


@pytest.mark.parametrize("platform", ["linux", pytest.param("windows", marks=needs_wine)])
def test_a_host_in_c_reads_the_bits_of_the_run(platform: str, whole: Path, masses: Masses) -> None:
    rows = recorded(whole, platform, 0.004, 25)
    run = run_of_system(masses())
    assert {"a.x", "a.v", "b.x", "b.v", "f.F", "f.back"} <= rows.keys()
    for name in ("a.x", "a.v", "b.x", "b.v", "f.F", "f.back"):
        times, own = column(run, name)
        assert rows[name].tobytes() == own[(times * 1000.0).round() % 4 == 0].tobytes(), name


TWO = """
import sys
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
file = sys.argv[1]
d = read_model_description(file)
folder = extract(file)
numbers = {v.name: v.valueReference for v in d.modelVariables}
def new(name):
    kind = FMU2Slave if d.fmiVersion == "2.0" else FMU3Slave
    f = kind(guid=d.guid, unzipDirectory=folder, modelIdentifier=d.coSimulation.modelIdentifier, instanceName=name)
    f.instantiate()
    if kind is FMU2Slave:
        f.setupExperiment(startTime=0.0)
    else:
        f.getReal = f.getFloat64
    f.enterInitializationMode()
    f.exitInitializationMode()
    return f
a, b = new("a"), new("b")
x = [numbers["a.x"], numbers["b.x"], numbers["f.F"]]
for k in range(10):
    a.doStep(k * 0.004, 0.004)
state = a.getFMUState()
kept = a.serializeFMUState(state)
for k in range(10, 20):
    a.doStep(k * 0.004, 0.004)
end = a.getReal(x)
assert b.getReal(x) != end
a.setFMUState(state)
for k in range(10, 20):
    a.doStep(k * 0.004, 0.004)
assert a.getReal(x) == end
b.setFMUState(b.deserializeFMUState(kept))
for k in range(10, 20):
    b.doStep(k * 0.004, 0.004)
assert b.getReal(x) == end
try:
    b.deserializeFMUState(b"nonsense" * 100)
except Exception:
    print("refused", end=" ")
try:
    a.doStep(0.08, 0.0005)
except Exception:
    print("refused")
a.terminate(); a.freeInstance(); b.freeInstance()
"""


def test_two_instances_do_not_meet_and_states_go_from_one_to_the_other(whole: Path) -> None:
    done = python(TWO, str(whole))
    assert done.stdout.split().count("refused") == 2, done.stderr
    said = done.stdout + done.stderr
    assert "these bytes are no state" in said and "goes on by instants, the next one at 0.081 s" in said


def test_it_is_fit_to_be_exchanged(whole: Path) -> None:
    report = check_fmu(whole)
    assert [row for row in report.rows if row.verdict == "error"] == []
    found = {row.rule for row in report.rows if row.verdict == "finding"}
    assert found <= {
        "dependencies are declared",
        "variables are described",
        "every number has a unit",
        "steps may vary",
    }


def test_the_same_system_is_the_same_file(whole: Path, masses: Masses, tmp_path: Path) -> None:
    with zipfile.ZipFile(whole) as one:
        version = "3.0" if b'fmiVersion="3.0"' in one.read("modelDescription.xml") else "2.0"
    export_fmu(masses(), tmp_path / "again.fmu", version)
    with zipfile.ZipFile(whole) as one, zipfile.ZipFile(tmp_path / "again.fmu") as other:
        assert {n: one.read(n) for n in one.namelist()} == {n: other.read(n) for n in other.namelist()}
        assert "sources/case_.c" in one.namelist()


def test_the_commands_of_the_documentation_write_what_they_say(
    native: Path, masses: Masses, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    carried: Path,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    masses()  # writes case.toml
    assert rovbrush(monkeypatch, "export", "case.toml", "--fmu", "--fmus", carried) == 0
    assert "wrote case.fmu (one FMU of FMI 2.0, " in capsys.readouterr().out
    shutil.copytree(native / "fmi2", "fmus/native/fmi2")
    assert rovbrush(monkeypatch, "export", "test_stand", "--c", "test_stand_in_c", "--fmus", "fmus/native/fmi2") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "wrote test_stand_in_c (a C library and a program)" in said and "floating-point operations" in said
    subprocess.run(["make", "-C", "test_stand_in_c", "-n"], check=True, capture_output=True)
