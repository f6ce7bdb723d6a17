"""An FMU that says wrongly how far a step of its came (lastSuccessfulTime): one error, and every row before it."""

from __future__ import annotations

from pathlib import Path

import clock_build
import pytest
from helpers import plan_of
from rovbrush.orchestrator.run.simulation import simulate

LIES = {
    1: "ended early at nan s",
    2: "ended early at 0.25 s",
    3: "ended early at 0.4 s",
    4: "time stands still at t = 0.3 s",
    5: "ended early at inf s",
}


@pytest.fixture(scope="module")
def liars(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("liars")
    for model in ("liar", "plant"):
        clock_build.clocked(folder / f"{model}.fmu", model)
    return folder


@pytest.mark.sampled(5)
@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("lie", LIES)
def test_a_step_that_ends_early_at_a_time_where_it_cannot_be_is_one_error_behind_all_rows(
    tmp_path: Path, liars: Path, lie: int, isolation: str
) -> None:
    parts = {"l": ("liar", "100 ms", {"lie": lie}), "p": ("plant", "50 ms")}
    keys = {"l": {"isolation": isolation}}
    run = simulate(plan_of(tmp_path, liars, parts, ["l.y -> p.u"], stop="1 s", of=keys))
    assert run.failure is not None and LIES[lie] in run.failure and "Traceback" not in run.failure
    if "ended early" in LIES[lie]:
        assert "component l" in run.failure and "t = 0.3 s" in run.failure and "lastSuccessfulTime" in run.failure
    assert run.end == 0.3
    assert len(run.tables[0]) == 7  # each 50 ms, and the beginning
