"""The process under wine in which an FMU's library lives: started, asked, lost, ended."""

from __future__ import annotations

import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import suppress

from ...errors import FmuError
from ...fmu.files.windows import require_wine
from ...fmu.fmu import Fmu
from ...processes import CRASHES, end, how_ended, start
from ..isolated.child_process import ProcessLostError
from .build import server
from .memory import WHOLE, ServerMemory

STARTING = 120.0  # s for wine to start; the first time it makes its folder (10 s)
STARTS = 3  # of a process that has not come so far as to answer
CLOSING = 20.0  # s; wine takes its time to end a process where the machine is busy
LONGEST = 1 << 16  # bytes of what the FMU prints that are passed on at a time
LOOKS = 100  # at the answer before others may run; some 5 us
# times that others may run before it is slept for the answer: more where it came in time, fewer where it did not
LEAST, MOST = 8, 200
SHORTEST, NAP = 5e-4, 0.05  # s; sleeps before it is looked whether the process lives
QUIET = {"WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}  # no questions whether to install those two
# Codes of exceptions that end a process, by the signals that Linux would send.
EXCEPTIONS = {
    0xC0000005: ("an access violation", CRASHES["SIGSEGV"]), 0xC00000FD: ("a stack overflow", ""),
    0xC0000094: ("a division by zero", ""), 0xC000001D: ("an illegal instruction", ""),
    0x80000003: ("a breakpoint", ""), 0xC0000374: ("a corrupt heap", ""), 0xE06D7363: ("an uncaught C++ exception", ""),
}  # fmt: skip
SHARED = "/dev/shm"


class ServerProcess:
    """Starts it; the first request waits until it is there."""

    def __init__(self, fmu: Fmu) -> None:
        self.fmu = fmu
        program = server(fmu.windows)
        loader = require_wine(fmu.path, fmu.windows)
        file, self._path = tempfile.mkstemp(prefix="rovbrush_", dir=SHARED if os.path.isdir(SHARED) else None)
        os.truncate(file, WHOLE)
        self.memory = ServerMemory(file)
        self.memory.page.lowest = 1
        # Not this process's own: wine's services keep it for some seconds longer than anybody waits.
        self._said = tempfile.TemporaryFile("a+b")  # noqa: SIM115
        # wine's processes cannot be told to end with the master; the loader that becomes one can.
        ending = ["setpriv", "--pdeathsig", "KILL"] if shutil.which("setpriv") else []
        self._command = [*ending, loader, windows_path(str(program)), windows_path(self._path)]
        self._begin()
        self._starts_left = STARTS - 1
        self._number, self._patience = 0, MOST
        self._there = False

    def _begin(self) -> None:
        """Start the process, which answers what is asked in the memory."""
        reads, self._wakes = os.pipe()
        self._woken, writes = os.pipe()
        try:
            self.process = start(
                self._command, stdin=reads, stdout=writes, stderr=self._said, env=QUIET | os.environ,
                start_new_session=True,  # Ctrl-C is for the master
            )  # fmt: skip
        except OSError as error:
            loader = self._command[-3]
            raise FmuError(f"{self.fmu.path.name}: {loader} cannot be started ({error.strerror})") from error
        finally:
            os.close(reads)
            os.close(writes)
        os.set_blocking(self._woken, False)
        os.set_blocking(self._wakes, False)
        self._answers = select.poll()
        self._answers.register(self._woken, select.POLLIN)

    def ask(self, operation: int, limit: float) -> None:
        """Have a request in the memory done within `limit` [s]. Raises ProcessLostError; the process has ended then."""
        self._put(operation)
        if not self._there:  # however soon its first answer comes
            self._sleep(max(limit, STARTING))
            self._there = True
            with suppress(OSError):  # it has mapped it
                os.unlink(self._path)
        elif not self._answered_soon():
            self._sleep(limit)

    def _put(self, operation: int) -> None:
        """A request into the memory."""
        self.memory.page.operation = operation
        self._number = (self._number + 1) & 0xFFFFFFFF
        self.memory.numbers[0] = self._number
        if self.memory.numbers[2]:
            self._wake()

    def _answered_soon(self) -> bool:
        """Look for the answer, and let others run meanwhile; whether it came before it is worth to sleep."""
        numbers, number = self.memory.numbers, self._number
        for _ in range(LOOKS):
            if numbers[1] == number:
                return True
        for _ in range(self._patience):
            os.sched_yield()
            if numbers[1] == number:
                self._patience = min(2 * self._patience, MOST)
                return True
        self._patience = max(self._patience // 2, LEAST)
        return False

    def _sleep(self, limit: float) -> None:
        """Wait for the answer for so long [s]. Raises ProcessLostError."""
        numbers, number, last, nap = self.memory.numbers, self._number, time.monotonic() + limit, SHORTEST
        numbers[3] = 1
        try:
            while numbers[1] != number:
                left = last - time.monotonic()
                if left <= 0.0:
                    self.kill()
                    raise ProcessLostError(f"its process did not answer within {limit:g} s and was ended")
                nap = min(2.0 * nap, NAP)
                if self._answers.poll(1000.0 * min(left, nap)):
                    if not self._drained() and numbers[1] != number:
                        self._begun_again()
                elif self.process.poll() is not None and numbers[1] != number:
                    self._begun_again()
                if numbers[2]:  # it may have fallen asleep just before it could see the request
                    self._wake()
        finally:
            numbers[3] = 0

    def _drained(self) -> bool:
        """Take the bytes that woke us; whether the pipe is still open."""
        try:
            return bool(os.read(self._woken, 4096))
        except BlockingIOError:
            return True
        except OSError:
            return False

    def _wake(self) -> None:
        with suppress(OSError):  # full, or nobody is there: seen when it is waited for
            os.write(self._wakes, b"\0")

    def _begun_again(self) -> None:
        """Start the process once more where wine did not get so far: its service, which ends some seconds behind the
        last of its processes, may go just when another one comes. Raises ProcessLostError for all else."""
        lost = self._lost()
        if self._there or self.memory.page.crash or self.process.returncode != 1 or not self._starts_left:
            raise lost
        self._starts_left -= 1
        os.close(self._wakes)
        os.close(self._woken)
        self._begin()

    def _lost(self) -> ProcessLostError:
        try:
            code = self.process.wait(CLOSING)
        except subprocess.TimeoutExpired:
            self.kill()
            return ProcessLostError("its process closed the connection to the master and was ended")
        crash = self.memory.page.crash
        if crash:
            what, means = EXCEPTIONS.get(crash, ("an exception", ""))
            return ProcessLostError(f"its process crashed with {what} (0x{crash:08X}){means}")
        fault = f"its process {how_ended(code)}"
        return ProcessLostError(fault if self._there else f"{fault} before it was ready ({self._ready_fault()})")

    def _ready_fault(self) -> str:
        return (
            "wine could not run it: its folder, $WINEPREFIX or ~/.wine, must be of a wine that runs "
            f"{self.fmu.windows}, with drive Z: for /"
        )

    def pass_on(self) -> None:
        """Print what the FMU has printed since."""
        self._said.seek(max(0, self._said.seek(0, os.SEEK_END) - LONGEST))
        if said := self._said.read():
            self._said.truncate(0)
            print(said.decode("utf-8", "replace").replace("\r\n", "\n"), end="", file=sys.stderr, flush=True)

    def kill(self) -> None:
        """End it at once."""
        self.process.kill()
        self.process.wait()

    def close(self) -> None:
        """End it: it goes when its pipe closes, and is made to if it does not."""
        if not self.memory.base:
            return
        os.close(self._wakes)
        if not self._there:
            self.process.kill()
        end(self.process, CLOSING)
        os.close(self._woken)
        with suppress(OSError):
            os.unlink(self._path)
        with suppress(OSError, ValueError):  # nobody is there
            self.pass_on()
        self._said.close()
        self.memory.numbers.release()
        self.memory.close()


def windows_path(path: str) -> str:
    """A path as wine's programs know it: its drive Z: is the root."""
    return "Z:" + path.replace("/", "\\")
