"""What is done by hand is what a scenario has, also of FMUs with event mode, of Model Exchange, and with clocks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import exchange_build
import pytest
from clock_build import clocked
from helpers import plan_of
from native_build import needs_gcc
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping

pytestmark = needs_gcc
PARTS = {"p": ("plant", "10 ms"), "lag": ("lag", "10 ms"), "w": ("witness", "7 ms")}
VALUES = {'"p.u"': 2.0, '"lag.push"': 1.0, '"lag.tau"': 0.5, '"w.n"': 5, '"w.u"': 3.0}


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("by_hand")
    for name in ("witness", "plant"):
        clocked(folder / f"{name}.fmu", name)
    exchange_build.exchange(folder, "lag")
    return folder


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("time", ["0", "0.07", "0.14"])
def test_the_rows_are_those_of_events_at_that_time(time: str, algorithm: str, tmp_path: Path, fmus: Path) -> None:
    def plan(**when: Any) -> Any:
        return plan_of(tmp_path, fmus, PARTS, stop="0.28 s", events=[{"name": "all", "set": VALUES, **when}],
                       algorithm=algorithm)  # fmt: skip

    with Stepping(plan(by_hand=True)) as session:
        while session.time < float(time):
            session.step()
        session.happen("all")
        session.finish()
        by_hand = session.run()
    by_time = simulate(plan(at=f"{time} s", initial=False))
    assert not by_hand.failure and not by_time.failure
    assert [t.tobytes() for t in by_hand.tables] == [t.tobytes() for t in by_time.tables]
    assert [t.tobytes() for t in by_hand.tables] != [t.tobytes() for t in simulate(plan(by_hand=True)).tables]
