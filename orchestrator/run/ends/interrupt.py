"""Signals that end a run in good order: Ctrl-C, and for the command line SIGTERM and SIGHUP."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import Any

import numpy as np

from ...loop import cells
from ...waiting import none_came, signal_came

ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
REASONS = {
    "SIGINT": "interrupted by the user",
    "SIGTERM": "ended from outside (SIGTERM)",
    "SIGHUP": "ended because its terminal was closed (SIGHUP)",
}


class StopRequests:
    """Lets signals stop the loop at the next instant instead of ending the process or raising inside an FMU's code.

    `control` is that of the loop, see `loop/run`. A second signal insists: it raises KeyboardInterrupt, as does the
    first where an FMU waits for somebody outside (`waiting`). What was
    ignored when the process began (nohup, a background job) stays ignored. A program that is not ours keeps all
    signals but Ctrl-C.
    """

    def __init__(self, signals: Sequence[signal.Signals] = (signal.SIGINT,)) -> None:
        self.signals = signals
        self.control = np.zeros(cells.CONTROL_CELLS, dtype=np.int64)
        self.control[[cells.ENDS_AT, cells.EVENT_AT]] = cells.NEVER
        self.came: int = signal.SIGINT
        self._listening = False

    def make_room(self, size: int) -> None:
        """Give the loop more cells, before it begins."""
        more = np.zeros(max(size - len(self.control), 0), dtype=np.int64)
        self.control = np.concatenate([self.control, more])

    @property
    def reason(self) -> str:
        """Why the run was stopped, in words."""
        return REASONS[signal.Signals(self.came).name]

    @property
    def asked(self) -> bool:
        """Whether a signal came that nobody has acted upon."""
        return bool(self.control[cells.STOP_REQUEST])

    def insist(self) -> None:
        """From now on the first signal raises KeyboardInterrupt."""
        self.control[cells.STOP_REQUEST] = 1

    @contextmanager
    def heard(self) -> Iterator[None]:
        """As long as the block lasts; blocks may be nested."""
        if self._listening or threading.current_thread() is not threading.main_thread():
            yield
            return
        before = {n: signal.getsignal(n) for n in self.signals if signal.getsignal(n) is not signal.SIG_IGN}
        self._listening = True
        none_came()
        try:
            for number in before:
                signal.signal(number, self._request)
            yield
        finally:
            self._listening = False
            none_came()
            for number, handler in before.items():
                with suppress(TypeError, ValueError):
                    signal.signal(number, handler)

    def _request(self, number: int, _frame: Any) -> None:
        if self.control[cells.STOP_REQUEST]:
            raise KeyboardInterrupt
        self.came = number
        self.control[cells.STOP_REQUEST] = 1
        signal_came()
