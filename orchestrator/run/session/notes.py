"""What is told of a run beside its rows: notes that come while it goes, each once, and what a checkpoint forgets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ...participant.base import Participant
from ..participants import Participants

if TYPE_CHECKING:
    from ...participant.model_exchange.group import Group
    from ..blocks.workers import Workers


class Notes:
    """Of a run with its participants; `solved`: those that a solver of ours integrates."""

    def __init__(self, participants: Participants, solved: Sequence[Group | Participant]) -> None:
        self._participants, self._solved = participants, solved
        self._counted: list[str] = []  # notes that change while the run goes: what came from outside

    def so_far(self, workers: Workers | None) -> list[str]:
        """The run's own list: what happens in the end of its components comes to it."""
        notes = self._participants.notes
        notes[:] = [note for note in notes if note not in self._counted]
        outside = (one for one in self._participants.by_name.values() if not one.fmu.is_file)
        self._counted = [note for one in outside for note in one.notes()]
        if workers and workers.said:
            self._counted.append(workers.said)
        further = [*(note for one in self._solved for note in one.notes()), *self._counted]
        notes += [note for note in further if note not in notes]
        return notes

    def forgotten(self) -> list[str]:
        """What a checkpoint that was written here does not hold, in words."""
        return [words for one in self._solved if (words := one.forgets())]
