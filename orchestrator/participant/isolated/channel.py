"""Between the master and an FMU in a process of its own: a pipe each way for what to do, shared memory for the values.

A message has a head (a mark, a number that answers repeat, the length of what follows, a checksum), a letter and a
body. `J`: a call by name, as JSON. `F`: an FMI function by its number, with the value references and values in the
shared memory; the answer is the status, and as JSON what is new of the instance. The FMU's code shares the process and
may write to every descriptor there, or close it: what does not fit ends the conversation and is never taken for an
answer. It gets no chance to keep the master waiting either: every wait has an end.
"""

from __future__ import annotations

import base64
import json
import os
import select
import struct
import time
import zlib
from contextlib import suppress
from typing import Any

MARK = 0x52764263
HEAD = struct.Struct("<IIII")
CALL = struct.Struct(
    "<HxxxxxxQQdd?"
)  # function, references, values; for a step its time, length and whether it is final
STATUS = struct.Struct("<i")
ENDS = 16  # bytes: the three flags of fmi3DoStep, and from byte 8 the last time reached
LONGEST = 1 << 30  # bytes of a message: a state as text
BYTES = "base64"  # the key of bytes in JSON
ASIDE = 640  # the number from which on descriptors lie out of the way of code that closes or fills the first ones


def to_json(content: Any) -> bytes:
    """What is passed on by name; bytes as text that says that it is such."""
    return json.dumps(content, default=lambda found: {BYTES: base64.b64encode(found).decode()}).encode()


def from_json(content: bytes) -> Any:
    """What `to_json` made of it. Raises ValueError for what is no JSON."""
    return json.loads(
        content, object_hook=lambda found: base64.b64decode(found[BYTES]) if found.keys() == {BYTES} else found
    )


class ChannelClosedError(Exception):
    """The other side has gone."""


class ChannelBrokenError(Exception):
    """What came is no message of the other side."""


class ChannelSilentError(Exception):
    """The other side did not read or answer in time."""


class Channel:
    """One side's ends of the two pipes."""

    longest = LONGEST

    def __init__(self, reads: int, writes: int) -> None:
        self.reads, self.writes = reads, writes
        for pipe in (reads, writes):
            os.set_blocking(pipe, False)
        self.number = 0  # of the last message that was sent
        self._came = bytearray()  # and is not yet taken
        self._readable, self._writable = select.poll(), select.poll()
        self._readable.register(reads, select.POLLIN)
        self._writable.register(writes, select.POLLOUT)

    def ask(self, letter: bytes, body: bytes, limit: float) -> tuple[bytes, bytes]:
        """Send a message; the letter and body of its answer. Those to messages that a Ctrl-C gave up are dropped.

        `limit` [s] for all of it. Raises ChannelClosedError, ChannelBrokenError, ChannelSilentError.
        """
        end = time.monotonic() + limit
        self.number += 1
        self.send(letter, body, self.number, end)
        while True:
            number, letter, body = self.receive(end)
            if number == self.number:
                return letter, body
            if number > self.number:
                raise ChannelBrokenError

    def send(self, letter: bytes, body: bytes, number: int, end: float | None = None) -> None:
        """Write a whole message until `end` (of time.monotonic)."""
        content = letter + body
        data = memoryview(HEAD.pack(MARK, number, len(content), zlib.crc32(content, number)) + content)
        while data:
            try:
                data = data[self._write(data) :]
            except BlockingIOError:
                self._wait(True, end)
            except OSError as error:
                raise ChannelClosedError from error

    def receive(self, end: float | None = None) -> tuple[int, bytes, bytes]:
        """Number, letter and body of the next message."""
        mark, number, length, checksum = HEAD.unpack(self._exactly(HEAD.size, end))
        if mark != MARK or not 0 < length <= self.longest:
            raise ChannelBrokenError
        content = self._exactly(length, end)
        if zlib.crc32(content, number) != checksum:
            raise ChannelBrokenError
        return number, content[:1], content[1:]

    def _exactly(self, length: int, end: float | None) -> bytes:
        while len(self._came) < length:
            self._wait(False, end)
            try:
                part = self._read()
            except BlockingIOError:
                continue
            except OSError as error:
                raise ChannelClosedError from error
            if not part:
                raise ChannelClosedError
            self._came += part
        found = bytes(self._came[:length])
        del self._came[:length]
        return found

    def _read(self) -> bytes:
        """What there is; nothing where the other side has gone."""
        return os.read(self.reads, 1 << 16)

    def _write(self, data: memoryview) -> int:
        """How much of it was taken."""
        return os.write(self.writes, data)

    def _wait(self, to_write: bool, end: float | None) -> None:
        """Until something can be read or written, and no longer than to `end`."""
        for_what = self._writable if to_write else self._readable
        left = None if end is None else 1000.0 * (end - time.monotonic())
        if (left is not None and left <= 0.0) or not for_what.poll(left):
            raise ChannelSilentError

    def close(self) -> None:
        for pipe in (self.writes, self.reads):
            with suppress(OSError):
                os.close(pipe)
        self.reads = self.writes = -1


def aside(descriptor: int) -> int:
    """The same open file under a number out of the way, not inherited by programs that the FMU starts."""
    import fcntl

    try:
        moved = fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, ASIDE)
    except OSError:  # a lower limit of open files
        return descriptor
    os.close(descriptor)
    return moved
