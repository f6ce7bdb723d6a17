"""A run with observers: they are opened before it goes on, see its rows as they come, and are told of at its end."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction

from ..clock import duration
from ..errors import InputError
from ..plan.plan import Plan
from ..run.recording.observers import NEVER, Piece
from ..run.session.session import Session
from .asked import sinks_of
from .fed import Fed
from .layout import Selection
from .sink import Sink

OPENING = 3.0  # s that observers have to open before the run goes on without waiting for them


@dataclass(frozen=True)
class Watching:
    """Observers that are asked for, their signals by patterns, and how often a row of each table is sent; "": each."""

    observers: tuple[str | Sink, ...] = ()
    signals: tuple[str, ...] = ("*",)
    every: str = ""

    def check(self, plan: Plan) -> None:
        """Raise InputError for what cannot be meant, before anything is begun."""
        if not self.observers:
            if self.every or self.signals not in ((), ("*",)):
                raise InputError("--observe-signals and --observe-every go with --observe; say who looks on")
            return
        sinks_of(self.observers)
        self.selection(plan)

    def selection(self, plan: Plan) -> Selection:
        return Selection(plan, self.signals or ("*",), self._every())

    def _every(self) -> Fraction | None:
        return duration(self.every, "--observe-every") if self.every else None


NOBODY = Watching()


class Watched:
    """An `Observer` of a session that feeds others; nothing that they do reaches the run."""

    def __init__(self, session: Session, feeds: Sequence[Fed], selection: Selection) -> None:
        self.session, self.feeds, self.selection = session, feeds, selection
        self.failure = ""

    def due(self, tick: int) -> int:
        return NEVER

    def see(self, piece: Piece) -> None:
        try:
            for rows in self.selection.rows(piece, self.session.memory.texts):
                for feed in self.feeds:
                    feed.give(rows)
        except Exception as error:  # a fault of ours is not to cost a run its rows
            self.failure = self.failure or f"observers: unexpected {type(error).__name__}: {error}"

    def last(self) -> None:
        """Rows that came with what ended the run."""
        if not self.session.plan.algorithm.repeats_rows and not self.session.closed:
            self.see(self.session.recorder.fresh(self.session.at.time, self.session.tick))


@contextmanager
def watched(session: Session, watching: Watching, tell: Callable[[str], None] = lambda _line: None) -> Iterator[None]:
    """Have observers look on while the session goes; what became of each is among the notes of its run.

    `tell` hears where they can be seen, and which could not begin. Raises InputError."""
    if not watching.observers:
        yield
        return
    selection = watching.selection(session.plan)
    layout = selection.layout()
    feeds = [Fed(name, sink, layout) for name, sink in sinks_of(watching.observers)]
    for feed in feeds:
        feed.await_opening(OPENING)
        if feed.failure:
            tell(f"warning: observer {feed.name}: {feed.failure}; the run goes on without it")
        elif feed.where:
            tell(f"observer {feed.name}: {feed.where}")
    seen = Watched(session, feeds, selection)
    session.observers.append(seen)
    before, interval = sys.getswitchinterval(), 0.0005
    sys.setswitchinterval(min(before, interval))  # who feeds an observer is not to hold up who makes the rows
    try:
        yield
    finally:
        sys.setswitchinterval(before)
        if seen in session.observers:
            session.observers.remove(seen)
        seen.last()
        for feed in feeds:
            feed.finish()
        told = [f"warning: {feed.told()}" if feed.failure else feed.told() for feed in feeds]
        session.participants.notes += [*told, *filter(None, [seen.failure])]
