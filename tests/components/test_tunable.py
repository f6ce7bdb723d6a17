"""Tunable parameters: set between two steps they count from the next one on, with the same bits in every life."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import Part, plan_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.run.stepping.stepping import Stepping

LIVES = ("python", "fmi2", "fmi3")
CHANGED = {"K_velocity": [60.0, 80.0, 180.0], "K_attitude": [2.0, 2.0, 1.0], "v_max": 0.2, "mode": 1, "K_windup": 1.0}


@pytest.fixture(params=LIVES)
def folder(request: pytest.FixtureRequest) -> Path:
    if request.param == "python":
        return Path(request.getfixturevalue("fmus"))
    return Path(request.getfixturevalue("native")) / str(request.param)


def plan(tmp_path: Path, fmus: Path, **parameters: object) -> Plan:
    """A controller that is half a metre above where it is to be, and tilted."""
    measured = {"=z_ref": 0.5, "=theta": 0.2, "=w": 0.05, "=q": 0.1}
    parts: dict[str, Part] = {"c": ("rov_controller", "20 ms", {**measured, **parameters})}
    return plan_of(tmp_path, fmus, parts, [], stop="400 ms")


def rows(session: Stepping) -> list[list[float]]:
    return [table.tolist() for table in session.result().run.tables]


def test_it_counts_from_the_next_step_on_as_if_it_had_been_so_from_the_start(tmp_path: Path, folder: Path) -> None:
    with Stepping(plan(tmp_path, folder, **CHANGED)) as session:
        session.finish()
        wanted = rows(session)
    with Stepping(plan(tmp_path, folder)) as session:
        first = session.snapshot()
        session.finish()
        other = rows(session)
        session.restore(first)
        for name, value in CHANGED.items():
            session.set(f"c.{name}", value)
        session.finish()
        assert rows(session) == wanted != other  # nothing was derived from it at the start
        session.restore(first)
        session.finish()
        assert rows(session) == other  # a state holds the parameters of its time


def test_a_change_in_the_middle_has_the_same_bits_in_every_life(tmp_path: Path, fmus: Path, native: Path) -> None:
    found = []
    for folder in (fmus, native / "fmi2", native / "fmi3"):
        with Stepping(plan(tmp_path, folder)) as session:
            for _ in range(7):
                session.step()
            session.set("c.K_velocity_i", [0.0, 10.0, 20.0])
            assert session.get("c.K_velocity_i") == [0.0, 10.0, 20.0]
            session.finish()
            found.append(rows(session))
    assert found[0] == found[1] == found[2]


def test_one_that_is_fixed_or_out_of_range_is_refused(tmp_path: Path, folder: Path) -> None:
    with Stepping(plan(tmp_path, folder)) as session:
        session.step()
        with pytest.raises(InputError, match="a parameter is set before the run"):
            session.set("c.T_s", 0.01)
        with pytest.raises(InputError, match=r"c\.mode = 4"):
            session.set("c.mode", 4)
        session.step()
