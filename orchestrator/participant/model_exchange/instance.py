"""Instances of FMUs for Model Exchange, FMI 2.0 and 3.0, in this process.

Between communication points they are in continuous-time mode. What may be set only in event mode (tunable parameters,
sampled inputs) puts the whole group there; its next step begins with the event.
"""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from fmpy import fmi1, fmi2, fmi3

from ...fmu.types import REALS
from ...integration import cells
from ...integration.memory import call, call_whole, put_whole, whole
from ...integration.settings import SolverSettings
from ..base import AskedToEndError, CallError, Participant
from ..here.fmi1 import Answers, Fmi1Instance
from ..here.fmi2 import Fmi2Instance
from ..here.fmi3 import LOGGER, Fmi3Instance
from ..here.library import Judged
from ..here.loaded import LoadedInstance
from ..here.message_filter import Row, address_of, filtered
from ..lifecycle import DISCARD, ERROR, FATAL, State
from .group import Group

BOUND = ("save", "restore", "forget")  # functions of a group, in the order of Participant's state functions


class FMU1Model(Answers, Judged, fmi1.FMU1Model):  # type: ignore[misc]
    """fmpy's, with the calls of an FMU for co-simulation."""

    fmi1FreeSlaveInstance = fmi1.FMU1Model.fmi1FreeModelInstance

    def instantiate(self, kind: str, functions: Any, loggingOn: bool) -> None:
        super().instantiate(functions, loggingOn)

    def initialize(self, start: float, stop: float | None) -> None:
        self.setTime(start)
        super().initialize()

    def reset(self) -> None:
        raise NotImplementedError("FMI 1.0 has no reset for model exchange")


