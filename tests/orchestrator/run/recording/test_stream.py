"""Tables that are too large for memory go to disk while the run goes, and nothing of them is lost."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from car_runs import ALGORITHMS, car
from helpers import Measured, Part, plan_of
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.recordings.write import write_boundary
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.files.writing import write_results, write_rows
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.bench.fmus.native import ring
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.recorded import select_recorded

PEAK = """
import resource, subprocess, sys
done = subprocess.run(sys.argv[1:], capture_output=True, text=True)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024, done.stderr)
sys.exit(done.returncode)
"""


def streamed(plan: Plan, folder: Path, pieces: int = 1) -> Run:
    """The run of a plan whose rows go to a file."""
    with Session(plan, file=folder / "rows.nc") as session:
        for k in range(1, pieces + 1):
            session.advance(until_tick=plan.clock.stop * k // pieces)
            session.run()
        run = session.run()
    assert not isinstance(run.recorded, list) and (folder / "rows.nc").is_file()
    return run


def require_same_file(run: Run, other: Run, folder: Path) -> None:
    """Both write a result.nc with the same groups, variables, types, attributes and bits."""
    for k, found in enumerate((run, other)):
        (folder / str(k)).mkdir()
        write_results(found, folder / str(k), summarize(found))
    paths = [str(folder / str(k) / "result.nc") for k in range(2)]
    trees = [xarray.open_datatree(path, engine="h5netcdf") for path in paths]
    assert trees[0].groups == trees[1].groups
    for group in trees[0].groups:
        a, b = (tree[group].to_dataset() for tree in trees)
        xarray.testing.assert_identical(a, b)
        for name in a.variables:
            assert a[name].dtype == b[name].dtype and a[name].attrs == b[name].attrs, name
            if a[name].dtype.kind != "O":
                assert a[name].values.tobytes() == b[name].values.tobytes(), name


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few hundred bytes are many."""
    monkeypatch.setattr(recorder, "IN_MEMORY", 2000)
    monkeypatch.setattr(recorder, "PIECE", 700)
    monkeypatch.setattr(recorder, "CHUNK", 5)


@pytest.mark.sampled(3)
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("pieces", [1, 3])
@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_run_on_disk_is_bitwise_that_in_memory(algorithm: str, pieces: int, tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, algorithm)
    on_disk, in_memory = streamed(plan, tmp_path, pieces), simulate(plan)
    assert [t.tobytes() for t in on_disk.tables] == [t.tobytes() for t in in_memory.tables]
    for name, signal in ((n, Signals(in_memory)[n]) for n in Signals(in_memory).places):
        assert Signals(on_disk)[name].time.tobytes() == signal.time.tobytes()
    require_same_file(on_disk, in_memory, tmp_path)


@needs_gcc
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(("kind", "free", "wires"), [("feedthrough2", FREE2, WIRES2), ("feedthrough3", FREE3, WIRES3)])
def test_every_type_goes_to_disk(kind: str, free: dict[str, Any], wires: list[str], tmp_path: Path) -> None:
    parts: dict[str, Part] = {"a": (kind, "1 ms", free), "b": (kind, "2 ms")}
    plan = plan_of(tmp_path, built(tmp_path), parts, wires, stop="40 ms")
    on_disk, in_memory = streamed(plan, tmp_path), simulate(plan)
    assert [t.shape for t in on_disk.tables] == [t.shape for t in in_memory.tables]
    require_same_file(on_disk, in_memory, tmp_path)


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("algorithm", ["jacobi", "iterated"])
def test_a_failed_run_on_disk_keeps_its_rows_and_says_so(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"bad": ("faulty", "5 ms", {"raise_at": 0.5}), "w": ("wave", "1 ms", {"c1": 1.0})}
    plan = plan_of(tmp_path, fmus, parts, stop="2 s", algorithm=algorithm)
    on_disk, in_memory = streamed(plan, tmp_path), simulate(plan)
    assert "component bad" in on_disk.failure and on_disk.failure == in_memory.failure
    assert [t.tobytes() for t in on_disk.tables] == [t.tobytes() for t in in_memory.tables]
    require_same_file(on_disk, in_memory, tmp_path)
    with xarray.open_dataset(tmp_path / "0" / "result.nc", group="every_1_ms", engine="h5netcdf") as found:
        assert found.attrs["complete"] == 0 and found.time.values[-1] == on_disk.end


@pytest.mark.usefixtures("small")
def test_a_table_of_an_earlier_run_does_not_stay(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "result.csv").write_text("old")
    run = streamed(car(tmp_path, fmus, "jacobi"), tmp_path)
    paths = write_results(run, tmp_path, summarize(run))
    assert "result.csv" not in [path.name for path in paths] and not (tmp_path / "result.csv").exists()
    assert write_boundary(run, "w", tmp_path)[0].read_text().count("\n") == 302  # what needs rows reads them


@pytest.mark.usefixtures("small")
def test_a_disk_that_refuses_ends_the_run_and_costs_no_row(tmp_path: Path, fmus: Path) -> None:
    file, plan = tmp_path / "missing" / "rows.nc", car(tmp_path, fmus, "jacobi")
    with Session(plan, file=file) as session:
        session.advance()
        run = session.run()
        assert f"cannot write {file}: No such file" in run.failure and 0.0 < run.end < plan.clock.time(plan.clock.stop)
        written = write_rows(run, tmp_path / "out")
    with xarray.open_dataset(written.folder / "result.nc", group="every_1_ms", engine="h5netcdf") as found:
        assert found.attrs["complete"] == 0 and found.time.values[-1] == run.end


@needs_gcc
def test_memory_does_not_grow_with_the_number_of_steps(tmp_path: Path, measured: Measured) -> None:
    """Rows of 40 bytes and more: kept in memory, the longer run would take 40 MB more."""
    path, peaks = ring(tmp_path, 2), []
    for stop in ("1100 s", "2200 s"):
        command = [sys.executable, "-m", "rovbrush.orchestrator", "run", str(path), "--stop", stop]
        done = subprocess.run(
            [sys.executable, "-c", PEAK, *command, "--out", str(tmp_path)], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout
        peaks.append(int(done.stdout.split()[0]) / 1e6)
    measured(
        "ring of 2, 2.2 million steps to disk: peak memory more than with 1.1 million [MB]", peaks[1] - peaks[0], "10"
    )
    assert peaks[1] - peaks[0] < 10.0
    with xarray.open_dataset(tmp_path / "result.nc", group="every_1_ms", engine="h5netcdf") as found:
        assert found.attrs["complete"] == 1
        assert np.array_equal(found.time.values, np.arange(2_200_001) / 1000)
        assert len(found.data_vars) == 4 and all(found[name].size == 2_200_001 for name in found.data_vars)
    assert json.loads((tmp_path / "summary.json").read_text())["macro_steps"] == 2_200_000


def test_what_is_recorded_can_be_chosen(tmp_path: Path, fmus: Path) -> None:
    system = select_recorded(load_system("nominal", fmus), ["motor.*", "brush.F_?"])
    plan = make_plan(system)
    names = {".".join(key) for group in plan.groups for key in group.columns}
    assert {"motor.i", "brush.F_z"} <= names and len(names) < 60
    every = {".".join(key) for group in make_plan(load_system("nominal", fmus)).groups for key in group.columns}
    assert names < every
    with pytest.raises(InputError, match=r"--record motor\.omeg: no variable is called so; did you mean"):
        select_recorded(system, ["motor.omeg"])
