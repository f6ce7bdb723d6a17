"""What the server knows of the run: the last of every kind of message, rows of the last while, and the way back."""

from __future__ import annotations

import asyncio
from collections import deque

from ..messages import JSON, Do, Done, Hello, Said, State, packed_command, unpacked
from ..server import Settings
from ..wire import HEAD

LARGEST = 64 << 20  # bytes of a message
KEPT = 600  # messages of rows, for whoever comes later
EVERY = 3  # of them one is kept
BOX = 3  # that wait for one viewer; older ones are dropped
PENDING = 1 << 20  # bytes of commands that the run has not read


class Box:
    """Rows for one viewer: the newest, and how many were dropped because that one was slow."""

    def __init__(self) -> None:
        self.rows: deque[bytes] = deque(maxlen=BOX)
        self.came = asyncio.Event()
        self.dropped = 0

    def put(self, message: bytes) -> None:
        self.dropped += len(self.rows) == BOX
        self.rows.append(message)
        self.came.set()


class Link:
    """`gone`: the run's process is no more. `version` grows with every message that is not rows."""

    def __init__(self) -> None:
        self.hello: Hello | None = None
        self.state: State | None = None
        self.done = Done([], "")
        self.said: deque[tuple[int, Said]] = deque(maxlen=50)
        self.version, self.attempt, self.gone = 0, 0, False
        self.kept: deque[bytes] = deque(maxlen=KEPT)
        self.boxes: set[Box] = set()
        self._count = 0
        self._writer: asyncio.StreamWriter | None = None

    async def listen(self, settings: Settings) -> None:
        """Until the run is gone."""
        try:
            reader, self._writer = await asyncio.open_connection("127.0.0.1", settings.meeting)
            self._writer.write(settings.word.encode())
            while True:
                size = int.from_bytes(await reader.readexactly(HEAD), "little")
                if size > LARGEST:
                    break
                self._take(await reader.readexactly(size))
        except (OSError, asyncio.IncompleteReadError):
            pass
        self.gone, self.version = True, self.version + 1

    def _take(self, message: bytes) -> None:
        if not message.startswith(JSON):
            self._count += 1
            if self._count % EVERY == 0:
                self.kept.append(message)
            for box in self.boxes:
                box.put(message)
            return
        found = unpacked(message)
        self.version += 1
        if isinstance(found, Hello):
            self.hello = found
        elif isinstance(found, State):
            self.state = found
            if found.attempt != self.attempt:
                self.attempt = found.attempt
                self.kept.clear()
        elif isinstance(found, Done):
            self.done = found
        else:
            self.said.append((self.version, found))

    def ask(self, do: Do) -> bool:
        """Hand a command on; False if the run is gone, or has read none for long."""
        writer = self._writer
        if self.gone or writer is None or writer.transport.get_write_buffer_size() > PENDING:
            return False
        message = packed_command(do)
        writer.write(len(message).to_bytes(HEAD, "little") + message)
        return True
