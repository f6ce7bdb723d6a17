"""Work on a foreign FMU in a process of its own: its crash is an error message, not the end of the command."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from .errors import FmuError


def sheltered(fmu: Path, work: Callable[..., Any], *arguments: object) -> Any:
    """What `work(*arguments)` returns or raises. It prints where this process does.

    Raises FmuError if the process that did it was ended, by a crash or by an exit inside the FMU.
    """
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_work, args=(sender, work, arguments))
    sys.stdout.flush()
    child.start()
    sender.close()
    try:
        outcome = receiver.recv()
    except EOFError:
        child.join()
        raise FmuError(
            f"{fmu.name} ended the process that ran it ({_how(child.exitcode or 0)}); `rovbrush check {fmu}` finds out "
            "in which call; its author can find out why, in a debugger"
        ) from None
    finally:
        child.kill()  # it has nothing left to do, or was interrupted
        child.join()
    if isinstance(outcome, BaseException):
        raise outcome
    return outcome


def _work(sender: Connection, work: Callable[..., Any], arguments: tuple[object, ...]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that waits for this one takes care of it
    try:
        try:
            outcome = work(*arguments)
        finally:
            sys.stdout.flush()
    except (Exception, SystemExit) as error:  # rich ends with SystemExit where nobody reads its output any more
        outcome = error
    sender.send(outcome)
    os._exit(0)  # the libraries of some FMUs crash when they are taken down


def _how(code: int) -> str:
    return f"by {signal.Signals(-code).name}" if code < 0 else f"with exit code {code if code < 256 else hex(code)}"
