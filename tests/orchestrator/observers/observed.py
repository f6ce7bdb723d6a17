"""What a run with observers has left."""

from __future__ import annotations

from rovbrush.orchestrator.results.result import Result


def bits(result: Result) -> list[bytes]:
    """Its rows."""
    return [table.tobytes() for table in result.run.tables]


def notes(result: Result) -> list[str]:
    """What it tells of observers."""
    return [note for note in result.run.notes if "observer" in note]
