"""Where an FMU breaks the standard and a run can do without, as it was noted when it was read."""

from __future__ import annotations

from collections.abc import Iterator

from ...errors import listed
from .rows import Row
from .subject import Subject

STAGE = "standard"


def note_rows(subject: Subject) -> Iterator[Row]:
    """One row per rule that is broken; one that passes where none is."""
    if not subject.notes:
        yield Row(STAGE, "what a run can do without", "pass", "nothing is wrong")
    for note in subject.notes:
        found = f"{listed(note.places)}; {note.rule.taken}"
        yield Row(STAGE, note.rule.found, "finding", found, note.rule.mend)
