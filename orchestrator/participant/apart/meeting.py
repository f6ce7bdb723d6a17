"""Uses of an FMU that are to meet in this process, as they do in many a host: to see what they share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_meeting: ContextVar[bool] = ContextVar("meeting", default=False)


def may_meet() -> bool:
    """Whether instances that are made now are not kept apart."""
    return _meeting.get()


@contextmanager
def meeting() -> Iterator[None]:
    """Instances that are made within are not kept apart."""
    before = _meeting.set(True)
    try:
        yield
    finally:
        _meeting.reset(before)
