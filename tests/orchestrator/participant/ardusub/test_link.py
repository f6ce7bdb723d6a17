"""The socket to an autopilot, with one that is fake: what it loses, doubles, mixes up or sends anew does no harm."""

from __future__ import annotations

import json
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from fixtures.fake_autopilot import FakeAutopilot, Faults
from helpers import FIXTURES
from rovbrush.orchestrator.ardupilot.state_line import VehicleState, state_line
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.participant.ardusub.link import Link
from rovbrush.orchestrator.participant.ardusub.waits import Waits

NOUGHT = (0.0, 0.0, 0.0)
Pair = tuple[Link, FakeAutopilot]


def line(k: int) -> bytes:
    return state_line(VehicleState(k / 400, NOUGHT, (0.0, 0.0, -9.8), NOUGHT, NOUGHT, NOUGHT))


@pytest.fixture
def pair() -> Iterator[Callable[..., Pair]]:
    """A link and an autopilot that is with it; both end with the test."""
    made: list[Pair] = []

    def make(faults: Faults | None = None, timeout: float = 20.0, **more: Any) -> Pair:
        link = Link(400, port=0, timeout=timeout, repeat_after=0.01)
        fake = FakeAutopilot(link.port, faults=faults, patience=0.05, **more)
        made.append((link, fake))
        fake.start()
        return link, fake

    yield make
    for link, fake in made:
        link.close()
        fake.stop()


def steps(link: Link, count: int) -> list[Any]:
    """The first frame and `count` exchanges."""
    packets = [link.begin()]
    return packets + [link.exchange(line(k)) for k in range(count)]


@pytest.mark.parametrize("channels", [16, 32])
def test_every_frame_comes_once_with_either_magic(pair: Callable[..., Pair], channels: int) -> None:
    link, fake = pair(channels=channels)
    packets = steps(link, 200)
    assert [packet.frame_count for packet in packets] == list(range(201))
    assert {len(packet.pwm) for packet in packets} == {channels}
    assert [state["timestamp"] for state in fake.states[:200]] == [k / 400 for k in range(200)]
    counts = link.frames.counts
    assert (counts.frames, counts.lost, counts.doubled, counts.late, counts.garbage) == (201, 0, 0, 0, 0)
    assert sum(link.waits.counts) == 200 and "99 % below" in link.text()


def test_packets_that_are_lost_doubled_late_or_garbage_change_no_frame(pair: Callable[..., Pair]) -> None:
    faults = Faults(
        lose={3, 40}, deaf={5, 41}, double={7, 8}, late={11, 12}, garbage={20: b"hello", 21: b"", 22: b"\x1a\x48" * 20}
    )
    link, fake = pair(faults)
    packets = steps(link, 60)
    assert [packet.frame_count for packet in packets] == list(range(61))
    times = [state["timestamp"] for state in fake.states[:60]]
    assert times == [k / 400 for k in range(60)]  # each state was gone on with once
    counts = link.frames.counts
    assert counts.lost == 0 and counts.doubled == 2 and counts.late == 2 and counts.garbage == 3
    assert counts.asked_again >= 2  # it had not heard the answers to frames 5 and 41


def test_a_gap_in_the_counter_is_told(pair: Callable[..., Pair]) -> None:
    link, _ = pair(Faults(skip={4}))
    assert [packet.frame_count for packet in steps(link, 4)] == [0, 1, 2, 3, 5]
    assert link.frames.counts.lost == 1


def test_an_autopilot_that_is_started_anew_is_gone_on_with(pair: Callable[..., Pair]) -> None:
    link, fake = pair(Faults(restart=30))
    packets = steps(link, 50)
    assert [packet.frame_count for packet in packets] == [*range(30), *range(21)]
    assert link.frames.counts.restarts == 1 and fake.starts == 1


def test_silence_from_the_start_is_an_error_that_says_what_to_start() -> None:
    link = Link(400, port=0, timeout=0.05)
    with pytest.raises(
        RunError, match=rf"no autopilot was heard at UDP 127\.0\.0\.1:{link.port} for 0\.05 s; start one"
    ):
        link.begin()
    link.close()


def test_garbage_alone_is_silence_that_names_it() -> None:
    link = Link(400, port=0, timeout=0.3)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        for content in (b"hello", struct.pack("<H", 1234) + bytes(38), bytes(5000)):
            stranger.sendto(content, ("127.0.0.1", link.port))
        with pytest.raises(RunError, match=r"3 packets were no servo packets \(the last: magic 0; servo packets have"):
            link.begin()
    link.close()


def test_an_autopilot_that_stops_answering_is_named_with_its_last_frame(pair: Callable[..., Pair]) -> None:
    link, _ = pair(Faults(silent=5), timeout=1.0)
    with pytest.raises(
        RunError, match=r"at 127\.0\.0\.1:\d+ stopped answering: .* after its frame 4 \(5 frames, 0 lost"
    ):
        steps(link, 10)


def test_a_wrong_rate_ends_it_and_names_sim_rate_hz(pair: Callable[..., Pair]) -> None:
    link, _ = pair(rate=1200)
    with pytest.raises(RunError, match="SIM_RATE_HZ to 400"):
        steps(link, 10)


def test_a_port_in_use_is_an_error_that_says_so() -> None:
    link = Link(400, port=0)
    with pytest.raises(InputError, match=rf"cannot listen at UDP 127\.0\.0\.1:{link.port} \(Address already in use\)"):
        Link(400, port=link.port)
    link.close()
    Link(400, port=link.port).close()  # a link that is closed gives it back


def test_packets_of_another_address_than_the_peers_are_not_read() -> None:
    link = Link(400, port=0, timeout=0.3, peer="192.0.2.1")
    fake = FakeAutopilot(link.port, patience=0.05)
    fake.start()
    with pytest.raises(RunError, match="packets came from somebody else"):
        link.begin()
    fake.stop()
    link.close()


def test_waits_are_counted_by_doublings() -> None:
    waits = Waits()
    for _ in range(98):
        waits.add(50e-6)
    waits.add(900e-6)
    waits.add(0.25)
    assert waits.text() == "half below 64 us, 99 % below 1.02 ms, worst 250 ms"


def test_the_tool_of_the_guide_answers_and_says_how_often() -> None:
    link = Link(400, port=0, timeout=60.0)
    command = [sys.executable, FIXTURES / "fake_autopilot.py", "--port", str(link.port), "--channels", "32"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as tool:
        steps(link, 20)
        tool.send_signal(signal.SIGINT)
        assert "frames answered, 0 of them twice, 0 at an odd time" in tool.communicate(timeout=60.0)[0]
    link.close()


def test_the_states_are_json(pair: Callable[..., Pair]) -> None:
    assert json.loads(line(1))["timestamp"] == 0.0025
