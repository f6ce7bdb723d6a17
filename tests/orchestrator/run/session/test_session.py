"""A run that is advanced piece by piece."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from car_runs import ALGORITHMS, car, same
from helpers import Part, plan_of
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("interpreted", [False, True])
def test_a_run_in_pieces_is_bitwise_the_run_in_one(
    algorithm: str, interpreted: bool, tmp_path: Path, fmus: Path
) -> None:
    plan = car(tmp_path, fmus, algorithm)
    with Session(plan, interpreted) as session:
        session.advance(cycles=1)
        first = session.tick
        assert first == plan.clock.hyperperiod and session.time == plan.clock.time(first)
        session.advance(cycles=7)
        session.advance(until_tick=plan.clock.stop // 2)
        assert plan.clock.stop // 2 <= session.tick < plan.clock.stop
        middle = session.run()
        assert middle.end == session.time
        session.advance()
        assert session.tick == plan.clock.stop
        pieces = session.run()
    assert same(pieces, simulate(plan))
    for whole, part in zip(pieces.tables, middle.tables, strict=True):
        assert len(part) < len(whole) and part.tobytes() == whole[: len(part)].tobytes()


@pytest.fixture
def gain(tmp_path: Path, fmus: Path) -> Iterator[Session]:
    """g.y = 2 g.u, with g.u free, drives h."""
    parts: dict[str, Part] = {
        "g": ("gain", "1 ms", {"k": 2.0, "offset": 0.0, "=u": 1.0}),
        "h": ("gain", "1 ms", {"k": 3.0}),
    }
    with Session(plan_of(tmp_path, fmus, parts, ["g.y -> h.u"], stop="10 ms")) as session:
        yield session


def test_an_input_that_nothing_drives_can_be_set_between_cycles(gain: Session) -> None:
    gain.advance(cycles=2)
    assert gain.get("g.y") == 2.0
    gain.set("g.u", 5.0)
    gain.advance(cycles=1)
    assert (gain.get("g.u"), gain.get("g.y")) == (5.0, 10.0)
    gain.advance(cycles=1)
    assert gain.get("h.u") == 10.0 and gain.get("h.k") == 3.0


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("h.u", 1.0, "h.u is driven by the connection g.y -> h.u"),
        ("g.k", 1.0, "a parameter is set before the run"),
        ("g.uu", 1.0, "did you mean 'u'"),
        ("gg.u", 1.0, "did you mean 'g'"),
        ("g.u", "fast", "is not a finite number"),
        ("g.u", float("nan"), "is not a finite number"),
    ],
)
def test_what_cannot_be_set_is_a_clear_error(gain: Session, name: str, value: object, message: str) -> None:
    with pytest.raises(InputError, match=message):
        gain.set(name, value)


def test_what_is_not_there_cannot_be_got(gain: Session) -> None:
    with pytest.raises(InputError, match="did you mean 'y'"):
        gain.get("g.yy")
    with pytest.raises(InputError, match="did you mean 'g'"):
        gain.get("gg.y")


def test_a_session_ends_at_the_stop_and_when_it_is_closed(gain: Session) -> None:
    with pytest.raises(InputError, match="stop is at"):
        gain.advance(until_tick=gain.plan.clock.stop + 1)
    gain.advance()
    assert gain.time == 0.01
    gain.advance(cycles=5)
    assert gain.time == 0.01 and len(gain.run().tables[0]) == 11
    gain.close()
    for act in (lambda: gain.set("g.u", 1.0), lambda: gain.get("g.k"), gain.advance):
        with pytest.raises(RunError, match="closed"):
            act()


def test_a_failure_ends_the_session_and_keeps_what_was_recorded(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, {"bad": ("faulty", "5 ms", {"raise_at": 0.02})})
    with Session(plan) as session:
        session.advance()
        assert "component bad" in session.failure and session.run().failure == session.failure
        assert len(session.run().tables[0]) == 1 + round(session.time / 0.005)
        with pytest.raises(RunError, match="component bad"):
            session.advance()
