"""The state of a run in memory: that of its FMUs, all cells, and how far it is."""

from __future__ import annotations

from copy import copy

import numpy as np

from ...run.events import kept as events_kept
from ...run.stepping import Stepping


class Kept:
    """Of a session between two steps; to be gone back to as often as wanted, until it is forgotten."""

    def __init__(self, session: Stepping) -> None:
        self.states = [instance.save() for instance in session.instances.values()]
        self.cells = [array.copy() for array in _arrays(session)]
        self.at, self.rows = copy(session.at), session.recorder.rows.copy()
        events = session.events
        self.scenario = events.scenario.content() if events.scenario else None
        self.events = events_kept.content_of(events.handler) if events.handler else None

    def restore(self, session: Stepping) -> None:
        """Go back. Raises FmuError if an FMU refuses."""
        for state, instance in zip(self.states, session.instances.values(), strict=True):
            instance.restore(state)
        for array, kept in zip(_arrays(session), self.cells, strict=True):
            array[...] = kept
        session.at = copy(self.at)
        session.recorder.rows[...] = self.rows
        events = session.events
        if events.scenario and self.scenario is not None:
            events.scenario.restore(self.scenario)
        if events.handler and self.events is not None:
            events_kept.restore(events.handler, self.events)
            events.handler.plan_next()
        elif events.macro:
            events.macro.aim()

    def forget(self, session: Stepping) -> None:
        """Give the states of the FMUs back."""
        for state, instance in zip(self.states, session.instances.values(), strict=True):
            instance.forget(state)


def _arrays(session: Stepping) -> list[np.ndarray]:
    space = session.space
    return [session.memory.z, space.clock, space.loop.work, space.loop.saved, space.solver]
