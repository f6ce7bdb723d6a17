"""Event mode, clocks, partitions and bytes of FMUs for Windows: the same bits as the same sources give here."""

from __future__ import annotations

from pathlib import Path

import pytest
from clock_build import built
from clock_cases import CASES, SCHEDULED, Case, run_case, same
from helpers import plan_of
from rovbrush.orchestrator.run.simulation import simulate
from windows_build import clocked_for_windows, needs_wine

pytestmark = [needs_wine, pytest.mark.sampled(4)]


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("clocks"))


@pytest.fixture(scope="module")
def windows(here: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return clocked_for_windows(here, tmp_path_factory.mktemp("windows"))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", [*CASES, *SCHEDULED])
def test_events_under_wine_give_the_same_bits(name: str, tmp_path: Path, here: Path, windows: Path) -> None:
    case = (CASES | SCHEDULED)[name]
    parts = {
        part: (str(windows / f"{fmu}.fmu") if part in case.moved else fmu, *rest)
        for part, (fmu, *rest) in case.parts.items()
    }
    expected = run_case(case, tmp_path, here)
    found = run_case(Case(parts, *case[1:]), tmp_path, here)
    assert not expected.failure and not found.failure and same(expected, found)


@pytest.mark.parametrize(("fault", "words"), [
    (1, "its process crashed with an access violation"), (2, "its process did not answer within 2 s and was ended"),
    (3, "its process ended by itself with exit code 3"),
])  # fmt: skip
def test_what_ends_wine_at_an_event_is_named_and_rows_are_kept(
    fault: int, words: str, tmp_path: Path, windows: Path
) -> None:
    parts = {"s": ("trouble", "100 ms", {"fault": fault})}
    keys = {"isolation": "process", "timeout": "2 s"}
    run = simulate(plan_of(tmp_path, windows, parts, stop="1 s", of={"s": keys}))
    assert run.failure.startswith("component s: its process") and words in run.failure
    assert "in the call `update its discrete states`" in run.failure
    assert len(run.tables[0]) == 5 and [row.time for row in run.events][-1] == 0.5  # at 0, 0.1 ... 0.4 s
