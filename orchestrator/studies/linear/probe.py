"""A run that can be disturbed and taken back: what pulse responses are made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from types import TracebackType

import numpy as np

from ...errors import InputError, RunError, listed
from ...loop.cells import ABSENT, CHANGED, GAIN, MODE, OFFSET_OR_VALUE, SIGMA
from ...plan.instants import direct_answers
from ...plan.plan import make_plan
from ...run.start.settle import settle
from ...run.stepping.snapshot import Snapshot
from ...run.stepping.stepping import Stepping
from ...system.model import System
from .channels import Channel, with_disturbances


class Probe:
    """A session of a system at whose channels something can be added from a sample to the next one.

    A sample is `every` hyperperiods. What is added acts from the instant of a sample on, outputs that answer at once
    included, until it is taken away or changed at another one. Use it in a `with` block.
    """

    def __init__(self, system: System, channels: Sequence[Channel], signals: Sequence[str], every: int = 1) -> None:
        self.channels, self.signals, self.every = list(channels), list(signals), every
        disturbed, numbers = with_disturbances(system, self.channels)
        names = tuple(dict.fromkeys([*self.signals, *(channel.target for channel in self.channels)]))
        self.plan = make_plan(replace(disturbed, record=names))
        self.faults = {key: self.plan.layout.faults[number, key] for key, number in numbers.items()}
        self.session = Stepping(self.plan)
        held = {c.target for c in self.plan.instants.held}
        self.at_once = {
            channel.name: channel.key in held
            if channel.connection is not None
            else any(channel.key[1] in i for i in direct_answers(self.plan.system, channel.key[0]).values())
            for channel in self.channels
        }
        self.base: dict[str, float] = {}
        self.of_instants = False  # whether inputs are read as they are at an instant, not as they were over the step

    def __enter__(self) -> Probe:
        self.session.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.session.__exit__(kind, error, trace)

    @property
    def dt(self) -> float:
        """A sample [s]."""
        return self.every * self.session.period

    def keep(self) -> Snapshot:
        """The state of all at this instant, to be gone back to as often as wanted."""
        self.base = {c.name: float(self.session.get(c.target)) for c in self.channels if c.connection is None}
        return self.session.snapshot()

    def back(self, kept: Snapshot) -> None:
        """To a kept state, nothing added."""
        self.session.restore(kept)
        for channel in self.channels:
            if channel.connection is None:
                self.session.set(channel.target, self.base[channel.name])

    def add(self, channel: Channel, value: float) -> None:
        """Add so much to a channel, from this instant on, and let what answers at once answer; 0 takes it away."""
        if channel.connection is None:
            self.session.set(channel.target, self.base[channel.name] + value)
        else:
            self.bend(channel, 1.0, value)
        self.answer(channel)

    def answers(self, channel: Channel) -> str | None:
        """Which component answers at once to a channel, "" for all that follow; None where none does."""
        if not self.at_once[channel.name]:
            return None
        return channel.key[0] if channel.connection is None else ""

    def answer(self, channel: Channel) -> None:
        """Let what answers at once to a channel do so."""
        component = self.answers(channel)
        if component is not None:
            settle(self.plan, self.session.instances, self.session.memory, component)

    def bend(self, channel: Channel, gain: float, offset: float) -> None:
        """Let a connection send `gain` times what it would, and `offset`, in the unit of its input."""
        first, z = self.faults[channel.key], self.session.memory.z
        z[first + GAIN], z[first + OFFSET_OR_VALUE], z[first + SIGMA] = gain, offset, 0.0
        z[first + MODE] = ABSENT if (gain, offset) == (1.0, 0.0) else CHANGED

    def require_alive(self) -> None:
        """Raise RunError where the run has ended."""
        if self.session.over:
            raise RunError(f"the run ends before that: {self.session.failure or self.session.ended}")

    def sample(self) -> None:
        """Go on to the next instant of a sample. Raises RunError."""
        for _ in range(self.every):
            self.session.step()

    def read(self) -> np.ndarray:
        """The signals now, (p,)."""
        return np.array([self._value(name) for name in self.signals], dtype=float)

    def _value(self, name: str) -> float:
        if self.of_instants:  # the cell of an input has what it was over the step, its FMU what it is now
            owner, _, variable = name.partition(".")
            return float(self.session.instances[owner].get(variable))
        return float(self.session.get(name))


def require_states(system: System) -> None:
    """Raise InputError, naming them, where FMUs cannot save their states."""
    unable = [(name, c.fmu.path.name) for name, c in system.components.items() if not c.fmu.can_save_state]
    if unable:
        named = listed(f"{name} ({file})" for name, file in unable)
        raise InputError(
            f"pulse responses start from saved states, and {named} cannot save "
            f"{'its' if len(unable) == 1 else 'their'} state (canGetAndSetFMUstate = false); take an FMU in its place "
            "that can, or leave it out of the system"
        )
