"""How a session stands: whether it goes on, has failed, or was ended before its stop."""

from __future__ import annotations

from ...errors import RunError


class Standing:
    """What became of a run so far; `failure` says who, what and when."""

    def __init__(self) -> None:
        self.failure = ""
        self.ended = ""  # who asked to end the run before its stop, and when; that is no failure
        self.ended_badly = ""  # how components fell down while they were terminated and freed
        self.is_over = False  # a component, or who steps it, has ended it
        self.interrupted = False
        self.closed = False  # whether its FMUs are given back

    @property
    def over(self) -> bool:
        """Whether it goes no further: it has failed, or a component has ended it."""
        return bool(self.failure) or self.is_over

    @property
    def resumable(self) -> bool:
        """Whether the run can go on: nothing has failed; Ctrl-C is no failure of the run."""
        return not self.closed and not self.ended and (not self.failure or self.interrupted)

    def end_early(self, why: str) -> None:
        """End the run where it is, between two steps, as a component or somebody asks; that is no failure."""
        self.note_end(why)
        self.is_over = True

    def note_end(self, why: str) -> None:
        """Somebody has asked to end the run; it goes on to where it can."""
        self.ended = "\n".join(filter(None, [self.ended, why]))

    def _require_open(self) -> None:
        if self.closed:
            raise RunError("the session is closed; start another one")

    def _require_alive(self) -> None:
        self._require_open()
        if self.over:
            raise RunError(f"the session has ended: {self.failure or self.ended}")
