"""A run in real time does not wait for the disk: its rows are written behind it, and none is lost for that."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import h5py
import numpy as np
import pytest
from car_runs import car
from helpers import Part, plan_of
from native_build import FREE2, WIRES2, built, needs_gcc
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.files.netcdf import group_name
from rovbrush.orchestrator.results.files.safe_file import SafeFile
from rovbrush.orchestrator.run.carry_out import Finished, carry_out, claim
from rovbrush.orchestrator.run.pacing.pace import Pace
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.recording.behind import WrittenBehind
from rovbrush.orchestrator.run.recording.stream import Stream
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.request import Request

FULL = OSError(28, os.strerror(28))
PACE = Pace(1000.0)


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few hundred bytes are many."""
    monkeypatch.setattr(recorder, "IN_MEMORY", 2000)
    monkeypatch.setattr(recorder, "PIECE", 700)


@pytest.fixture
def plan(tmp_path: Path, fmus: Path) -> Plan:
    return planned(car(tmp_path, fmus, "jacobi").system, deadlines="")


def done(plan: Plan, out: Path) -> Finished:
    folder, older = claim(out, plan.system.name, False)
    return carry_out(plan, folder, Request("case"), older, pace=PACE)


def require_first_rows(found: Finished, plan: Plan) -> None:
    """The file has every row until the end of the run, with the bits of one that is undisturbed."""
    whole = simulate(make_plan(plan.system))
    with h5py.File(found.written.folder / "result.nc") as file:
        for g, (table, group) in enumerate(zip(whole.tables, plan.groups, strict=True)):
            written = file[group_name(plan, g)]
            assert len(written["time"]) == len(found.run.tables[g]) > 0
            for k, key in enumerate(group.columns):
                column = written[".".join(key)][:]
                assert column.tobytes() == np.ascontiguousarray(table[: len(column), k]).astype(column.dtype).tobytes()


@pytest.mark.parametrize("pieces", [1, 3])
def test_rows_that_are_written_behind_are_those_in_memory(pieces: int, plan: Plan, tmp_path: Path) -> None:
    with Session(plan, file=tmp_path / "rows.nc", pace=PACE) as session:
        for k in range(1, pieces + 1):
            session.advance(until_tick=plan.clock.stop * k // pieces)
            session.run()
        run = session.run()
        assert isinstance(session.recorder.stream, WrittenBehind) and not run.failure
        assert [t.tobytes() for t in run.tables] == [t.tobytes() for t in simulate(make_plan(plan.system)).tables]


def test_a_run_goes_on_while_its_rows_are_on_their_way(
    plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    going, append, heard = threading.Event(), Stream.append, list[bool]()

    def slowly(stream: Stream, tables: list[np.ndarray]) -> None:
        heard.append(going.wait(30.0))
        append(stream, tables)

    monkeypatch.setattr(Stream, "append", slowly)
    with Session(plan, file=tmp_path / "rows.nc", pace=PACE) as session:
        while session.recorder.stream is None:
            session.advance(cycles=1)
        session.advance(cycles=1)
        assert not heard or not going.is_set()
        going.set()
        session.advance()
        run = session.run()
        assert [t.tobytes() for t in run.tables] == [t.tobytes() for t in simulate(make_plan(plan.system)).tables]
    assert len(heard) > 2 and all(heard)


@pytest.mark.parametrize("pieces", [0, 1, 2, 5])
def test_a_disk_that_fills_up_costs_no_row(
    pieces: int, plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = [pieces]

    def allocate(_descriptor: int, _at: int, _size: int) -> None:
        left[0] -= 1
        if left[0] < 0:
            raise FULL

    monkeypatch.setattr(os, "posix_fallocate", allocate)
    found = done(plan, tmp_path / "out")
    assert "No space left" in found.run.failure and 0.0 < found.run.end < plan.clock.time(plan.clock.stop)
    require_first_rows(found, plan)


@pytest.mark.parametrize("piece", [0, 1, 3])
@pytest.mark.parametrize("times", [1, 2, 3])
def test_a_piece_that_is_refused_is_written_before_those_behind_it(
    piece: int, times: int, plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    append, count = Stream.append, [0]

    def refuse(stream: Stream, tables: list[np.ndarray]) -> None:
        count[0] += 1
        if piece < count[0] <= piece + times:
            raise RunError(f"cannot write {stream.path}: {FULL}")
        append(stream, tables)

    monkeypatch.setattr(Stream, "append", refuse)
    found = done(plan, tmp_path / "out")
    assert "cannot write" in found.run.failure and found.run.end > 0.0
    require_first_rows(found, plan)


def test_a_folder_that_refuses_has_its_rows_elsewhere(
    plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    write = SafeFile.write

    def refuse(file: SafeFile, data: object) -> int:
        if file.path.parent.name == "out" and file.error is None:
            file.error = FULL
        return write(file, data)

    monkeypatch.setattr(SafeFile, "write", refuse)
    found = done(plan, tmp_path / "out")
    assert "No space left" in found.written.elsewhere and str(found.written.folder) in found.written.elsewhere
    require_first_rows(found, plan)


@needs_gcc
def test_texts_are_written_while_the_run_waits(tmp_path: Path) -> None:
    """They are shared with the loop."""
    parts: dict[str, Part] = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "2 ms")}
    plan = planned(plan_of(tmp_path, built(tmp_path), parts, WIRES2, stop="40 ms").system, deadlines="")
    with Session(plan, file=tmp_path / "rows.nc", pace=PACE) as session:
        session.advance()
        run = session.run()
        assert type(session.recorder.stream) is Stream
        assert [t.shape for t in run.tables] == [t.shape for t in simulate(make_plan(plan.system)).tables]
