"""The way to a peer through shared memory, and the layout that both sides keep to.

    0     8s "RBSHM1", u32 n to the peer, u32 n from it, u32 layout to it, u32 layout from it, u64 pid of the owner,
          u64 1 when the owner has closed it
    64    the block to the peer, then at the next multiple of 64 the block from it:
          u64 counter, u64 seq, f64 time, f64 step, n x f64, u32 CRC-32 of all behind the counter, u32 0

All little-endian. Who writes makes the counter odd, writes, and makes it even; who reads takes a block only where the
counter was the same even number before and behind, and the CRC fits: no torn value is ever taken, whatever the order
in which a processor shows what was written. A counter of 0 is a block that nobody has written.
"""

from __future__ import annotations

import os
import struct
import sys
import time as wall
import zlib
from collections.abc import Sequence
from multiprocessing import resource_tracker, shared_memory
from typing import Any

from ....errors import FmuError
from ....files import is_alive
from .packets import Packet, PacketError, Signal, layout_of

MAGIC, HEAD, BLOCK = b"RBSHM1\0\0", struct.Struct("<8sIIIIQQ"), struct.Struct("<QQdd")
FIRST, LINE = 64, 64
PID, CLOSED = 24, 32  # where in the head
TORN = 1000  # tries to read a block that is being written
NAP = 5e-5  # s between two looks


class Block:
    """One direction of it. `at`: its offset [bytes]."""

    def __init__(self, buffer: Any, at: int, signals: Sequence[Signal]) -> None:
        self.buffer, self.at, self.signals = buffer, at, signals
        self.values = struct.Struct(f"<{len(signals)}d")
        self.end = at + BLOCK.size + self.values.size

    @staticmethod
    def size(count: int) -> int:
        """Bytes of a block of so many signals, to the beginning of the next."""
        return -(-(BLOCK.size + 8 * count + 8) // LINE) * LINE

    def counter(self) -> int:
        return int(struct.unpack_from("<Q", self.buffer, self.at)[0])

    def write(self, packet: Packet) -> None:
        counter = self.counter() | 1
        struct.pack_into("<Q", self.buffer, self.at, counter)
        struct.pack_into("<Qdd", self.buffer, self.at + 8, packet.seq, packet.time, packet.step)
        values = [float(packet.values[signal.name]) for signal in self.signals]
        self.values.pack_into(self.buffer, self.at + BLOCK.size, *values)
        struct.pack_into("<II", self.buffer, self.end, zlib.crc32(bytes(self.buffer[self.at + 8 : self.end])), 0)
        struct.pack_into("<Q", self.buffer, self.at, counter + 1)

    def read(self, before: int) -> tuple[int, Packet | None]:
        """Its counter and what it holds, None where the counter is still `before`, or it is being written. Raises
        PacketError for what is no packet."""
        for _ in range(TORN):
            counter = self.counter()
            if counter == before or counter == 0:
                return before, None
            content = bytes(self.buffer[self.at : self.end + 8])
            if counter % 2 == 0 and self.counter() == counter:
                break
        else:
            return before, None
        (crc, _) = struct.unpack_from("<II", content, len(content) - 8)
        _, seq, time, step = BLOCK.unpack_from(content)
        if crc != zlib.crc32(content[8:-8]):
            raise PacketError(f"the CRC of packet {seq} in shared memory does not fit", counter)
        doubles = self.values.unpack_from(content, BLOCK.size)
        try:
            values = {s.name: s.of_double(v) for s, v in zip(self.signals, doubles, strict=True)}
        except PacketError as error:
            raise PacketError(str(error), counter) from None
        return counter, Packet(seq, time, step, values)


def attached(name: str) -> shared_memory.SharedMemory:
    """Memory of somebody else. Python before 3.13 takes away what a process has only looked at when that ends; this
    does not. Raises OSError, ValueError."""
    if sys.version_info >= (3, 13):
        return shared_memory.SharedMemory(name, track=False)
    register = resource_tracker.register
    resource_tracker.register = lambda *_: None
    try:
        return shared_memory.SharedMemory(name)
    finally:
        resource_tracker.register = register


def blocks_of(buffer: Any, to: Sequence[Signal], back: Sequence[Signal]) -> tuple[Block, Block]:
    """The block to the peer, and that from it."""
    return Block(buffer, FIRST, to), Block(buffer, FIRST + Block.size(len(to)), back)


class MemoryLink:
    """The owner's side: it makes the memory and takes it away."""

    def __init__(self, name: str, sends: Sequence[Signal], takes: Sequence[Signal]) -> None:
        self.name, self.sends, self.takes = name, sends, takes
        self.memory: shared_memory.SharedMemory | None = None
        self.buffer: Any = None
        self.seen = 0

    def open(self) -> None:
        size = FIRST + Block.size(len(self.sends)) + Block.size(len(self.takes))
        try:
            try:
                self.memory = shared_memory.SharedMemory(self.name, create=True, size=size)
            except FileExistsError:
                self._remove_dead()
                self.memory = shared_memory.SharedMemory(self.name, create=True, size=size)
        except (OSError, ValueError) as error:
            raise FmuError(f"shared memory {self.name!r} cannot be made: {getattr(error, 'strerror', error)}") from None
        self.buffer = self.memory.buf
        self.buffer[:size] = bytes(size)
        self.out, self.back = blocks_of(self.buffer, self.sends, self.takes)
        head = (len(self.sends), len(self.takes), layout_of(self.sends), layout_of(self.takes))
        HEAD.pack_into(self.buffer, 0, MAGIC, *head, os.getpid(), 0)

    def _remove_dead(self) -> None:
        """Take away what a run left that was killed. Raises FmuError for one that is alive, or that is none of ours."""
        left = attached(self.name)
        try:
            head = bytes(left.buf or b"")[: HEAD.size]
            ours = len(head) == HEAD.size and head[:8] == MAGIC
            pid = int(struct.unpack_from("<Q", head, PID)[0]) if ours else 0
            if not ours:
                raise FmuError(f"shared memory {self.name!r} is there already and is none of a run; take another name")
            if is_alive(pid):
                raise FmuError(
                    f"shared memory {self.name!r} is in use by the run of process {pid}; end that, or take another name"
                )
        finally:
            left.close()
        ours_now = shared_memory.SharedMemory(self.name)
        ours_now.close()
        ours_now.unlink()

    def text(self) -> str:
        return f"shared memory {self.name}"

    def send(self, packet: Packet) -> bool:
        if self.memory is None:
            return False
        self.out.write(packet)
        return True

    def receive(self, until: float) -> Packet | None:
        while self.memory is not None:
            try:
                self.seen, packet = self.back.read(self.seen)
            except PacketError as error:
                self.seen = int(error.args[1])
                raise PacketError(error.args[0]) from None
            if packet is not None:
                return packet
            if wall.monotonic() >= until:
                return None
            wall.sleep(NAP)
        return None

    def close(self) -> None:
        if self.memory is not None:
            memory, self.memory = self.memory, None
            self.buffer[CLOSED] = 1
            del self.out, self.back
            self.buffer = None
            memory.close()
            memory.unlink()
