"""A process that tries cases of one claim: what a case does to it (a crash, a hang) is an outcome, not an accident."""

from __future__ import annotations

import multiprocessing
import os
import shutil
import signal
import sys
import tempfile
import time
import traceback
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

from .claims import Claim, load

PREPARATION = 600.0  # s, for `prepare`: FMUs are built there
KEPT = 2000  # characters of what is wrong


class Worker:
    """Parent's end. `begin` a case, wait on `pipe`, then ask for its `outcome`; begins anew after a crash."""

    def __init__(self, claim: Claim, scratch: Path) -> None:
        self.claim, self.scratch = claim, scratch
        self.index: int | None = None
        self._start()

    def _start(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix=f"{self.claim.name}_", dir=self.scratch))
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_work, args=(self.claim.path, self.folder, theirs))
        self.process.start()
        theirs.close()
        self.prepared = False
        self.since = time.monotonic()

    def begin(self, index: int) -> None:
        self.index = index
        with suppress(OSError):  # a worker that is gone is found by `outcome`
            self.pipe.send(index)

    @property
    def late(self) -> bool:
        return time.monotonic() - self.since > (self.claim.limit if self.prepared else PREPARATION)

    def outcome(self) -> tuple[float, str] | tuple[float, str, str] | None:
        """Seconds, what is wrong ("": nothing) and what was printed, or None while the case goes on."""
        seconds = time.monotonic() - self.since
        try:
            if self.pipe.poll():
                message = self.pipe.recv()
                if message == "prepared":
                    self.prepared, self.since = True, time.monotonic()
                    return None
                self.since = time.monotonic()
                return message  # type: ignore[no-any-return]
        except (EOFError, OSError):
            self.process.join(5.0)
            code = self.process.exitcode
            how = signal.Signals(-code).name if code is not None and code < 0 else f"exit code {code}"
            said = _tail(self.folder / "said")
            self.restart()
            return seconds, f"the process ended: {how}. {said}".strip()
        if self.late:
            doing = "case" if self.prepared else "preparation"
            self.restart()
            return seconds, f"the {doing} took longer than {self.claim.limit if doing == 'case' else PREPARATION:g} s"
        return None

    def restart(self) -> None:
        self.end()
        self._start()

    def end(self) -> None:
        """The process, all that it started, and its files are gone after this."""
        with suppress(OSError):
            if os.getpgid(self.process.pid or 0) == self.process.pid:
                os.killpg(self.process.pid, signal.SIGKILL)
        self.process.kill()
        self.process.join()
        self.pipe.close()
        shutil.rmtree(self.folder, ignore_errors=True)


def _work(path: Path, folder: Path, pipe: Connection) -> None:
    os.setsid()  # a case's own children end with it
    signal.signal(signal.SIGINT, signal.default_int_handler)
    said = os.open(folder / "said", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    os.dup2(said, 1)
    os.dup2(said, 2)
    claim = load(path)
    if claim.prepare is not None:
        claim.prepare(folder)
    pipe.send("prepared")
    while True:
        try:
            index = pipe.recv()
        except EOFError:
            return
        os.ftruncate(said, 0)
        case = folder / f"case{index}"
        case.mkdir()
        before = time.monotonic()
        try:
            wrong = claim.one(index, case)
        except BaseException:
            wrong = traceback.format_exc()
        seconds = time.monotonic() - before
        shutil.rmtree(case, ignore_errors=True)
        sys.stdout.flush()
        pipe.send((seconds, wrong[-KEPT:], _tail(folder / "said").strip() if claim.says else ""))


def _tail(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")[-KEPT:] if path.is_file() else ""
