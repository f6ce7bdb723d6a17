"""Peers by UDP, with real sockets: lock-step to the bit, free running, and what is counted and never taken."""

from __future__ import annotations

import random
import re
import socket
import sys
import threading
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from helpers import interrupted
from peers import CLOCK, SYSTEM, in_thread, model_of, session
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.participant.outside.link.packets import (
    Packet,
    PacketError,
    Signal,
    from_binary,
    from_json,
    to_binary,
    to_json,
)
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.checkpoint.checkpoint import write_checkpoint
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.outside import UdpPeer

SIGNALS = [Signal("double", minimum=-100.0, maximum=100.0), Signal("on", "Boolean"), Signal("k", "Integer")]
GOOD = Packet(7, 0.1, 0.02, {"double": 1.5, "on": True, "k": -3})


def answering(peer: UdpPeer, done: threading.Event) -> None:
    while not done.is_set():
        packet = peer.receive(timeout=0.05)
        if packet is not None:
            peer.send({"double": 2.0 * packet.values["n"], "on": packet.seq % 2 == 0}, packet.seq)


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
@pytest.mark.parametrize("form", ["json", "binary"])
def test_a_peer_in_lockstep_answers_every_step(tmp_path: Path, form: Any, interpreted: bool) -> None:
    port = _free_port()
    how = f'udp = {{ listen = "127.0.0.1:{port}", send = "127.0.0.1:SEND", mode = "lockstep", format = "{form}", '
    how += 'timeout = "60 s", late = "stop" }'
    with (
        UdpPeer(f"127.0.0.1:{port}", ["double", "on"], ["n"], format=form) as peer,
        in_thread(lambda done: answering(peer, done)),
        session(tmp_path, how.replace("SEND", str(peer.port)), interpreted=interpreted) as run,
    ):
        run.advance()
        found = Result(taken := run.run())
    assert not taken.failure
    n = found["clock.n"].values.tolist()
    assert found["peer.double"].values.tolist() == [0.5, *(2.0 * v for v in n[1:])]
    assert found["peer.on"].values.tolist() == [True, *(k % 2 == 0 for k in range(1, 21))]
    assert f"component peer, UDP 127.0.0.1:{port}: 20 sent, 20 taken, 0 late, 0 lost" in "\n".join(taken.notes)