class FMU2Model(Judged, fmi2.FMU2Model):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class FMU3Model(Judged, fmi3.FMU3Model):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Member(LoadedInstance):
    """What both versions have in common. Whoever runs it alone needs no group: it makes one of itself.

    The first member of a group stands for it: its state is saved with what the group keeps.
    """

    group: Group | None = None  # of its system; made when it is first needed where there is none
    settings, goes_back, rests_in_events = SolverSettings(), False, False  # of a group of its own

    def join(self, group: Group) -> None:
        """Be a member of a group."""
        self.group = group

    @property
    def _own_group(self) -> Group:
        if self.group is None:
            self.group = Group([self], (), self.settings, self.rests_in_events)
            self.group.goes_back = self.goes_back
        return self.group

    @property
    def _first(self) -> bool:
        return self._own_group.members[0] is self

    def address(self, function: str) -> int:
        """What belongs to the group is bound to it: the step, and the state of its first member."""
        if function == f"{self.prefix}DoStep":
            return self._own_group.bound.address("step" if self.fmu.version == 3 else "step2")
        if function in self.state_functions and self._first:
            return self._own_group.bound.address(BOUND[self.state_functions.index(function)])
        return super().address(function)

    def put(self, what: str, kind: str, references: Sequence[int], values: Sequence[Any]) -> None:
        if self.group is not None and self.group.begun and not self.dead and self.guarded:
            if kind not in REALS or not self._sampled.isdisjoint(references):
                self.group.enter_events()
            self.group.changed()
        super().put(what, kind, references, values)

    @cached_property
    def _sampled(self) -> frozenset[int]:
        """References of numbers that may be set in event mode only."""
        variables = self.fmu.own.description.modelVariables
        return frozenset(v.valueReference for v in variables if v.type in REALS and v.variability != "continuous")

    def exit_initialization(self) -> None:
        super().exit_initialization()
        if self.group is None and self.state is State.STEPPING:
            self.first_event()

    def reset(self) -> None:
        super().reset()
        if self.group is not None:
            self.group.free()
            self.group = None  # that of a new life

    def first_event(self) -> None:
        if self._first and not self.group_begun:
            self._own_group.begin(self.start_time)

    @property
    def group_begun(self) -> bool:
        """Whether its group has left initialization mode."""
        return self.group is not None and self.group.begun

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        super().set_up(stop, start)  # type: ignore[safe-super]
        self.start_time = start

    def step(self, time: float, length: float) -> None:
        self.require("step", f"step from t = {time:.9g} s")
        group = self._own_group
        if group.step(time, self.within(time, length)):
            self.noted("step", DISCARD)
            raise AskedToEndError(f"component {self.speaker.name} asked to end at {group.time:.9g} s", DISCARD)
        if group.failed:
            self.noted("step", ERROR)
            raise CallError(f"component {self.speaker.name}: {group.why()}{self.speaker.reasons()}", ERROR)

    def noted(self, action: str, status: int) -> None:
        """The group answers Error for all that ends it; what its member answered may be worse."""
        group = self.group
        if group is not None and group.failed and group.at_fault is self and group.answered == FATAL:
            status = FATAL
        super().noted(action, status)

    @property
    def speaker(self) -> Participant:
        group = self.group
        return group.at_fault if group is not None and (group.failed or group.asks_to_end) else self

    def solve_by(self, settings: Mapping[str, Any], goes_back: bool, rests_in_events: bool = False) -> None:
        self.settings, self.goes_back = SolverSettings(**settings), goes_back
        self.rests_in_events = rests_in_events

    def notes(self) -> list[str]:
        return self.group.notes() if self.group is not None else []

    def forgets(self) -> str:
        return self.group.forgets() if self.group is not None else ""

    def why_failed(self) -> str:
        return self.group.why() if self.group is not None and self.group.failed else ""

    @property
    def events(self) -> Any:
        if self.group is None or not self.group.ends_early or not self._first:
            return None
        from .events import GroupEvents

        return GroupEvents(self.group)

    def stopped(self) -> tuple[float, str] | None:
        group = self.group
        return (group.time, group.why_stopped()) if group is not None and group.pending else None

    def terminated(self) -> bool:
        return self.group is not None and self.group.asks_to_end

    def reached(self) -> float:
        return self.group.time if self.group is not None else -math.inf

    def save(self) -> int:
        self.require_state()
        if not self._first:
            return super().save()
        cell = np.zeros(1, dtype=np.int64)
        self.require("save", "save its state")
        status = call(self._own_group.bound.address("save"), self.pointer, int(cell.ctypes.data))
        if status > 1:
            raise CallError(f"component {self.name}: cannot save its state{self.reasons()}", status)
        self._note(int(cell[0]))
        return int(cell[0])

    def restore(self, state: int) -> None:
        if not self._first:
            super().restore(state)
            return
        self.require("restore", "restore its state")
        status = call(self._own_group.bound.address("restore"), self.pointer, state)
        if status > 1:
            raise CallError(f"component {self.name}: cannot restore its state{self.reasons()}", status)
        self._recall(state)

    def forget(self, state: int) -> None:
        if not self._first:
            super().forget(state)
            return
        cell = np.array([state], dtype=np.int64)
        call(self._own_group.bound.address("forget"), self.pointer, int(cell.ctypes.data))
        self._unnote(state)

    def serialize(self, state: int) -> bytes:
        if not self._first:
            return super().serialize(state)
        size = self._own_group.size_of_state()
        return ctypes.string_at(state + cells.CELL, size) + super().serialize(whole(state))

    def deserialize(self, content: bytes) -> int:
        if not self._first:
            return super().deserialize(content)
        size = self._own_group.size_of_state()
        if len(content) < size:
            raise ValueError("the state of the solver does not fit")
        state = call_whole(whole(self._own_group.pointer + cells.MALLOC), size + cells.CELL)
        put_whole(state, super().deserialize(content[size:]))
        ctypes.memmove(state + cells.CELL, content[:size], size)
        return state

    def close(self) -> str:
        if self.state is State.STEP_FAILED:
            self.state = State.STEPPING  # FMI knows no failed step here: it can be terminated
        said = super().close()
        if self.group is not None and self._first:
            self.group.free()
        return said


class Fmi2Member(Member, Fmi2Instance):
    """FMI 2.0."""

    kind = FMU2Model


class Fmi3Member(Member, Fmi3Instance):
    """FMI 3.0."""

    kind = FMU3Model

    def _create(self) -> Any:
        self._row = Row(id(self), self.log.logging == "all")
        logger = fmi3.fmi3LogMessageCallback(filtered(3, address_of(LOGGER)))
        self._callbacks = (logger,)  # alive as long as the FMU may call it
        folder = f"{self.fmu.folder / 'resources'}{os.sep}"
        return self.slave.fmi3InstantiateModelExchange(
            self.name.encode(), self.slave.guid.encode(), folder.encode(), False, self.asked_for_all, id(self), logger
        )


class Fmi1Member(Member, Fmi1Instance):
    """FMI 1.0, which has no modes: an event is an update between two steps."""

    kind = FMU1Model


MEMBERS: dict[int, type[Member]] = {1: Fmi1Member, 2: Fmi2Member, 3: Fmi3Member}
