"""What an FMU has to say: the last messages for errors, the first ones for the file beside the rows."""

from __future__ import annotations

from collections import deque
from typing import Literal, NamedTuple

from .lifecycle import OK, STATUS

Logging = Literal["warnings", "all"]  # what an FMU is asked to log
MOST = {"warnings": 1000, "all": 100_000}  # messages of one FMU that are kept
RECENT = 50


class Message(NamedTuple):
    """A message with the status and the category that the FMU gives it."""

    status: int
    category: str
    text: str

    def line(self, name: str) -> str:
        """As a line of a file; those that follow in the same message are indented."""
        category = f" [{self.category}]" if self.category else ""
        text = self.text.replace("\n", "\n    ")
        return f"{name}: {STATUS.get(self.status, self.status)}{category}: {text}"


class Messages:
    """Those of one instance."""

    def __init__(self, logging: Logging = "all") -> None:
        self.logging = logging
        self.recent: deque[str] = deque(maxlen=RECENT)  # an FMU may warn at every step
        self.kept: list[Message] = []
        self.left_out = 0  # that came when enough were kept

    def add(self, status: int, category: str, text: str) -> None:
        """One more; what is neither a warning nor worse counts only where all is asked for."""
        if not text or (status == OK and self.logging != "all"):
            return
        self.recent.append(text)
        if len(self.kept) < MOST[self.logging]:
            self.kept.append(Message(status, category, text))
        else:
            self.left_out += 1

    def lines(self, name: str, unread: int = 0) -> list[str]:
        """All that is kept, and how many more there were; `unread`: those that nobody looked at."""
        more = self.left_out + unread
        tail = [f"{name}: {more} more message{'s' * (more != 1)}, not kept"] if more else []
        return [*(message.line(name) for message in self.kept), *tail]

    def text(self) -> str:
        """The last messages, as the tail of an error message."""
        return "".join(f"\n{message}" for message in dict.fromkeys(self.recent))

    def advice(self, name: str) -> str:
        """What may bring an FMU to talk that gave no reason; empty where it gave one, or was asked for all."""
        if self.recent or self.logging == "all":
            return ""
        return f'; it gave no reason: run again with logging = "all" under [components.{name}] to see all that it logs'
