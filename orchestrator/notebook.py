"""What a run shows in a notebook while it goes: a bar, by IPython's own means and no widgets."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

from .markup import element, safe

LONG = 0.5  # s of wall time, until a bar appears
INTERVAL = 0.2  # s between two looks of it
Report = Callable[[float], None]


def in_notebook() -> bool:
    """Whether this is a kernel whose front end shows HTML; IPython is not imported for that."""
    shell = sys.modules.get("IPython")
    if shell is None:
        return False
    return type(shell.get_ipython()).__name__ == "ZMQInteractiveShell"


@contextmanager
def bar_unless(given: Report | bool | None, what: str, begin: float, end: float) -> Iterator[Report | None]:
    """The callback that is `given`; of True a bar in a notebook, which goes when the run ends; otherwise None."""
    if given is not True:
        yield given or None
        return
    if not in_notebook():
        yield None
        return
    bar = Bar(what, begin, end)
    try:
        yield bar.report
    finally:
        bar.clear()


class Bar:
    """A bar from `begin` to `end` [s]; nothing is shown of a run that is short."""

    def __init__(self, what: str, begin: float, end: float) -> None:
        self.what, self.begin, self.end = what, begin, end
        self.started = self.shown = time.monotonic()
        self.handle: Any = None

    def report(self, reached: float) -> None:
        """The time that is reached [s]."""
        now = time.monotonic()
        if now - self.started < LONG or now - self.shown < INTERVAL:
            return
        self.shown = now
        content = self.html(reached, now - self.started)
        if self.handle is None:
            display = import_module("IPython.display").display  # the kernel's own
            self.handle = display({"text/html": content, "text/plain": ""}, raw=True, display_id=True)
        else:
            self.handle.update({"text/html": content, "text/plain": ""}, raw=True)

    def html(self, reached: float, took: float) -> str:
        """The bar, and for how long it will go on."""
        done = min(1.0, max(0.0, (reached - self.begin) / (self.end - self.begin)))
        left = f", {took * (1.0 - done) / done:.0f} s left" if done > 0.0 else ""
        bar = element("progress", value=f"{done:.4f}", max="1", style="width:16em;vertical-align:middle")
        return element("div", [safe(self.what), " ", bar, safe(f" {reached:.4g} of {self.end:g} s{left}")])

    def clear(self) -> None:
        """Take it away: the result says what there was."""
        if self.handle is not None:
            self.handle.update({"text/html": "", "text/plain": ""}, raw=True)
