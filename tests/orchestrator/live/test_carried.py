"""Live runs one behind the other: every attempt keeps its rows, and no folder of anybody is written over."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from helpers import plan_of
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.live.carried import SCENARIO, run_live
from rovbrush.orchestrator.live.messages import Do, packed_command
from rovbrush.orchestrator.live.touch import touchable
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.system.request import Request


class Hands:
    """In a server's place: who gives the next commands each time that a run waits for some."""

    gone, closed, dropped = False, False, 0

    def __init__(self, *commands: list[Do]) -> None:
        self._coming: Iterator[list[Do]] = iter(commands)

    def wire(self) -> Any:
        return self

    def take(self, patience: float = 0.0) -> list[bytes]:
        if not patience:  # the run goes on meanwhile, faster or slower
            return []
        return [packed_command(do) for do in next(self._coming, [])]

    def post(self, _message: bytes, _waiting: int = 0) -> bool:
        return True


@pytest.fixture
def plan(tmp_path: Path, fmus: Path) -> Plan:
    found = plan_of(tmp_path, fmus, {"g": ("gain", "1 ms", {"k": 2.0, "=u": 1.0})}, [], stop="20 ms")
    return planned(touchable(found.system), deadlines="")


def run(plan: Plan, out: Path, *commands: list[Do], **keys: Any) -> list[Path]:
    """The folders of the attempts."""
    server: Any = Hands(*commands)
    return [one.written.folder for one in run_live(plan, Request("case"), server, out, speed=0.0, **keys)]


def test_a_reset_begins_in_a_folder_that_nobody_has(plan: Plan, tmp_path: Path) -> None:
    for name in ("live", "live_2", "live_4"):
        (tmp_path / name).mkdir()
    (tmp_path / "live_2" / "mine.txt").write_text("kept")
    change = [Do("step"), Do("set", "g.u", 3.0), Do("step"), Do("step")]
    folders = run(plan, tmp_path / "live", [*change, Do("reset")], [Do("reset")], [Do("start")], stay=False)
    assert [folder.name for folder in folders] == ["live", "live_3", "live_5"]
    assert [path.name for path in (tmp_path / "live_2").iterdir()] == ["mine.txt"]
    assert not any((tmp_path / "live_4").iterdir())
    assert [json.loads((folder / "summary.json").read_text())["simulated_s"] for folder in folders] == [
        0.003,
        0.0,
        0.02,
    ]
    done = [tomllib.loads((folder / SCENARIO).read_text()).get("events", []) for folder in folders]
    assert [event["set"] for event in done[0]] == [{"g.u": 3.0}] and done[1:] == [[], []]


def test_a_run_that_has_ended_can_be_begun_again_and_ended_for_good(plan: Plan, tmp_path: Path) -> None:
    folders = run(plan, tmp_path / "live", [Do("start")], [Do("step")], [Do("reset")], [Do("start")], [Do("end")])
    assert [folder.name for folder in folders] == ["live", "live_2"]
    assert all((folder / "result.nc").is_file() for folder in folders)


def test_a_page_that_does_not_come_ends_the_run_with_words_and_its_first_row(plan: Plan, tmp_path: Path) -> None:
    def ready() -> None:
        raise RunError("the page's server did not start")

    server: Any = Hands()
    (finished,) = run_live(plan, Request("case"), server, tmp_path / "live", ready=ready, stay=False)
    assert "the page's server did not start" in " ".join(finished.failures)
    assert (tmp_path / "live" / "result.nc").is_file()
