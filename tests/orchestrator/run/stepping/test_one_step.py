"""Steps by hand where nothing is to be looked after: quicker, and with the bits, failures and ends of all others."""

from __future__ import annotations

import math
import signal
from pathlib import Path

import pytest
from helpers import read_system
from native_build import moody, needs_gcc
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.loop.cells import STOP_REQUEST
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping

pytestmark = needs_gcc
WHOLE = "if (m->steps == 4) { m->x += h * m->u; return fmi2Discard; }"  # the fourth step, done to its end


def planned(folder: Path, record: list[str], stop: str = "10 ms", **actions: str) -> Plan:
    """g and a moody m drive each other."""
    moody(folder / "m.fmu", **actions)
    moody(folder / "g.fmu")
    parts = {"m": ("m.fmu", "1 ms"), "g": ("g.fmu", "2 ms", {"k": 3.0})}
    wires = ["m.x -> g.u", "g.y -> m.u"]
    return make_plan(read_system(folder, folder, parts, wires, stop, record=record))


def stepped(plan: Plan) -> tuple[object, ...]:
    """What the steps lead to until the stop, or until they fail."""
    seen: list[float] = []
    said = ""
    with Stepping(plan) as session:
        session.step()
        session.loop.looked = math.inf  # however slow the machine is, it is not time to look around
        try:
            while session.time < session.stop:
                session.step()
                seen += [session.time, session.get("m.x"), session.get("g.y")]
        except RunError as error:
            said = str(error)
        return seen, said, session.failure, session.ended, session.time, session.at.cycle


@pytest.mark.parametrize(
    "actions",
    [
        {}, {"ON_STEP": "m->x = t * 0.3;"}, {"ON_STEP": "if (t > 0.0049) return fmi2Error;"},
        {"ON_STEP": "if (t > 0.0049) m->x = 0.0 / 0.0;"}, {"ON_SET": "if (m->steps == 5) return fmi2Error;"},
        {"ON_STEP": WHOLE, "REACHED": "t0 + h0", "TERMINATED": "1"},
    ],
    ids=["nothing", "other", "error", "nan", "set", "asks to end"],
)  # fmt: skip
def test_they_end_where_recorded_ones_end(actions: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    without = planned(tmp_path / "a", [], **actions)
    assert not without.groups
    first = stepped(without)
    assert first[4] and first == stepped(planned(tmp_path / "b", ["*"], **actions))


def test_a_signal_between_two_of_them_is_a_keyboard_interrupt(tmp_path: Path) -> None:
    with Stepping(planned(tmp_path, [])) as session, pytest.raises(KeyboardInterrupt):
        session.step()
        session.step()
        assert session.control[STOP_REQUEST] == 1  # whoever presses Ctrl-C now need not wait
        signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize("record", [[], ["*"]])
def test_nothing_is_measured_for_blocks_where_there_is_room_for_rows(record: list[str], tmp_path: Path) -> None:
    with Stepping(planned(tmp_path, record, "1 s")) as session:
        session.step()
        session.loop.looked, size = math.inf, session.loop._size
        session.step()
        assert session.loop._size == size and session.time == 0.004


def test_rows_of_such_steps_are_those_of_a_run_also_where_the_buffer_ends(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = planned(tmp_path, ["*"], "40 ms")
    whole = simulate(plan)
    monkeypatch.setattr(recorder, "IN_MEMORY", 400)
    monkeypatch.setattr(recorder, "PIECE", 400)
    found = []
    with Stepping(plan) as session:
        session.recorder.file = tmp_path / "rows.nc"
        session.recorder._reserve(3)
        session.recorder._first_row()
        for _ in range(20):
            session.loop.looked = math.inf
            session.step()
            here = [int(n) for n in session.recorder.rows]
            limits = [count * session.recorder.held + 1 for count in session.recorder.per_cycle]
            assert all(n <= most for n, most in zip(here, limits, strict=True))
            found.append((session.recorder.before[0], session.get("m.x")))
    assert found[0][0] == 0 < found[-1][0]
    column = plan.groups[0].columns.index(("m", "x"))
    assert [value for _, value in found] == whole.tables[0][2::2, column].tolist()


def test_a_session_goes_back_and_on_with_them(tmp_path: Path) -> None:
    with Stepping(planned(tmp_path, [], "20 ms")) as session:
        for _ in range(3):
            session.step()
        here, then = session.snapshot(), session.get("m.x")
        ends = []
        for _ in range(3):
            for _ in range(4):
                session.step()
            ends.append((session.time, session.get("m.x"), session.get("g.y")))
            session.restore(here)
            assert session.get("m.x") == then
        assert len(set(ends)) == 1
        session.finish()
        assert session.time == session.stop
        with pytest.raises(RunError, match="no whole step"):
            session.step()
