"""A run that goes on from a checkpoint ends bitwise as one that was never interrupted."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from car_runs import ALGORITHMS, car
from helpers import Part, edited, plan_of, system_text
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop import cells, run, turns
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.files.netcdf import write_netcdf
from rovbrush.orchestrator.results.tables import AT_START, Run
from rovbrush.orchestrator.run.checkpoint import fingerprint
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.schema.keys.solving import Solver

pytestmark = pytest.mark.sampled(4)


def resumed(plan: Plan, folder: Path, file: Path | None = None) -> Run:
    """The rest of a run from the checkpoint in a folder."""
    with Session(plan, file=file) as session:
        read_checkpoint(folder).restore(session)
        session.advance()
        return session.run()


def cut(plan: Plan, folder: Path, *cycles: int, file: Path | None = None) -> Run:
    """A run that is put to disk after each of some numbers of cycles and begun anew from there."""
    begun = False
    for count in cycles:
        with Session(plan, file=file) as session:
            if begun:
                read_checkpoint(folder).restore(session)
            session.advance(cycles=count)
            assert not session.failure and session.tick < plan.clock.stop
            write_checkpoint(session, folder)
        begun = True
    return resumed(plan, folder, file)


def require_same(run: Run, whole: Run, folder: Path) -> None:
    """The same rows, and the same result.nc byte by byte."""
    assert not run.failure and run.end == whole.end
    assert [t.tobytes() for t in run.tables] == [t.tobytes() for t in whole.tables]
    for name, found in (("a.nc", run), ("b.nc", whole)):
        write_netcdf(found, folder / name)
    assert (folder / "a.nc").read_bytes() == (folder / "b.nc").read_bytes()


@pytest.mark.sampled(6)
@pytest.mark.parametrize("method", ["aitken", "newton"])
@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_every_algorithm_goes_on_bitwise(algorithm: str, method: str, tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, algorithm)
    if algorithm == "iterated":
        system = replace(plan.system, settings={"iteration": {"method": method}})
        plan = make_plan(system)
    require_same(cut(plan, tmp_path, 1, 30, 7), simulate(plan), tmp_path)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("steps", [1, 101, 102, 104, 107])
def test_ctrl_c_within_a_cycle_goes_on_bitwise(
    algorithm: str, steps: int, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The request comes in a step of an FMU: within a cycle, and of an iterated one within a pass."""
    plan = car(tmp_path, fmus, algorithm)
    with Session(plan, interpreted=True) as session:
        done = [0]

        def step(*arguments: float) -> int:
            done[0] += 1
            session.control[cells.STOP_REQUEST] = done[0] >= steps
            return original(*arguments)

        original = run.step
        monkeypatch.setattr(run, "step", step)
        monkeypatch.setattr(turns, "step", step)
        session.advance()
        monkeypatch.undo()
        assert "interrupted by the user" in session.failure and session.resumable
        assert session.at.operation > 0 or algorithm == "ecco" or steps > 102, "it stops within a cycle"
        write_checkpoint(session, tmp_path)
    require_same(resumed(plan, tmp_path), simulate(plan), tmp_path)


@pytest.mark.sampled(3)
@needs_gcc
@pytest.mark.parametrize("isolation", ["", "process"])
@pytest.mark.parametrize("algorithm", ["jacobi", "iterated"])
@pytest.mark.parametrize("kind", ["feedthrough2", "feedthrough3"])
def test_every_type_in_its_own_process_or_not_goes_on_bitwise(
    kind: str, algorithm: str, isolation: str, tmp_path: Path
) -> None:
    free, wires = (FREE2, WIRES2) if kind == "feedthrough2" else (FREE3, WIRES3)
    parts: dict[str, Part] = {"a": (kind, "1 ms", free), "b": (kind, "2 ms")}
    system = plan_of(tmp_path, built(tmp_path), parts, wires, stop="20 ms", algorithm=algorithm).system
    components = {name: replace(c, isolation=isolation) for name, c in system.components.items()}
    plan = make_plan(replace(system, components=components))
    require_same(cut(plan, tmp_path, 3, 4), simulate(plan), tmp_path)


