"""Processes: what this one has used so far; others started, watched and ended, and in words how they ended."""

from __future__ import annotations

import atexit
import ctypes
import os
import queue
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from .errors import RovbrushError

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

_IMPORTED = time.time()
_first: int | str = "self"  # the process whose start counts
PR_SET_PDEATHSIG = 1  # <sys/prctl.h>
CRASHES = {
    "SIGSEGV": " (it reached for memory that is not its own)", "SIGBUS": " (it reached for memory that is not there)",
    "SIGABRT": " (it gave up)", "SIGILL": "", "SIGFPE": "", "SIGTRAP": "", "SIGSYS": "",
}  # fmt: skip


class EndedError(RovbrushError):
    """A process ended before it had answered; the text says how."""


# --- this process ---


def began_with(pid: int) -> None:
    """Count time from the start of another process, which made this one."""
    global _first
    _first = pid


def seconds_since_start() -> float:
    """Wall time since the process, or the one that made it, began [s].

    Where the system does not tell: since this module was imported.
    """
    stat, uptime = Path(f"/proc/{_first}/stat"), Path("/proc/uptime")
    if stat.is_file() and uptime.is_file():
        started = float(stat.read_text().rsplit(")", 1)[1].split()[19]) / os.sysconf("SC_CLK_TCK")
        return float(uptime.read_text().split()[0]) - started
    return time.time() - _IMPORTED


def peak_memory() -> float:
    """Largest resident size so far [MB]; 0 where the system does not tell. (psutil knows it on Windows only.)"""
    status = Path("/proc/self/status")
    found = re.search(r"VmHWM:\s*(\d+) kB", status.read_text()) if status.is_file() else None
    if found:  # `ru_maxrss` below can be that of the process which started this one
        return int(found[1]) * 1024 / 1e6
    try:
        import resource
    except ImportError:
        return 0.0
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)


def end_at_once(code: int) -> NoReturn:
    """End this process without taking its modules to pieces, which takes Python up to a second.

    All else is done that Python does at its end: threads are waited for, exit handlers called, streams flushed, those
    of C as well.
    """
    threading._shutdown()  # type: ignore[attr-defined]
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):  # who prints has said so before
            stream.flush()
    if os.name == "posix":
        ctypes.CDLL(None).fflush(None)
    os._exit(code)


# --- other processes ---


def how_ended(code: int) -> str:
    """How a process ended, by its exit code (negative for a signal), as words to go behind "its process"."""
    if code >= 0:
        return f"ended by itself with exit code {code if code < 256 else hex(code)}"
    name = signal.Signals(-code).name if -code in set(signal.Signals) else f"signal {-code}"
    if name in CRASHES:
        return f"crashed with {name}{CRASHES[name]}"
    return f"was ended by {name}{' (by somebody, or by the system for want of memory)' if name == 'SIGKILL' else ''}"


class _Keeper:
    """A thread that starts processes and lives as long as this one does.

    Linux ties `PR_SET_PDEATHSIG` to the thread that forked: a process that was started by a thread of a pool would be
    killed when that thread goes.
    """

    def __init__(self) -> None:
        self.pid = os.getpid()  # of a fork's two sides one has no such thread
        self.asked: queue.SimpleQueue[tuple[Callable[[], Any], queue.SimpleQueue[Any]]] = queue.SimpleQueue()
        threading.Thread(target=self._work, name="starts processes", daemon=True).start()

    def _work(self) -> None:
        while True:
            job, answer = self.asked.get()
            try:
                answer.put(job())
            except BaseException as error:
                answer.put(error)

    def do(self, job: Callable[[], Any]) -> Any:
        answer: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self.asked.put((job, answer))
        outcome = answer.get()
        if isinstance(outcome, BaseException):
            raise outcome
        return outcome


_keeper: _Keeper | None = None


def start(command: list[str], **options: Any) -> subprocess.Popen[bytes]:
    """Start a process that may call `end_with`; options of Popen. Raises OSError."""
    global _keeper
    if _keeper is None or _keeper.pid != os.getpid():
        _keeper = _Keeper()
    process: subprocess.Popen[bytes] = _keeper.do(lambda: subprocess.Popen(command, **options))
    return process


def end_with(master: int) -> None:
    """Let this process end when its master, which started it by `start` or by a fork, ends, whatever it does then."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != master:
        os._exit(1)


def watch(master: int) -> None:
    """The same for systems without that signal: look every second, in a thread."""

    def look() -> None:
        while os.getppid() == master:
            time.sleep(1.0)
        os._exit(1)

    threading.Thread(target=look, name="watches the master", daemon=True).start()


def end(process: subprocess.Popen[Any], patience: float) -> int:
    """Wait so long [s] for a process that was told to end, then kill it; its exit code."""
    try:
        return process.wait(patience)
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait()


def fault_of(command: list[str], patience: float) -> str:
    """Run a command without input or output, for so long [s]; how it ended if not with 0, behind "the process"."""
    try:
        code = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=patience, check=False
        ).returncode
    except subprocess.TimeoutExpired:
        return f"did not come back within {patience:g} s"
    return how_ended(code) if code else ""


def in_process(work: Callable[..., Any], *arguments: object) -> Any:
    """What `work(*arguments)` returns or raises in a process of its own, which prints where this one does.

    Raises EndedError if that process ended before, by a crash or by an exit in foreign code.
    """
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_answer, args=(sender, work, arguments))
    sys.stdout.flush()
    child.start()
    sender.close()
    try:
        outcome = receiver.recv()
    except EOFError:
        child.join()
        raise EndedError(how_ended(child.exitcode or 0)) from None
    finally:
        child.kill()  # it has nothing left to do, or was interrupted
        child.join()
    if isinstance(outcome, BaseException):
        raise outcome
    return outcome


def _answer(sender: Connection, work: Callable[..., Any], arguments: tuple[object, ...]) -> NoReturn:
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
