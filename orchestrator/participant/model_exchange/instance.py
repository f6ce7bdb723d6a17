"""Instances of FMUs for Model Exchange, FMI 2.0 and 3.0, in this process.

Between communication points they are in continuous-time mode. What may be set only in event mode (tunable parameters,
sampled inputs) puts the whole group there; its next step begins with the event.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from fmpy import fmi2, fmi3

from ...fmu.types import Value
from ..base import AskedToEndError, CallError
from ..here.fmi2 import Fmi2Instance
from ..here.fmi3 import LOGGER, Fmi3Instance
from ..here.library import Judged
from ..here.loaded import LoadedInstance
from ..here.message_filter import Row, address_of, filtered
from ..lifecycle import DISCARD, ERROR, State
from .group import Group


class FMU2Model(Judged, fmi2.FMU2Model):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class FMU3Model(Judged, fmi3.FMU3Model):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Member(LoadedInstance):
    """What both versions have in common. Whoever runs it alone needs no group: it makes one of itself."""

    group: Group | None = None  # of its system; made when it leaves initialization mode where there is none

    def set_own(self, values: Mapping[str, Value]) -> None:
        if self.group is not None and self.group.begun and not self.dead:
            variables = self.fmu.own.variables
            if any(variables[name].variability not in ("continuous", None) for name in values):
                self.group.enter_events()
            self.group.changed()
        super().set_own(values)

    def exit_initialization(self) -> None:
        super().exit_initialization()
        if self.group is None:
            self.group = Group([self])
            self.group.begin()

    def step(self, time: float, length: float) -> None:
        self.require("step", f"step from t = {time:.9g} s")
        assert self.group is not None
        ended = self.group.step(time, self.within(time, length))
        if ended:
            self.noted("step", DISCARD)
            raise AskedToEndError(f"component {self.name} asked to end at {self.group.time:.9g} s", DISCARD)
        if self.group.failed:
            self.noted("step", ERROR)
            raise CallError(f"component {self.name}: {self.group.why()}{self.reasons()}", ERROR)

    def terminated(self) -> bool:
        return False

    def save(self) -> int:
        state = super().save()
        if self.group is not None and self.group.alone:
            self.group.save(state)
        return state

    def restore(self, state: int) -> None:
        super().restore(state)
        if self.group is not None and self.group.alone:
            self.group.restore(state)

    def forget(self, state: int) -> None:
        super().forget(state)
        if self.group is not None and self.group.alone:
            self.group.forget(state)

    def close(self) -> str:
        if self.group is not None and self.state is State.STEP_FAILED:
            self.state = State.STEPPING  # FMI knows no failed step here: it can be terminated
        said = super().close()
        if self.group is not None:
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
