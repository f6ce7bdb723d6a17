"""The page's server, in a process of its own: started, met, and started again if it dies. The run waits for nothing."""

from __future__ import annotations

import subprocess
import sys
import time
from contextlib import suppress
from typing import Self

import msgspec

from ..errors import InputError, RunError
from ..sockets import SHORTEST_TOKEN, listening
from .wire import Meeting, Wire

STARTS = 5  # of a server that dies, in one run
APART = 2.0  # s between two of them
PATIENCE = 60.0  # s until the first one can be reached


class Settings(msgspec.Struct, frozen=True):
    """What the server is told: where the run is and the word for it, where the page is to be, and the token."""

    meeting: int
    word: str
    host: str
    port: int
    token: str = ""


def checked_place(host: str, port: int, token: str) -> int:
    """The port that the page gets; a free one for 0. Raises InputError."""
    if token and (len(token) < SHORTEST_TOKEN or not token.isascii() or not token.isalnum()):
        raise InputError(f"--token needs at least {SHORTEST_TOKEN} letters and digits, and no others")
    with listening(host, port, token, "by --token WORD") as probe:
        return int(probe.getsockname()[1])


class PageServer:
    """`url`: where the page is. Errors as of `checked_place`."""

    def __init__(self, host: str = "127.0.0.1", port: int = 8080, token: str = "") -> None:
        self.host, self.token = host, token
        self.port = checked_place(host, port, token)
        self._meeting = Meeting()
        self._wire: Wire | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._starts, self._started = 0, 0.0
        self.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def url(self) -> str:
        name = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host
        end = f"?token={self.token}" if self.token else ""
        return f"http://{f'[{name}]' if ':' in name else name}:{self.port}/{end}"

    def start(self) -> None:
        """Start it, or again."""
        self._starts, self._started = self._starts + 1, time.monotonic()
        self._process = subprocess.Popen(
            [sys.executable, "-m", f"{__package__}.page"], stdin=subprocess.PIPE, stdout=sys.stderr.fileno(),
            start_new_session=True,
        )  # fmt: skip
        settings = Settings(self._meeting.port, self._meeting.word, self.host, self.port, self.token)
        assert self._process.stdin is not None
        with suppress(OSError):  # it is gone already
            self._process.stdin.write(msgspec.json.encode(settings) + b"\n")
            self._process.stdin.flush()  # and left open: its end tells the server that the run is gone

    def wait(self) -> None:
        """Until the page can be opened. Raises RunError where that does not come to pass."""
        until = time.monotonic() + PATIENCE
        while self.wire() is None:
            if self._process is None or self._process.poll() is not None or time.monotonic() > until:
                raise RunError(f"the page's server did not start at {self.host}, port {self.port}")
            time.sleep(0.02)

    def wire(self) -> Wire | None:
        """The way to the server, if it is there now; one that has died is started again, a few times."""
        if self._wire is not None and self._wire.closed:
            self._wire = None
        if self._wire is None:
            self._wire = self._meeting.met()
        died = self._wire is None and self._process is not None and self._process.poll() is not None
        if died and self._starts < STARTS and time.monotonic() - self._started > APART:
            self.start()
        return self._wire

    @property
    def gone(self) -> bool:
        """Whether it has died for good."""
        return self._process is None or (self._process.poll() is not None and self._starts >= STARTS)

    def close(self) -> None:
        """End it."""
        if self._wire is not None:
            self._wire.close()
        self._meeting.close()
        if self._process is None:
            return
        with suppress(OSError):
            assert self._process.stdin is not None
            self._process.stdin.close()
        try:
            self._process.wait(3.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process = None
