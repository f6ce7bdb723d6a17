"""A run of one plan again and again with other values, by FMUs that stay loaded: each bit for bit one with fresh FMUs.

What a reset brings back is known of the project's own FMUs alone, which keep nothing outside of their instances; all
others are loaded anew. A run that goes wrong here says nothing: a fresh one does, in its own words.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from types import TracebackType

import numpy as np

from ...errors import RovbrushError, RunError
from ...fmu.files.places import is_python
from ...fmu.kinds import CO_SIMULATION
from ...fmu.sharing import made_here
from ...loop.texts import USED_COUNT
from ...participant.here.loaded import LoadedInstance
from ...plan.plan import Plan
from ...results.tables import Run
from ...system.assigned import Values
from ...system.component import Component
from ..position import Position
from ..session.session import Session
from ..start.initialize import initialize
from .quick_start import QuickStart, why_not_quick


def why_anew(plan: Plan) -> str:
    """Why each run of a plan needs FMUs that are loaded anew; empty where they can be kept."""
    for name, component in plan.system.components.items():
        if why := _why_not_kept(component):
            return f"component {name} {why}"
    if plan.system.events or plan.events or plan.exchange or plan.deadlines:
        return "the system has events, FMUs for Model Exchange or deadlines"
    if plan.adaptive or plan.algorithm.saves_states:
        return f"{plan.algorithm.name} saves states of the FMUs, or varies its steps"
    return ""


def _why_not_kept(component: Component) -> str:
    fmu = component.fmu
    if not fmu.is_file or fmu.own is not fmu or not made_here(fmu) or is_python(fmu.description):
        return "is no native FMU of ours, of which alone it is known what a reset brings back"
    if component.isolation or fmu.windows or fmu.kind != CO_SIMULATION or fmu.version == 1:
        return "does not run in this process by co-simulation of FMI 2.0 or 3.0"
    if component.series or fmu.structure:
        return "has inputs that follow tables, or structural parameters"
    return ""


class Again:
    """The session of a plan for which `why_anew` is empty. Raises FmuError or InputError if its FMUs cannot start.

        with Again(plan) as again:
            for values in points:
                run = again.run(values)

    `points`: parameters and inputs of components, as `System.checked` gives them.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.session = session = Session(plan)
        self._instances = session.instances
        held: list[np.ndarray] = [session.control, session.memory.raw, *session.space.arrays]
        self._first = [(array, array.copy()) for array in held if array.size]
        self._texts = session.memory.texts.content()
        self._quick = None if why_not_quick(plan) else QuickStart(plan, session)

    def run(self, values: Values) -> Run:
        """Run with other values; the tables are those of this session until the next call.

        Raises RovbrushError where anything is not as in a run that goes well; the session is of no further use then.
        """
        session, plan = self.session, self.plan
        for array, first in self._first:
            array[...] = first
        session.memory.z[:] = 0.0
        texts = session.memory.texts
        if texts.index[USED_COUNT] != self._texts[1][USED_COUNT]:
            texts.restore(*self._texts)
        if self._quick is None:
            for instance in self._instances.values():
                assert isinstance(instance, LoadedInstance)
                instance.reset()
                instance.arrays.clear()
            initialize(replace(plan, system=plan.system.with_checked(values)), self._instances, session.memory)
        elif not self._quick.start(values):
            raise RunError("the start is not found")
        session.recorder.begin_again()
        session.at = Position(time=plan.clock.time(0))
        session.revive()
        session.straight_on()
        if session.failure or session.ended:
            raise RunError(session.failure or session.ended)
        tables = session.recorder.tables(session.recorder.rows[: len(plan.groups)].tolist())
        return Run(plan, tables, "", session.at.time, session.at.wall, texts=texts)

    def close(self) -> None:
        """Give the FMUs back."""
        with suppress(RovbrushError):
            self.session.close()

    def __enter__(self) -> Again:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
