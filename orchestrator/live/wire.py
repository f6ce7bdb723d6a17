"""Small messages between the run and the page's server, by a socket that never makes the run wait.

A message is its length in four bytes and itself. What the other side does not take is kept up to a limit, and beyond it
dropped and counted: each message says how much may wait before it.
"""

from __future__ import annotations

import hmac
import secrets
import select
import socket
import time
from contextlib import suppress

HEAD = 4  # bytes of a length
LARGEST = 1 << 20  # bytes of a message that comes in
WAITING = 1 << 18  # bytes that may wait before rows are dropped
ALL = 64 << 20  # and before anything is
GREETING = 5.0  # s that a peer has to say who it is
GUESTS = 4  # at once, who have not


class Wire:
    """One end, that of the run. `dropped`: messages that were not taken; `closed`: nobody is there any more."""

    def __init__(self, end: socket.socket) -> None:
        end.setblocking(False)
        self._end, self._out, self._in = end, bytearray(), bytearray()
        self.dropped, self.closed = 0, False
        self._deaf = False  # the other side takes nothing any more; what it has sent can still be read

    def post(self, message: bytes, waiting: int = ALL) -> bool:
        """Send a message, or keep it until it can be; whether it was not dropped."""
        if self.closed or self._deaf or len(self._out) > waiting:
            self.dropped += 1
            return False
        self._out += len(message).to_bytes(HEAD, "little") + message
        self.push()
        return True

    def push(self) -> None:
        """Send what can be sent at once."""
        try:
            while self._out:
                del self._out[: self._end.send(self._out[: 1 << 16])]
        except BlockingIOError:
            pass
        except OSError:
            self._deaf = True
            self._out.clear()

    def take(self, patience: float = 0.0) -> list[bytes]:
        """The messages that have come, waiting for them at most so long [s]. One that is too long ends it all."""
        if self.closed:
            return []
        self.push()
        with suppress(OSError, ValueError):
            if patience:
                select.select([self._end], [self._end] if self._out else [], [], patience)
        try:
            while piece := self._end.recv(1 << 16):
                self._in += piece
                if len(self._in) > LARGEST:
                    raise OSError("more than a message may have")
            self.close()
        except BlockingIOError:
            pass
        except OSError:
            self.close()
        found = []
        while len(self._in) >= HEAD:
            end = HEAD + int.from_bytes(self._in[:HEAD], "little")
            if len(self._in) < end:
                break
            found.append(bytes(self._in[HEAD:end]))
            del self._in[:end]
        return found

    def close(self) -> None:
        self.closed = True
        self._out.clear()
        with suppress(OSError):
            self._end.close()


class Meeting:
    """Where the page's server finds the run: a port of this machine alone, and a word that only it was told."""

    def __init__(self) -> None:
        self.word = secrets.token_hex(16)
        self._door = socket.create_server(("127.0.0.1", 0), backlog=4)
        self._door.setblocking(False)
        self.port = int(self._door.getsockname()[1])
        self._guests: list[tuple[socket.socket, float, bytearray]] = []  # who have not said the word yet

    def met(self) -> Wire | None:
        """The server's wire, once it has come; whoever does not know the word is sent away. Waits for nobody."""
        with suppress(OSError):
            while len(self._guests) < GUESTS:
                guest, _ = self._door.accept()
                guest.setblocking(False)
                self._guests.append((guest, time.monotonic() + GREETING, bytearray()))
        found = None
        for entry in list(self._guests):
            guest, until, said = entry
            gone = time.monotonic() > until
            try:
                piece = guest.recv(len(self.word) - len(said))
                said += piece
                gone |= not piece
            except BlockingIOError:
                pass
            except OSError:
                gone = True
            if found is None and hmac.compare_digest(bytes(said), self.word.encode()):
                found = Wire(guest)
            elif not gone and len(said) < len(self.word):
                continue
            else:
                guest.close()
            self._guests.remove(entry)
        return found

    def close(self) -> None:
        for guest, _, _ in self._guests:
            guest.close()
        self._door.close()
