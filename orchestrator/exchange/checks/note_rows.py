"""Where a file breaks its standard and a run can do without, as it was noted when it was read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...errors import listed
from ...fmu.tolerant.rules import Note
from .rows import Row

STAGE = "standard"


def note_rows(notes: Sequence[Note]) -> Iterator[Row]:
    """One row per rule that is broken; one that passes where none is."""
    if not notes:
        yield Row(STAGE, "what a run can do without", "pass", "nothing is wrong")
    for note in notes:
        found = f"{listed(note.places)}; {note.rule.taken}"
        yield Row(STAGE, note.rule.found, "finding", found, note.rule.mend)