@pytest.mark.parametrize("version", ["", "fmi2", "fmi3"])
def test_the_nominal_system_goes_on_bitwise(
    version: str, tmp_path: Path, fmus: Path, request: pytest.FixtureRequest
) -> None:
    folder = request.getfixturevalue("native") / version if version else fmus
    plan = make_plan(replace(load_system("nominal", folder), stop=Fraction(1, 5)))
    require_same(cut(plan, tmp_path, 3), simulate(plan), tmp_path)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_run_that_is_recorded_to_disk_goes_on_bitwise(
    algorithm: str, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, size in (("IN_MEMORY", 2000), ("PIECE", 700), ("CHUNK", 5)):
        monkeypatch.setattr(recorder, name, size)
    plan = car(tmp_path, fmus, algorithm)
    run = cut(plan, tmp_path, 31, 20, file=tmp_path / "rows.nc")
    assert (tmp_path / "checkpoint" / "rows.nc").is_file() and not isinstance(run.recorded, list)
    require_same(run, simulate(plan), tmp_path)


def test_what_cannot_be_written_to_disk_is_named(tmp_path: Path, fmus: Path) -> None:
    flags = {'canSerializeFMUstate="true"': 'canSerializeFMUstate="false"'}
    edited(fmus / "wheel.fmu", tmp_path / "wheel.fmu", {}, flags)
    (tmp_path / "chassis.fmu").write_bytes((fmus / "chassis.fmu").read_bytes())
    with Session(car(tmp_path, tmp_path, "jacobi")) as session, pytest.raises(InputError) as refused:
        write_checkpoint(session, tmp_path)
    assert "component w: wheel.fmu" in str(refused.value) and "canSerializeFMUstate = false" in str(refused.value)
    assert not (tmp_path / "checkpoint").exists()


def with_choice(system: System, name: str, **choice: Any) -> System:
    return system.with_component(replace(system.components[name], **choice))


def test_a_changed_fmu_value_or_schedule_is_refused(tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, "jacobi")
    cut(plan, tmp_path, 5)
    system = plan.system
    other = tmp_path / "other"
    other.mkdir()
    for name in ("wheel", "chassis"):
        edited(fmus / f"{name}.fmu", other / f"{name}.fmu", {"extra.txt": b"new"})
    for changed, words in (
        (car(tmp_path, other, "jacobi").system, "component w: the FMU has changed, wheel.fmu had sha256"),
        (system.with_values({"w.m_w": 41.0}, "test"), "w.m_w was None, now it is 41.0"),
        (replace(system, stop=2 * system.stop), "another stop now: was 3/10, now 3/5"),
        (system.with_periods(Fraction(1, 2)), "another tick now: was 1/1000, now 1/2000"),
        (replace(system, record=("w.*",)), "another recorded now"),
        (with_choice(system, "w", tolerance=1e-5), "component w: tolerance was None, now it is 1e-05"),
        (with_choice(system, "w", event_mode="off"), "component w: event_mode was offered, now it is off"),
        (replace(system, solver=Solver(tolerance=1e-3)), "another solving now"),
        (replace(system, algorithm="iterated"), "another algorithm now: was jacobi, now iterated"),
    ):
        with pytest.raises(InputError) as refused:
            resumed(make_plan(changed), tmp_path)
        assert "cannot go on from the checkpoint" in str(refused.value) and words in str(refused.value)


def test_a_damaged_or_missing_checkpoint_is_refused(tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, "jacobi")
    with pytest.raises(InputError, match="there is no checkpoint in"):
        resumed(plan, tmp_path)
    cut(plan, tmp_path, 5)
    place = tmp_path / "checkpoint"
    content = (place / "0.state").read_bytes()
    (place / "0.state").write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    with pytest.raises(InputError, match=r"damaged: 0\.state is not what was written"):
        resumed(plan, tmp_path)
    (place / "0.state").write_bytes(content)
    head = json.loads((place / "checkpoint.json").read_text())
    (place / "checkpoint.json").write_text(json.dumps({**head, "files": {"../../secret": "0"}}))
    with pytest.raises(InputError, match="damaged"):
        resumed(plan, tmp_path)
    (place / "checkpoint.json").write_text("{")
    with pytest.raises(InputError, match="damaged"):
        resumed(plan, tmp_path)


@needs_gcc
@pytest.mark.parametrize("isolation", ["", "process"])
def test_elements_of_an_array_that_were_set_by_hand_are_there_after_it(isolation: str, tmp_path: Path) -> None:
    """An FMU wants all elements at once: those beside the one that is set next are known from the checkpoint."""
    plan = plan_of(tmp_path, built(tmp_path), {"a": ("feedthrough3", "1 ms", FREE3)}, stop="20 ms")
    components = {name: replace(c, isolation=isolation) for name, c in plan.system.components.items()}
    plan = make_plan(replace(plan.system, components=components))
    element = plan.system.components["a"].fmu.expand("a_in")[0]
    with Session(plan) as session:
        session.set("a.a_in", [float(k) for k in range(10, 18)])
        session.advance(cycles=3)
        write_checkpoint(session, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        session.set(f"a.{element}", 99.0)
        session.advance(cycles=1)
        assert session.get("a.a_out") == [99.0, *range(11, 18)]


@pytest.mark.parametrize("suffix", ["tmp", "old"])
def test_a_checkpoint_is_found_where_a_process_died_while_it_renamed(suffix: str, tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, "jacobi")
    cut(plan, tmp_path, 5)
    (tmp_path / "checkpoint").rename(tmp_path / f".checkpoint.{2**22 + 1}.{suffix}")
    half = tmp_path / f".checkpoint.{2**22 + 2}.tmp"
    half.mkdir()
    (half / "checkpoint.json").write_text("{")
    require_same(resumed(plan, tmp_path), simulate(plan), tmp_path)
    assert (tmp_path / "checkpoint").is_dir()


def test_a_head_that_was_edited_is_refused_also_under_a_right_hash(tmp_path: Path, fmus: Path) -> None:
    """Another cycle would give wrong rows, another operation a crash."""
    plan = car(tmp_path, fmus, "jacobi")
    cut(plan, tmp_path, 5)
    place = tmp_path / "checkpoint"
    head = json.loads((place / "checkpoint.json").read_text())
    for key, value in (("cycle", 6), ("cycle", "x"), ("operation", -(10**9)), ("operation", 10**9), ("time", 0.7)):
        (place / "checkpoint.json").write_text(json.dumps({**head, "at": {**head["at"], key: value}}))
        with pytest.raises(InputError, match=r"damaged: checkpoint\.json is not what was written"):
            resumed(plan, tmp_path)
        digest = hashlib.sha256((place / "checkpoint.json").read_bytes()).hexdigest()
        (place / "checkpoint.sha256").write_text(f"{digest}  checkpoint.json\n")
        with pytest.raises(InputError, match="damaged"):
            resumed(plan, tmp_path)


def test_another_version_or_processor_is_refused_unless_forced(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = car(tmp_path, fmus, "jacobi")
    cut(plan, tmp_path, 5)
    now = fingerprint.environment()
    for key in ("rovbrush", "numba", "processor"):
        monkeypatch.setattr(fingerprint, "environment", lambda key=key: {**now, key: "another"})
        with pytest.raises(InputError, match=rf"{key} .*now another.*--force"):
            resumed(plan, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session, force=True)
        assert session.time == 0.015


EVENTS = """
[[events]]
at = "3.2 ms"
set = { "motor.V_in" = 9.0, "brush.delta" = "3 mm" }
[[events]]
when = "motor.omega_b > 1 rad/s"
repeat = true
after = "2 ms"
fault = "hold"
on = "motor.T_brush"
for = "8 ms"
[[events]]
at = "12 ms"
fault = "noise"
on = "motor.omega_b"
value = 0.1
seed = 5
"""


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_events_that_have_happened_and_are_to_come_go_on_bitwise(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"motor": ("dc_motor", "0.5 ms"), "brush": ("filament_brush", "0.5 ms")}
    text = system_text(parts, ["motor.omega_b -> brush.omega_b", "brush.T_brush -> motor.T_brush"], stop="40 ms",
                       algorithm=algorithm)  # fmt: skip
    (tmp_path / "case.toml").write_text(text + EVENTS, encoding="utf-8")
    plan = make_plan(load_system(str(tmp_path / "case.toml"), fmus))
    whole, again = simulate(plan), cut(plan, tmp_path, 5, 6, 4, 8, 20)
    require_same(again, whole, tmp_path)
    told = {row.what.partition(":")[0] for row in whole.events} - {"", AT_START}
    assert len(told) == 3  # all have happened


def test_a_checkpoint_of_other_events_is_refused(tmp_path: Path, fmus: Path) -> None:
    text = system_text({"motor": ("dc_motor", "0.5 ms")}, [], stop="10 ms")
    plans = []
    for value in (9.0, 8.0):
        event = f'\n[[events]]\nat = "5 ms"\nset = {{ "motor.V_in" = {value} }}\n'
        (tmp_path / "case.toml").write_text(text + event, encoding="utf-8")
        plans.append(make_plan(load_system(str(tmp_path / "case.toml"), fmus)))
    with Session(plans[0]) as session:
        session.advance(cycles=3)
        write_checkpoint(session, tmp_path)
    with Session(plans[1]) as session, pytest.raises(InputError, match="the system has another scenario now"):
        read_checkpoint(tmp_path).restore(session)
