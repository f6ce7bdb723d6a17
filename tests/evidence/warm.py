"""Commands that start at once: each is a fork of a process that has imported before what the command imports.

What a command does is the same as if it had been started by `subprocess`; it does not do its imports again, which take
most of a short run's time. One command at a time.
"""

from __future__ import annotations

import importlib
import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import IO

# Some are imported only where they are there.
IMPORTED = (
    "rovbrush.orchestrator.cli.run_system", "xarray", "h5netcdf.legacyapi", "pint", "fmpy.validation", "pydantic",
    "dask.array",
)  # fmt: skip


class Command:
    """A command under way: of `subprocess.Popen` what is needed here."""

    def __init__(self, pid: int, answer: IO[str], stdout: IO[str] | None) -> None:
        self.pid, self.stdout = pid, stdout
        self.returncode: int | None = None
        self._answer = answer

    def wait(self) -> int:
        """Its exit code, negative for a signal, once it has ended."""
        if self.returncode is None:
            self.returncode = int(self._answer.readline())
        return self.returncode

    def send_signal(self, number: int) -> None:
        if self.returncode is None:
            with suppress(ProcessLookupError):
                os.kill(self.pid, number)

    def kill(self) -> None:
        self.send_signal(signal.SIGKILL)


class Starter:
    """The process that has the imports behind it."""

    def __init__(self) -> None:
        ours, theirs = socket.socketpair()
        with theirs:
            command = [sys.executable, "-P", __file__, str(theirs.fileno())]
            self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, pass_fds=[theirs.fileno()])
        self.socket, self.answer = ours, ours.makefile("r")

    def start(
        self, code: str, arguments: list[str], stdout: IO[str] | None, stderr: IO[str], environment: Mapping[str, str]
    ) -> Command:
        """Python code with its arguments; without a file for its stdout that is read by `Command.stdout`."""
        reader, writer = (None, stdout.fileno()) if stdout else os.pipe()
        asked = json.dumps([code, arguments, dict(environment)]).encode()
        socket.send_fds(self.socket, [len(asked).to_bytes(4, "big")], [writer, stderr.fileno()])
        self.socket.sendall(asked)
        pid = int(self.answer.readline())
        if reader is not None:
            os.close(writer)
        return Command(pid, self.answer, None if reader is None else os.fdopen(reader, "r"))


@cache
def starter() -> Starter:
    """That of this process; it ends when this one does."""
    return Starter()


def _serve(asking: socket.socket) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the terminal's Ctrl-C is for who waits
    for name in IMPORTED:
        with suppress(ImportError):
            importlib.import_module(name)
    importlib.import_module("rovbrush.orchestrator.loop.machine.compiled").compiled_loop()
    while True:
        head, files, *_ = socket.recv_fds(asking, 4, 2)
        if not head:
            return
        size, asked = int.from_bytes(head, "big"), b""
        while len(asked) < size:
            asked += asking.recv(size - len(asked))
        child = os.fork()
        if child == 0:
            asking.close()
            return _become(files, *json.loads(asked))
        for file in files:
            os.close(file)
        asking.sendall(f"{child}\n".encode())
        asking.sendall(f"{os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])}\n".encode())


def _become(files: list[int], code: str, arguments: list[str], environment: dict[str, str]) -> None:
    for target, file in zip((1, 2), files, strict=True):
        os.dup2(file, target)
        os.close(file)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)  # which `nohup` has ignored, and that is inherited
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = ["-c", *arguments]
    exec(code, {"__name__": "__main__", "__file__": str(Path(__file__))})


if __name__ == "__main__":
    _serve(socket.socket(fileno=int(sys.argv[1])))
