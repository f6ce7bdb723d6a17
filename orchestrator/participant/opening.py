"""Instances by version and by where they run."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from ..extras import require
from ..fmu.files.places import is_python
from ..fmu.fmu import Fmu
from ..fmu.kinds import MODEL_EXCHANGE, SCHEDULED_EXECUTION
from ..fmu.outside.declared import DeclaredFmu
from ..fmu.sharing import why_alone
from ..system.component import Component
from .apart.library import used_before
from .base import Participant
from .here.fmi1 import Fmi1Instance
from .here.fmi2 import Fmi2Instance
from .here.fmi3 import Fmi3Instance
from .here.loaded import LoadedInstance
from .messages import Logging

if TYPE_CHECKING:
    from .windows.process import ServerProcess

KINDS: dict[int, type[LoadedInstance]] = {1: Fmi1Instance, 2: Fmi2Instance, 3: Fmi3Instance}


def load(fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> LoadedInstance:
    """An instance in this process, or under wine where its library is for Windows. Raises FmuError if it refuses."""
    require_compiler(fmu, name)
    if fmu.own.windows:
        from .windows.opening import windows_class

        return windows_class(fmu, False)(fmu, name, logging, tolerance)
    if fmu.kind == MODEL_EXCHANGE:
        from .model_exchange.instance import MEMBERS

        return MEMBERS[fmu.version](fmu, name, logging, tolerance)
    if fmu.kind == SCHEDULED_EXECUTION:
        from .here.scheduled import ScheduledInstance

        return ScheduledInstance(fmu, name, logging, tolerance)
    if fmu.own.clocks:  # which need event mode
        return _with_events(fmu, name, logging, tolerance)
    return KINDS[fmu.version](fmu, name, logging, tolerance)


def _with_events(fmu: Fmu, name: str, logging: Logging, tolerance: float | None) -> LoadedInstance:
    from .here.event_mode import EventModeInstance

    return EventModeInstance(fmu, name, logging, tolerance)


def why_not_here(component: Component) -> str:
    """Why a component that was to run in this process cannot; empty if it can."""
    fmu = component.fmu
    if isinstance(fmu, DeclaredFmu) or component.isolation or not hasattr(os, "fork"):
        return ""
    return why_alone(fmu.own) if used_before(fmu.own) else ""


def require_compiler(fmu: Fmu, name: str) -> None:
    """Raise InputError where an FMU is compiled for here, and what does that is not installed."""
    if fmu.kind == MODEL_EXCHANGE:
        require("numba", f"component {name}, an FMU for Model Exchange,")
    elif is_python(fmu.description):
        require("numba", f"component {name}, a Python FMU of `rovbrush build`,")


class Starting:
    """Instances of components, one after the other; processes that take long to start are all started before.

    A process under wine that is not taken is given back in `close`.
    """

    def __init__(self, components: Iterable[Component]) -> None:
        self._waiting: dict[str, ServerProcess] = {}
        try:
            for component in components:
                if component.fmu.own.windows and not component.elsewhere:
                    from .windows.process import ServerProcess

                    self._waiting[component.name] = ServerProcess(component.fmu.own)
        except BaseException:
            self.close()
            raise

    def start(self, component: Component) -> Participant:
        """The instance of a component. Raises FmuError if it refuses."""
        if not component.elsewhere:
            require_compiler(component.fmu, component.name)
        process = self._waiting.pop(component.name, None)
        if process is None:
            return start(component)
        from .here.clock_calls import ClockCalls
        from .windows.opening import windows_class

        kind, limit = windows_class(component.fmu, component.in_events), float(component.timeout)
        instance = kind(component.fmu, component.name, component.logging, component.tolerance, limit, process)
        if isinstance(instance, ClockCalls):
            instance.intervals = component.clocks
        return instance

    def close(self) -> None:
        """End the processes that nobody took."""
        for process in self._waiting.values():
            process.close()
        self._waiting.clear()


def start(component: Component) -> Participant:
    """The instance of a component, in a process of its own where the system says so, or where it must not meet what
    was in this one before; or at the server that the system names."""
    if not component.elsewhere:
        require_compiler(component.fmu, component.name)
    wanted = component.logging, component.tolerance
    if component.fmu.own.windows and not component.elsewhere:
        return Starting([component]).start(component)
    if component.isolation or why_not_here(component):
        begin = None
        if component.elsewhere:
            from .elsewhere.connection import at_server

            begin = at_server(component)
        if component.in_events and component.fmu.kind != MODEL_EXCHANGE:
            from .isolated.events import IsolatedEvents

            limit = float(component.timeout)
            return IsolatedEvents(component.fmu, component.name, limit, *wanted, component.clocks, begin)
        from .isolated.parent import IsolatedInstance

        return IsolatedInstance(component.fmu, component.name, float(component.timeout), *wanted, begin)
    if isinstance(component.fmu, DeclaredFmu):
        from .outside.instance import DeclaredInstance

        return DeclaredInstance(component.fmu, component.name, *wanted)
    if not component.in_events or component.fmu.kind == MODEL_EXCHANGE:
        return load(component.fmu, component.name, *wanted)
    return load_in_events(component.fmu, component.name, *wanted, component.clocks)


def load_in_events(
    fmu: Fmu, name: str, logging: Logging, tolerance: float | None, clocks: Mapping[str, Fraction]
) -> LoadedInstance:
    """An instance in this process that takes part in events; `clocks`: intervals that are chosen for it [s]."""
    from .here.clock_calls import ClockCalls

    scheduled = fmu.kind == SCHEDULED_EXECUTION
    eventful = (load if scheduled else _with_events)(fmu, name, logging, tolerance)
    assert isinstance(eventful, ClockCalls)
    eventful.intervals = clocks
    return eventful
