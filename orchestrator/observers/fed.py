"""A sink, and the thread that feeds it from a bounded queue. Nobody waits for it; what does not fit is counted."""

from __future__ import annotations

import threading
import time
from collections import deque

from ..errors import RovbrushError, counted
from ..files import reason
from .layout import Layout, Rows
from .sink import Sink


class Fed:
    """One observer of a run, called `name`. `where`: where it can be seen; `failure`: why it has ended before the run;
    `sent`, `dropped`: rows."""

    def __init__(self, name: str, sink: Sink, layout: Layout) -> None:
        self.name, self.sink, self.layout = name, sink, layout
        self.sent = self.dropped = 0
        self.where = self.failure = ""
        self._waiting: deque[Rows] = deque()
        self._held = self._in_hand = 0
        self._ended = self._given_up = False
        self._change = threading.Condition()
        self._opened = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"observer {name}", daemon=True)
        self._thread.start()

    def await_opening(self, seconds: float) -> None:
        """Give it time [s] to be opened; that it is not is no error."""
        self._opened.wait(seconds)

    def give(self, rows: Rows) -> None:
        """Rows to send, if there is room for them."""
        size = rows.size
        with self._change:
            if self.failure or self._held + size > self.sink.room:
                self.dropped += len(rows.times)
                return
            self._waiting.append(rows)
            self._held += size
            self._change.notify()

    def finish(self) -> None:
        """No more rows come: what waits is sent, as long as anything moves."""
        with self._change:
            self._ended = True
            self._change.notify()
        seen, since = -1, time.monotonic()
        while self._thread.is_alive() and time.monotonic() - since < self.sink.patience:
            if seen != self.sent:
                seen, since = self.sent, time.monotonic()
            self._thread.join(0.05)
        with self._change:
            self._given_up = True
            left = sum(len(rows.times) for rows in self._waiting)
            self._waiting.clear()
        self.dropped += left
        if self._thread.is_alive() and not self.failure:
            self.failure = f"it has taken nothing for {self.sink.patience:g} s"

    def told(self) -> str:
        """What became of it, in a line."""
        rows = counted(self.sent, "row")
        lost = f", {self.dropped} dropped" if self.dropped else ""
        return f"observer {self.name}: {rows}{lost}{f'; {self.failure}' if self.failure else ''}"

    def _work(self) -> None:
        try:
            self.where = self.sink.open(self.layout)
            self._opened.set()
            while (rows := self._next()) is not None:
                self._in_hand = len(rows.times)
                lost = self.sink.write(rows)
                self._in_hand = 0
                self.sent += len(rows.times) - lost
                self.dropped += lost
        except Exception as error:
            self._fail(error)
        try:
            self.sink.close()
        except Exception as error:
            self._fail(error)
        self._opened.set()

    def _next(self) -> Rows | None:
        with self._change:
            while not self._waiting and not self._ended:
                self._change.wait()
            if not self._waiting or self._given_up:
                return None
            rows = self._waiting.popleft()
            self._held -= rows.size
            return rows

    def _fail(self, error: Exception) -> None:
        if isinstance(error, RovbrushError):
            why = str(error)
        else:
            why = reason(error) if isinstance(error, OSError) else f"{type(error).__name__}: {error}"
        with self._change:
            self.failure = self.failure or why
            self.dropped += self._in_hand + sum(len(rows.times) for rows in self._waiting)
            self._in_hand = 0
            self._waiting.clear()
