"""What is told of a run that goes on, where there is no terminal."""

from __future__ import annotations

from io import StringIO
from types import SimpleNamespace

import pytest
from rich.console import Console
from rovbrush.orchestrator.cli import progress


def test_the_time_left_does_not_count_what_came_before_the_first_report(monkeypatch: pytest.MonkeyPatch) -> None:
    written, times = StringIO(), iter((0.0, 100.0, 101.0))
    monkeypatch.setattr(progress, "console", Console(file=written, width=100))
    monkeypatch.setattr(progress, "PLAIN_INTERVAL", 0.0)
    monkeypatch.setattr(progress, "time", SimpleNamespace(monotonic=lambda: next(times)))
    with progress.progress(10.0, "running x") as report:
        report(0.1)
        report(1.0)
    assert written.getvalue() == "running x: 1 of 10 s, 10 s left\n"
