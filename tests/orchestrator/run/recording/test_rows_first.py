"""What a run computed is on disk before anything is made of it, and no later product can take it away."""

from __future__ import annotations

import json
import os
from contextlib import AbstractContextManager
from pathlib import Path

import h5py
import pytest
from car_runs import car
from cells_fmu import cells, scalar
from helpers import Part, plan_of, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.files import sweep_up
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.files import writing
from rovbrush.orchestrator.results.files.folder import require_own
from rovbrush.orchestrator.results.files.netcdf import stored_names
from rovbrush.orchestrator.results.files.safe_file import SafeFile
from rovbrush.orchestrator.results.files.writing import write_results, write_rows
from rovbrush.orchestrator.results.opened import open_tables
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.carry_out import Finished, carry_out, claim
from rovbrush.orchestrator.run.pacing.pace import Pace
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.request import Request

WAVE: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0})}
FULL = OSError(28, os.strerror(28))


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few hundred bytes are many."""
    monkeypatch.setattr(recorder, "IN_MEMORY", 2000)
    monkeypatch.setattr(recorder, "PIECE", 700)
    monkeypatch.setattr(recorder, "CHUNK", 5)


def done(plan: Plan, out: Path, force: bool = False) -> Finished:
    """A run into a folder, as the command makes it."""
    folder, older = claim(out, plan.system.name, force)
    return carry_out(plan, folder, Request("case"), older)


@pytest.mark.parametrize("product", ["manifest", "explain", "write_csv", "summarize", "comparison"])
def test_a_product_that_fails_costs_no_other(
    product: str, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object) -> None:
        raise ZeroDivisionError("ours")

    monkeypatch.setattr(writing, product, fail)
    found = done(plan_of(tmp_path, fmus, WAVE, stop="10 ms"), tmp_path / "out")
    assert [line for line in found.failures if "unexpected ZeroDivisionError: ours" in line]
    made = {path.name for path in found.written.paths}
    assert len({"result.nc", "manifest.json", "plan.txt", "result.csv", "summary.json"} - made) <= 1
    assert "result.nc" in made and all((tmp_path / "out" / name).is_file() for name in made)


def test_nothing_that_is_read_is_made_before_the_rows_are_closed(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[int] = []

    def look(_run: Run, path: Path) -> None:
        with h5py.File(path.parent / "result.nc") as file:
            seen.append(len(file["every_1_ms/time"]))
        path.write_text("")

    monkeypatch.setattr(writing, "write_csv", look)
    done(plan_of(tmp_path, fmus, WAVE, stop="10 ms"), tmp_path / "out")
    assert seen == [11]


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("other", [False, True])
def test_rows_are_kept_where_an_fmu_takes_the_descriptor_away(other: bool, tmp_path: Path, fmus: Path) -> None:
    plan, victim = car(tmp_path, fmus, "jacobi"), tmp_path / "victim"
    victim.write_bytes(b"mine")
    with Session(plan, file=tmp_path / "rows.nc") as session:
        session.advance(cycles=100)
        assert session.recorder.stream and session.recorder.stream._file
        stolen = session.recorder.stream._file.disk.descriptor
        if other:
            descriptor = os.open(victim, os.O_RDWR)
            os.dup2(descriptor, stolen)
            os.close(descriptor)
        else:
            os.close(stolen)
        session.advance()
        run = session.run()
        write_rows(run, tmp_path / "out")
    assert victim.read_bytes() == b"mine" and not run.failure
    assert [t.tobytes() for t in run.tables] == [t.tobytes() for t in simulate(plan).tables]


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("pieces", [0, 1, 3])
def test_a_disk_that_fills_up_ends_the_run_with_all_its_rows(
    pieces: int, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan, left = car(tmp_path, fmus, "jacobi"), [pieces]

    def allocate(_descriptor: int, _at: int, _size: int) -> None:
        left[0] -= 1
        if left[0] < 0:
            raise FULL

    monkeypatch.setattr(os, "posix_fallocate", allocate)
    found = done(plan, tmp_path / "out")
    assert "No space left" in found.run.failure and found.written.folder == tmp_path / "out"
    with h5py.File(tmp_path / "out" / "result.nc") as file:
        assert not file["every_1_ms"].attrs["complete"]
        assert file["every_1_ms/time"][-1] == found.run.end > 0.0


@pytest.mark.parametrize("streamed", [False, True])
def test_rows_that_the_folder_refuses_go_to_a_temporary_one_that_is_named(
    streamed: bool, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if streamed:
        for name, size in (("IN_MEMORY", 2000), ("PIECE", 700)):
            monkeypatch.setattr(recorder, name, size)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    write = SafeFile.write

    def refuse(file: SafeFile, data: object) -> int:
        if file.path.parent.name == "out" and file.error is None:
            file.error = FULL
        return write(file, data)

    monkeypatch.setattr(SafeFile, "write", refuse)
    plan = car(tmp_path, fmus, "jacobi")
    found = done(plan, tmp_path / "out")
    assert found.written.folder.parent == tmp_path and found.written.folder.name.startswith("rovbrush-")
    assert "No space left" in found.written.elsewhere and str(found.written.folder) in found.written.elsewhere
    with h5py.File(found.written.folder / "result.nc") as file:
        assert file["every_1_ms/time"][-1] == found.run.end


def test_a_run_replaces_its_own_files_and_nothing_else(tmp_path: Path, fmus: Path) -> None:
    plan, out = plan_of(tmp_path, fmus, WAVE, stop="10 ms"), tmp_path / "out"
    done(plan, out)
    manifest = json.loads((out / "manifest.json").read_text())
    (out / "manifest.json").write_text(json.dumps({**manifest, "files": [*manifest["files"], "old.png", "../no.txt"]}))
    for path in (out / "old.png", out / "mine.png", tmp_path / "no.txt"):
        path.write_text("")
    done(plan, out)
    assert not (out / "old.png").exists() and (out / "mine.png").exists() and (tmp_path / "no.txt").exists()


@pytest.mark.parametrize("refused", ["processors", "watching"])
def test_what_is_refused_as_a_run_begins_costs_no_earlier_results(refused: str, tmp_path: Path, fmus: Path) -> None:
    def watched(_session: Session) -> AbstractContextManager[None]:
        raise InputError("nobody can watch")

    plan, out = plan_of(tmp_path, fmus, WAVE, stop="5 ms"), tmp_path / "out"
    done(plan, out)
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    folder, older = claim(out, plan.system.name, True)
    with pytest.raises(InputError, match=r"cannot be held on processors 4000|nobody can watch"):
        if refused == "watching":
            carry_out(plan, folder, Request("case"), older, watched=watched)
        else:
            paced = planned(plan.system, deadlines="")
            carry_out(paced, folder, Request("case"), older, pace=Pace(cores=(4000,)))
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before


@pytest.mark.parametrize("others", ["another system", "a sweep"])
def test_the_results_of_others_are_refused_before_the_run(others: str, tmp_path: Path) -> None:
    if others == "a sweep":
        (tmp_path / "points.jsonl").write_text("")
    else:
        (tmp_path / "manifest.json").write_text('{"system": "theirs", "files": ["result.nc"]}')
    with pytest.raises(InputError, match=r"holds the results of .*; choose another folder with --out.*--force"):
        require_own(tmp_path, "ours", False)
    require_own(tmp_path, "ours", True)


def test_what_dead_runs_left_is_swept_up_and_nothing_else(tmp_path: Path) -> None:
    dead, alive = 2**22 + 1, os.getpid()
    left = [f".result.{dead}.tmp.nc", f".probe.{dead}.tmp", f".summary.{dead}.tmp.json"]
    kept = [f".result.{alive}.tmp.nc", "result.nc", ".hidden", f".notes.{dead}"]
    for name in (*left, *kept):
        (tmp_path / name).write_text("")
    (tmp_path / f".checkpoint.{dead}.tmp").mkdir()
    assert set(sweep_up(tmp_path)) == {*left, f".checkpoint.{dead}.tmp"}
    assert {path.name for path in tmp_path.iterdir()} == set(kept)


@needs_gcc
def test_names_that_netcdf_forbids_are_stored_as_others_and_opened_by_their_own(tmp_path: Path) -> None:
    names = ["a.gain/y", "a.gain|y", "a.x", "a.y\n", "b.gain/y"]
    found = stored_names(names)
    assert len(set(found.values())) == 5 and found["a.gain|y"] == "a.gain|y" and found["a.x"] == "a.x"
    assert not any("/" in name or "\n" in name for name in found.values())
    cells(tmp_path / "tank.fmu", [scalar("gain/y", 100), scalar("gain|y", 101)])
    run = run_of(tmp_path, tmp_path, {"a": ("tank", "1 ms")}, stop="5 ms")
    write_rows(run, tmp_path / "out")
    with h5py.File(tmp_path / "out" / "result.nc") as file:
        assert file["every_1_ms/a.gain|y_2"].attrs["recorded_name"] == b"a.gain/y"
    read = open_tables(tmp_path / "out" / "result.nc")["every_1_ms"]
    assert read["a.gain/y"].values.tolist() == [100.0] * 6 and read["a.gain|y"].values.tolist() == [101.0] * 6


def test_a_rate_of_which_nothing_is_recorded_has_no_table(tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0}), "v": ("wave", "2 ms", {"c0": 1.0})}
    run = run_of(tmp_path, fmus, parts, stop="10 ms", record=["w.y"])
    assert [group.columns for group in run.plan.groups] == [(("w", "y"),)]
    nothing = run_of(tmp_path, fmus, parts, stop="10 ms", record=[])
    write_results(nothing, tmp_path / "out", {})
    assert (tmp_path / "out" / "result.nc").is_file() and nothing.end == 0.01


def test_rows_that_no_disk_takes_are_an_error_that_says_why(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = run_of(tmp_path, fmus, WAVE, stop="5 ms")
    monkeypatch.setattr(SafeFile, "write", lambda file, data: setattr(file, "error", FULL) or len(data))
    with pytest.raises(RunError, match=r"the rows could not be written: .*No space left on device"):
        write_rows(run, tmp_path / "out")
