"""Peers by shared memory, with a second process: lock-step to the bit, and no torn value is ever taken."""

from __future__ import annotations

import subprocess
import sys
from multiprocessing import shared_memory
from pathlib import Path
from uuid import uuid4

import pytest
from peers import model_of, session
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.participant.outside.link.memory import FIRST, Block
from rovbrush.orchestrator.participant.outside.link.packets import Packet, PacketError, Signal
from rovbrush.orchestrator.results.result import Result
from rovbrush.outside import SharedMemoryPeer

ANSWERS = """
import sys
from rovbrush.outside import SharedMemoryPeer

with SharedMemoryPeer(sys.argv[1], gives=["double", "on"], takes=["n"]) as peer:
    print("there", flush=True)
    while (packet := peer.receive()) is not None:
        peer.send({"double": 2.0 * packet.values["n"], "on": packet.seq % 2 == 0}, packet.seq)
print("done")
"""
FLOODS = """
import struct, sys
from rovbrush.orchestrator.participant.outside.link.memory import Block
from rovbrush.orchestrator.participant.outside.link.packets import Packet, Signal
from rovbrush.outside import SharedMemoryPeer

memory = SharedMemoryPeer(sys.argv[1], gives=[f"v{k}" for k in range(200)])
print("there", flush=True)
number = 0
while not memory.closed:
    number += 1
    memory.send({f"v{k}": float(number) for k in range(200)}, number)
memory.close()
print(number)
"""


def name() -> str:
    return f"rovbrush_test_{uuid4().hex[:12]}"


def process(text: str, memory: str) -> subprocess.Popen[str]:
    started = subprocess.Popen(
        [sys.executable, "-c", text, memory], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert started.stdout is not None and started.stdout.readline() == "there\n", started.communicate()
    return started


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_a_process_in_lockstep_answers_every_step(tmp_path: Path, interpreted: bool) -> None:
    memory = name()
    how = f'shared_memory = {{ name = "{memory}", mode = "lockstep", timeout = "60 s", late = "stop" }}'
    with session(tmp_path, how, "2 s", interpreted) as run:
        other = process(ANSWERS, memory)
        run.advance()
        found, taken = Result(run.run()), run.run()
    out, err = other.communicate(timeout=60)
    assert (out, err) == ("done\n", "")  # it saw that the run ended, and leaves nothing to complain of
    assert not taken.failure
    n = found["clock.n"].values.tolist()
    assert found["peer.double"].values.tolist() == [0.5, *(2.0 * v for v in n[1:])]
    assert "200 taken, 0 late, 0 lost, 0 reordered, 0 refused" in taken.notes[-1]


def test_no_torn_value_is_ever_taken(tmp_path: Path) -> None:
    """Another process writes 200 equal numbers as fast as it can; whatever is read, all of them are equal."""
    memory = name()
    (tmp_path / "s.toml").write_text(
        f'format = 2\nstop_time = "1 s"\n[components.peer]\nshared_memory = {{ name = "{memory}", timeout = "60 s" }}\n'
        'period = "1 ms"\n[components.peer.declare.outputs]\n' + "\n".join(f"v{k} = 0.0" for k in range(200))
    )
    from rovbrush.orchestrator.plan.plan import make_plan
    from rovbrush.orchestrator.run.session.session import Session
    from rovbrush.orchestrator.system.assemble import assemble

    with Session(make_plan(assemble(str(tmp_path / "s.toml"))), interpreted=True) as run:
        other = process(FLOODS, memory)
        different = set()
        for _ in range(1000):
            run.advance(cycles=1)
            values = {run.get(f"peer.v{k}") for k in (0, 1, 99, 198, 199)}
            assert len(values) == 1
            different |= values
        assert model_of(run).counts.refused == 0
    assert int(other.communicate(timeout=60)[0]) >= max(different) > 0
    assert len(different) > 10


def test_a_block_that_is_being_written_or_damaged_is_not_taken() -> None:
    buffer, signals = memoryview(bytearray(256)), [Signal("a"), Signal("on", "Boolean")]
    block = Block(buffer, 0, signals)
    assert block.read(0) == (0, None)
    block.write(Packet(5, 0.1, 0.2, {"a": 1.5, "on": True}))
    seen, packet = block.read(0)
    assert packet == Packet(5, 0.1, 0.2, {"a": 1.5, "on": True})
    assert block.read(seen) == (seen, None)
    buffer[0] = 3  # somebody is writing
    assert block.read(seen) == (seen, None)
    buffer[0], buffer[40] = 4, 17
    with pytest.raises(PacketError, match="the CRC of packet 5"):
        block.read(seen)


def test_what_is_not_finite_or_no_boolean_is_refused() -> None:
    block = Block(memoryview(bytearray(256)), 0, [Signal("a", maximum=2.0), Signal("on", "Boolean")])
    for values in ({"a": float("nan"), "on": True}, {"a": 1.0, "on": 0.5}, {"a": 3.0, "on": False}):
        block.write(Packet(1, 0.0, 0.0, values))
        with pytest.raises(PacketError):
            block.read(0)


def test_memory_of_a_run_that_was_killed_is_taken_away(tmp_path: Path) -> None:
    memory = name()
    how = f'shared_memory = {{ name = "{memory}" }}'
    child = (
        "import os, sys\nsys.path.insert(0, sys.argv[2])\nfrom pathlib import Path\nfrom peers import session\n"
        "session(Path(sys.argv[3]), sys.argv[1])\nfrom multiprocessing import resource_tracker\n"
        "resource_tracker.unregister = lambda *_: None\nos.kill(resource_tracker._resource_tracker._pid, 9)\n"
        "os.kill(os.getpid(), 9)\n"
    )
    done = subprocess.run([sys.executable, "-c", child, how, str(Path(__file__).parent), str(tmp_path)], check=False)
    assert done.returncode == -9
    shared_memory.SharedMemory(memory).close()  # it was left
    with session(tmp_path, how) as run:
        run.advance()
        assert not run.failure
    with pytest.raises(FileNotFoundError):
        SharedMemoryPeer(memory, ["double", "on"], ["n"])


def test_memory_in_use_or_of_others_is_an_error(tmp_path: Path) -> None:
    memory = name()
    how = f'shared_memory = {{ name = "{memory}" }}'
    with session(tmp_path, how) as run:
        with pytest.raises(FmuError, match=r"component peer: .* is in use by the run of process"):
            session(tmp_path, how)
        with pytest.raises(ValueError, match="has other signals than x"):
            SharedMemoryPeer(memory, ["x"])
        run.advance()
        assert not run.failure
    foreign = shared_memory.SharedMemory(memory, create=True, size=FIRST)
    try:
        with pytest.raises(FmuError, match="is none of a run; take another name"):
            session(tmp_path, how)
    finally:
        foreign.close()
        foreign.unlink()


def test_a_name_that_is_a_path_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="name must be a name of letters"):
        session(tmp_path, 'shared_memory = { name = "../etc/x" }')
