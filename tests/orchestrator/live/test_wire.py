"""Messages to the page's server and back: whole or not at all, never waited for, and from nobody else."""

from __future__ import annotations

import socket
import time

from rovbrush.orchestrator.live.wire import LARGEST, Meeting, Wire


def pair() -> tuple[Wire, socket.socket]:
    here, there = socket.socketpair()
    there.settimeout(5.0)
    return Wire(here), there


def met(meeting: Meeting) -> Wire | None:
    """After a while, as connections take one."""
    for _ in range(200):
        if found := meeting.met():
            return found
        time.sleep(0.005)
    return None


def test_messages_arrive_whole_whatever_the_pieces() -> None:
    wire, there = pair()
    data = b"".join(len(m).to_bytes(4, "little") + m for m in (b"one", b"", b"three" * 1000))
    found = []
    for k in range(0, len(data), 7):
        there.sendall(data[k : k + 7])
        found += wire.take()
    assert found == [b"one", b"", b"three" * 1000]


def test_what_nobody_takes_is_dropped_and_counted() -> None:
    wire, there = pair()
    sent = sum(wire.post(bytes(10_000), 50_000) for _ in range(1000))
    assert wire.dropped == 1000 - sent > 0
    with there:
        got = 0
        while got < sent * 10_004:
            got += len(there.recv(1 << 20))
            wire.push()
    assert got == sent * 10_004


def test_a_message_longer_than_any_ends_the_connection() -> None:
    wire, there = pair()
    there.setblocking(False)
    for _ in range(10_000):
        try:
            there.send(b"\xff" * 65536)
        except BlockingIOError:
            wire.take()
        except OSError:
            break
    assert wire.closed and LARGEST < 2**32


def test_the_server_that_knows_the_word_is_met() -> None:
    meeting = Meeting()
    with socket.create_connection(("127.0.0.1", meeting.port)) as server:
        server.sendall(meeting.word.encode())
        wire = met(meeting)
        assert wire is not None
        wire.post(b"hello")
        assert server.recv(100) == b"\x05\0\0\0hello"
    meeting.close()


def test_a_stranger_is_sent_away_and_nobody_waits_for_one() -> None:
    meeting = Meeting()
    silent = [socket.create_connection(("127.0.0.1", meeting.port)) for _ in range(2)]
    with socket.create_connection(("127.0.0.1", meeting.port)) as stranger:
        stranger.sendall(b"x" * len(meeting.word))
        stranger.settimeout(5.0)
        assert met(meeting) is None
        assert stranger.recv(1) == b""
    with socket.create_connection(("127.0.0.1", meeting.port)) as server:
        server.sendall(meeting.word.encode())
        assert met(meeting) is not None
    for other in silent:
        other.close()
    meeting.close()