def test_free_running_takes_the_newest_and_counts_what_is_missing(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { timeout = "60 s" }') as run:
        link = model_of(run).link
        with UdpPeer(f"127.0.0.1:{link.port}", ["double", "on"], ["n"]) as peer:
            for seq in (1, 2, 5, 4, 5):  # 3 never comes, 4 comes late, 5 twice
                peer.send({"double": float(seq), "on": False}, seq)
            run.advance(cycles=1)
            assert run.get("peer.double") == 5.0 and run.get("peer.on") is False
            counts = model_of(run).counts
            assert (counts.taken, counts.passed_over, counts.lost, counts.reordered, counts.doubled) == (1, 2, 1, 1, 1)
            peer.send({"double": 9.0, "on": False}, 0)  # it has started anew
            run.advance(cycles=1)
            assert run.get("peer.double") == 9.0 and counts.restarts == 1
            run.advance(cycles=1)
            packet = peer.receive(timeout=60.0)  # to whom the last packet came from
            assert packet is not None and packet.step == 0.01
            run.advance()
        notes = run.run().notes
    assert re.search(
        r"sent, 2 taken, 2 passed over, 0 late, 1 lost, 1 reordered, 1 doubled, 0 refused, .*1 restarts", notes[-1]
    )


def test_notes_of_a_session_are_those_of_now(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { timeout = "60 s" }') as run:
        run.advance(cycles=2)
        assert len(run.run().notes) == 1
        run.advance(cycles=2)
        assert [note.count("4 not sent") for note in run.run().notes] == [1]


BAD = {
    "nothing": b"",
    "no JSON": b"hello",
    "no object": b"[1, 2]",
    "deep": b"[" * 60000,
    "no seq": b'{"values": {"double": 1.0, "on": true}}',
    "a seq below 0": b'{"seq": -1, "values": {"double": 1.0, "on": true}}',
    "a seq that is true": b'{"seq": true, "values": {"double": 1.0, "on": true}}',
    "a name too many": b'{"seq": 3, "values": {"double": 1.0, "on": true, "x": 1}}',
    "a name too few": b'{"seq": 3, "values": {"double": 1.0}}',
    "NaN": b'{"seq": 3, "values": {"double": NaN, "on": true}}',
    "beyond doubles": b'{"seq": 3, "values": {"double": 1e999, "on": true}}',
    "a text": b'{"seq": 3, "values": {"double": "1.0", "on": true}}',
    "no Boolean": b'{"seq": 3, "values": {"double": 1.0, "on": 1}}',
    "an unknown key": b'{"seq": 3, "values": {"double": 1.0, "on": true}, "exec": 1}',
    "a key twice": b'{"seq": 3, "seq": 4, "values": {"double": 1.0, "on": true}}',
    "no UTF-8": b'{"seq": 3, "values": {"double": 1.0, "on": true}}\xff',
    "binary": b"RBX1" + bytes(60),
}


def test_garbage_is_counted_and_never_taken(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { timeout = "60 s" }') as run:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            for content in BAD.values():
                stranger.sendto(content, ("127.0.0.1", model_of(run).link.port))
        run.advance(cycles=3)
        assert (run.get("peer.double"), run.get("peer.on")) == (0.5, True)
        counts = model_of(run).counts
        assert (counts.refused, counts.taken) == (len(BAD), 0)
        assert model_of(run).link.peer is None  # nothing is sent to a stranger
        assert "the last: it is no line of JSON" in run.run().notes[-1]


def test_bytes_of_any_kind_are_a_packet_or_refused() -> None:
    draw = random.Random(1)
    whole = [to_json(GOOD), to_binary(GOOD, SIGNALS)]
    for k in range(4000):
        content = bytearray(whole[k % 2])
        for _ in range(draw.randint(1, 4)):
            content[draw.randrange(len(content))] = draw.randrange(256)
        content = content[: draw.randint(0, len(content))] if k % 5 == 0 else content
        for take in (from_json, from_binary):
            try:
                found = take(bytes(content), SIGNALS)
            except PacketError:
                continue
            assert found.values.keys() == GOOD.values.keys() and -100.0 <= found.values["double"] <= 100.0
            assert type(found.values["on"]) is bool and type(found.values["k"]) is int


@pytest.mark.parametrize("token", ["", "a secret of mine"])
def test_packets_come_back_as_they_were(token: str) -> None:
    assert from_json(to_json(GOOD, token), SIGNALS, token) == GOOD
    assert from_binary(to_binary(GOOD, SIGNALS, token), SIGNALS, token) == GOOD


def test_a_packet_without_the_token_is_refused() -> None:
    with pytest.raises(PacketError, match="it has no token"):
        from_json(to_json(GOOD), SIGNALS, "a secret of mine")
    with pytest.raises(PacketError, match="it has no token"):
        from_binary(to_binary(GOOD, SIGNALS), SIGNALS, "a secret of mine")
    with pytest.raises(PacketError, match="its token is wrong"):
        from_json(to_json(GOOD, "another secret"), SIGNALS, "a secret of mine")
    with pytest.raises(PacketError, match="its token is wrong"):
        from_binary(to_binary(GOOD, SIGNALS, "another secret"), SIGNALS, "a secret of mine")
    with pytest.raises(PacketError, match="its layout is"):
        from_binary(to_binary(GOOD, SIGNALS), SIGNALS[::-1])


@pytest.mark.parametrize(("late", "after"), [("hold", 3.0), ("default", 0.5)])
def test_what_holds_when_a_peer_is_late(tmp_path: Path, late: str, after: float) -> None:
    how = f'udp = {{ mode = "lockstep", timeout = "1 ms", late = "{late}" }}'
    with session(tmp_path, how) as run:
        with UdpPeer(f"127.0.0.1:{model_of(run).link.port}", ["double", "on"]) as peer:
            peer.send({"double": 3.0, "on": False}, 1)
            run.advance(cycles=1)
            assert run.get("peer.double") == 3.0
            run.advance(cycles=4)
        assert run.get("peer.double") == after
        counts = model_of(run).counts
        assert (counts.taken, counts.late) == (1, 4)


def test_a_peer_that_stops_answering_ends_the_run_with_its_rows(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { mode = "lockstep", timeout = "1 ms", late = "stop" }') as run:
        with UdpPeer(f"127.0.0.1:{model_of(run).link.port}", ["double", "on"]) as peer:
            peer.send({"double": 3.0, "on": False}, 1)
            run.advance()
        port, taken = model_of(run).link.port, run.run()
    assert (
        f"component peer: no answer came at UDP 127.0.0.1:{port} within 0.001 s in the step to t = 0.02 s"
        in taken.failure
    )
    assert Result(taken)["peer.double"].values.tolist()[:2] == [0.5, 3.0]


def test_an_answer_to_a_step_before_is_not_taken(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { mode = "lockstep", timeout = "1 ms" }') as run:
        with UdpPeer(f"127.0.0.1:{model_of(run).link.port}", ["double", "on"]) as peer:
            run.advance(cycles=3)
            peer.send({"double": 3.0, "on": False}, 2)
            peer.send({"double": 4.0, "on": False}, 4)
            run.advance(cycles=1)
        assert run.get("peer.double") == 4.0
        assert model_of(run).counts.reordered == 1


def test_a_peer_that_must_be_there_first_is_missed_before_the_run(tmp_path: Path) -> None:
    with pytest.raises(FmuError, match=r"component peer: .* nothing came at UDP .* within 0.001 s \(first\)"):
        session(tmp_path, 'udp = { first = "1 ms" }')


def test_a_port_in_use_is_an_error_that_says_so(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
        words = f"component peer: .*cannot listen at 127.0.0.1:{port}: Address already in use; end the other program"
        with pytest.raises(FmuError, match=words):
            session(tmp_path, f'udp = {{ listen = "127.0.0.1:{port}" }}')
    with session(tmp_path, f'udp = {{ listen = "127.0.0.1:{port}" }}'):  # and it was given back
        pass
    with session(tmp_path, f'udp = {{ listen = "127.0.0.1:{port}" }}'):
        pass


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ('udp = { listen = "0.0.0.0:9010" }', "is not this machine's own loopback .* there is no token"),
        ('udp = { send = "192.0.2.1:9010" }', "send = '192.0.2.1:9010' is not this machine's own loopback"),
        ('udp = { listen = "localhost" }', 'must be "host:port"'),
        ('udp = { listen = "127.0.0.1:70000" }', 'must be "host:port" with a port from 0 to 65535'),
        ('udp = { send = "127.0.0.1:0" }', "has port 0, where nothing can be sent"),
        ('udp = { token = "short" }', "shorter than 8 characters"),
        ('udp = { token = "env:NO_SUCH_VARIABLE" }', "the environment has no NO_SUCH_VARIABLE"),
        ('udp = { late = "wait" }', "unknown late 'wait'"),
        ('udp = { timeout = "0 s" }', "timeout"),
        ('udp = { first = "-1 s" }', "first = '-1 s' is negative"),
        ('udp = { lisen = "127.0.0.1:0" }', "unknown key 'lisen'; did you mean 'listen'"),
        ("udp = { }\ndeclare.parameters.k = 1.0", "declare.parameters is for `python`"),
        ('udp = { }\nlogging = "all"', "logging is for FMUs, and udp is none"),
    ],
)  # fmt: skip
def test_what_is_stated_wrongly_is_refused_with_its_place(tmp_path: Path, how: str, words: str) -> None:
    with pytest.raises(InputError, match=words) as error:
        session(tmp_path, how)
    assert "component peer" in str(error.value) and "s.toml" in str(error.value)


def test_a_token_is_in_no_digest_and_no_message(tmp_path: Path) -> None:
    with session(tmp_path, 'udp = { token = "a secret of mine" }') as run:
        fmu = run.plan.system.components["peer"].fmu
        digest = fmu.digest
        assert "secret" not in repr(fmu)
    with session(tmp_path, 'udp = { token = "another secret" }') as run:
        assert run.plan.system.components["peer"].fmu.digest == digest


def _free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as found:
        found.bind(("127.0.0.1", 0))
        return int(found.getsockname()[1])


@pytest.mark.parametrize("algorithm", ["iterated", "adaptive"])
def test_what_goes_back_refuses_a_peer_before_the_run(tmp_path: Path, algorithm: str) -> None:
    system = SYSTEM.replace("HOW", "udp = {}").replace("STOP", "1 s")
    (tmp_path / "clock.py").write_text(CLOCK)
    (tmp_path / "s.toml").write_text(f'algorithm = "{algorithm}"\n{system}')
    with pytest.raises(
        InputError, match=r"component peer: .* needs to restore states, and udp 127.0.0.1:0 cannot save"
    ):
        make_plan(assemble(str(tmp_path / "s.toml")))


def test_a_checkpoint_refuses_a_peer(tmp_path: Path) -> None:
    with session(tmp_path, "udp = {}") as run:
        run.advance(cycles=1)
        with pytest.raises(InputError, match=r"component peer: udp 127.0.0.1:0 cannot write its state to disk"):
            write_checkpoint(run, tmp_path)


@pytest.mark.parametrize("how", ["udp", "shared_memory"])
def test_ctrl_c_ends_a_wait_for_a_peer_long_before_its_timeout(how: str, tmp_path: Path) -> None:
    named = f'name = "rovbrush_{uuid4().hex[:8]}"' if how == "shared_memory" else f'listen = "127.0.0.1:{_free_port()}"'
    text = SYSTEM.replace("HOW", f'{how} = {{ {named}, mode = "lockstep", timeout = "300 s" }}').replace("STOP", "1 s")
    (tmp_path / "s.toml").write_text(text)
    (tmp_path / "clock.py").write_text(CLOCK.replace("    return", '    print("stepped", flush=True)\n    return'))
    command = [sys.executable, "-m", "rovbrush", "run", str(tmp_path / "s.toml"), "--out", str(tmp_path / "out")]
    code, err = interrupted(command, "stepped")
    assert code == 1 and "interrupted by the user" in err and "marked incomplete" in err
