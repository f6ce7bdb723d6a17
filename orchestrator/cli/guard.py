"""The command line's work in a child process, so that an FMU that crashes there leaves a message and not just a code.

The child does everything and prints where this process would. Signals that come here are passed on: the child is in
a process group of its own, where the terminal's Ctrl-C does not reach it a second time.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, NoReturn

from .. import processes
from ..errors import FmuError
from ..files import typed

PASSED_ON = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP) if hasattr(signal, "SIGHUP") else ()
INSISTED = 3  # signals, how many until a child that does not listen is ended: an FMU may never return
ADVICE = (
    'isolation = "process" under [components.NAME] of the system file gives a component a process of its own; '
    "its crash is then reported by name, and what was computed is kept"
)


def guarded(work: Callable[[], NoReturn]) -> NoReturn:
    """Do `work`, which ends its process, in a child, and end with its exit code; with 1 and a message if it crashed.

    Where a system cannot fork, the work is done here.
    """
    if not hasattr(os, "fork"):
        work()
    sys.stdout.flush()
    sys.stderr.flush()
    parent = os.getpid()
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        os.setpgid(0, 0)
        processes.end_with(parent)
        processes.began_with(parent)
        try:
            work()
        except SystemExit as end:
            os.write(writer, b"!")  # an FMU that ends the process does not come by here
            processes.end_at_once(end.code if isinstance(end.code, int) else int(end.code is not None))
        finally:
            os.write(writer, b"!")
    os.close(writer)
    code, passed = _wait(child)
    if -code in passed:  # before there was anything that could be kept
        print(f"error: ended from outside ({signal.Signals(-code).name})", file=sys.stderr)
        code = 1
    elif code < 0 or not os.read(reader, 1):
        how = processes.how_ended(code)
        print(f"error: an FMU ended the run, or did not return: the process {how}; {ADVICE}", file=sys.stderr)
        code = 1
    processes.end_at_once(code)


def _wait(child: int) -> tuple[int, list[int]]:
    """The child's exit code, negative for a signal, and the signals that were passed on to it meanwhile."""
    passed: list[int] = []

    def pass_on(number: int, _frame: Any) -> None:
        passed.append(number)
        with suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL if len(passed) >= INSISTED else number)

    for number in PASSED_ON:
        if signal.getsignal(number) is not signal.SIG_IGN:  # nohup, background jobs
            signal.signal(number, pass_on)
    if hasattr(os, "waitid"):  # not on macOS; until the child is collected its number is nobody else's
        os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
        _ignore_the_rest()
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    _ignore_the_rest()
    return code, passed


def _ignore_the_rest() -> None:
    """One signal too many, behind the end of the child, does not change how the command ends."""
    for number in PASSED_ON:
        signal.signal(number, signal.SIG_IGN)


def sheltered(fmu: Path, work: Callable[..., Any], *arguments: object) -> Any:
    """What `work(*arguments)` returns or raises, in a process of its own: the FMU's crash there is an error here."""
    try:
        return processes.in_process(work, *arguments)
    except processes.EndedError as error:
        raise FmuError(
            f"{fmu.name} ended the run: the process {error}; `rovbrush check {typed(fmu)}` finds out in which call, "
            "and how its author can repeat that"
        ) from None
