"""TEMPORARY until run/snapshot lands."""

from __future__ import annotations

from copy import copy

from ...run.stepping import Stepping


class Kept:
    def __init__(self, session: Stepping) -> None:
        self.states = [instance.save() for instance in session.instances.values()]
        space = session.space
        self.arrays = [a.copy() for a in (session.memory.z, space.clock, space.loop.work, space.loop.saved, space.solver)]
        self.control = session.control.copy()
        self.at = copy(session.at)
        self.rows = session.recorder.rows.copy()
        self.scenario = session.events.scenario.content() if session.events.scenario else None
        self.same = session.events.handler

    def restore(self, session: Stepping) -> None:
        for state, instance in zip(self.states, session.instances.values(), strict=True):
            instance.restore(state)
        space = session.space
        for a, b in zip((session.memory.z, space.clock, space.loop.work, space.loop.saved, space.solver), self.arrays):
            a[...] = b
        session.at = copy(self.at)
        session.recorder.rows[...] = self.rows
        if self.scenario:
            session.events.scenario.restore(self.scenario)
        if session.events.handler:
            session.events.handler.plan_next()

    def forget(self, session: Stepping) -> None:
        for state, instance in zip(self.states, session.instances.values(), strict=True):
            instance.forget(state)
