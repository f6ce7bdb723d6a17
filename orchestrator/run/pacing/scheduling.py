"""What the operating system is asked for while a run keeps pace: a place before others, and processors of its own.

Processes that are begun meanwhile get the usual scheduling. Threads beside the run give up Python's lock after
SWITCH_INTERVAL, for which a deadline may be late.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress

from ...errors import InputError
from .pace import Pace

SWITCH_INTERVAL = 2e-4  # s


@contextmanager
def scheduled(pace: Pace | None) -> Iterator[None]:
    """As long as the block lasts. Raises InputError where the system does not allow it."""
    with ExitStack() as stack:
        if pace:
            stack.callback(sys.setswitchinterval, sys.getswitchinterval())
            sys.setswitchinterval(SWITCH_INTERVAL)
        if pace and pace.cores:
            before = os.sched_getaffinity(0)
            try:
                os.sched_setaffinity(0, pace.cores)
            except (OSError, ValueError, OverflowError) as error:
                there = ", ".join(map(str, sorted(before)))
                wanted = ", ".join(map(str, pace.cores))
                raise InputError(f"the run cannot be held on processors {wanted} ({error}); it has {there}") from None
            stack.callback(_back, lambda: os.sched_setaffinity(0, before))
        if pace and pace.fifo:
            policy, parameter = os.sched_getscheduler(0), os.sched_getparam(0)
            try:
                os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(pace.fifo))
            except OSError as error:
                raise InputError(
                    f"SCHED_FIFO {pace.fifo} is not allowed here ({error.strerror}); it needs root, CAP_SYS_NICE, or a "
                    f"line rtprio in /etc/security/limits.conf"
                ) from None
            stack.callback(_back, lambda: os.sched_setscheduler(0, policy, parameter))
        yield


def _back(undo: object) -> None:
    with suppress(OSError):
        undo()  # type: ignore[operator]
