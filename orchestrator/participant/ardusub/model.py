"""The autopilot as a participant: told the state at the beginning of a step, its answer in force from then on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...ardupilot.interface import Options, inputs_of, outputs_of, rate_of_step, state_of, values_of
from ...ardupilot.packet import ServoPacket
from ...ardupilot.state_line import NotFiniteError, state_line
from ...errors import RunError
from ...fmu.outside.model import Model
from .link import Link


class AutopilotModel(Model):
    """One autopilot at a UDP port, from the first frame before time 0 to the end of the run."""

    def __init__(self, starts: Mapping[str, Any], options: Options) -> None:
        super().__init__(starts)
        self.options = options
        self._inputs = [name for signal in inputs_of(options) for name in signal.scalars]
        self._outputs = [name for signal in outputs_of(options) for name in signal.scalars]
        self._link: Link | None = None
        self._start = 0.0  # s, where the run began: the autopilot's time is 0
        self._said: list[str] = []

    def set_up(self, start: float, stop: float | None) -> None:
        o, self._start = self.options, start
        self._link = Link(o.rate, o.port, o.host, o.peer, o.timeout)

    @property
    def link(self) -> Link:
        """The socket; there is one from `set_up` on."""
        assert self._link is not None
        return self._link

    def initialized(self) -> None:
        """Wait for the first frame: what its servos say holds at time 0."""
        self._take(self.link.begin())

    def step(self, time: float, length: float) -> None:
        """Tell the state at `time` and take the next frame. Raises RunError where none comes, or at another rate."""
        self.link.frames.rate = rate_of_step(length)
        try:
            line = state_line(state_of(time - self._start, [self.values[name] for name in self._inputs], self.options))
        except NotFiniteError as error:
            raise RunError(f"{error}, which cannot be told to the autopilot") from None
        try:
            self._take(self.link.exchange(line))
        except KeyboardInterrupt:  # the second one: the first waits for the end of this step
            raise RunError("interrupted while it waited for the autopilot") from None

    def _take(self, packet: ServoPacket) -> None:
        self.values.update(zip(self._outputs, values_of(packet, self.options), strict=True))

    def notes(self) -> list[str]:
        """What came, and how long the answers took."""
        if self._link is not None and self.link.frames.counts.frames:
            self._said = [f"autopilot at UDP {self.link.host}:{self.link.port}: {self.link.text()}"]
        return self._said

    def close(self) -> None:
        """Give the port back."""
        if self._link is not None:
            self.link.close()
