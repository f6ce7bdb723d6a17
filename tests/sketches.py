"""Instead of pictures of runs, for tests that do not look at them: one grey dot in each file that would be there."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from rovbrush.orchestrator.results.files import writing
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run

WORDS = ("png", "picture", "figure", "overview", "matplotlib")
DOT = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010800000000"
    "3a7e9b550000000a49444154789c63680000008200817775a5b80000000049454e44ae426082"
)
drawn_figure = writing._figure


@cache
def spoken_of(path: Path) -> bool:
    """Whether a file of tests has to do with pictures."""
    text = path.read_text(encoding="utf-8").lower()
    return any(word in text for word in WORDS)


def overview(run: Run, folder: Path) -> list[Path]:
    from rovbrush.orchestrator.results.pictures.traces import run_traces

    return [_dot(folder / writing.OVERVIEW)] if run_traces(run).usual() else []


def figure(run: Run, entry: Mapping[str, Any], folder: Path) -> list[Path]:
    if "signals" not in entry or "along" in entry:
        return drawn_figure(run, entry, folder)
    signals = Signals(run)
    return [_dot(folder / str(entry["file"]))] if all(name in signals for name in entry["signals"]) else []


def _dot(path: Path) -> Path:
    return writing.write_file(path, lambda temporary: temporary.write_bytes(DOT))
