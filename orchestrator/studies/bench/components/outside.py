"""What a step costs of components that are no FMU: Python functions, and peers in lock-step in another process."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from uuid import uuid4

from ....errors import RunError
from ....plan.plan import make_plan
from ....run.session.session import Session
from ....system.assemble import assemble

RUNS, QUICK = 9, 3
SIGNALS = 4  # each way
NAMES = [f"u{k}" for k in range(SIGNALS)], [f"y{k}" for k in range(SIGNALS)]
FUNCTION = f"""
def step(t, h, {", ".join(NAMES[0])}) -> {{{", ".join(f'"{name}": float' for name in NAMES[1])}}}:
    return {", ".join(NAMES[0])}
"""
CLASS = f"""
class Step:
    def step(self, t, h, {", ".join(NAMES[0])}) -> {{{", ".join(f'"{name}": float' for name in NAMES[1])}}}:
        return {", ".join(NAMES[0])}
"""
PEER = """
import sys
from rovbrush.outside import SharedMemoryPeer, UdpPeer

kind, where = sys.argv[1:]
gives, takes = [f"y{k}" for k in range(SIGNALS)], [f"u{k}" for k in range(SIGNALS)]
if kind == "memory":
    peer = SharedMemoryPeer(where, gives, takes)
else:
    peer = UdpPeer("127.0.0.1:9", gives, takes, format=kind)
    peer.to = ("127.0.0.1", int(where))
    print(peer.port, flush=True)
while (packet := peer.receive(5.0)) is not None:
    peer.send({f"y{k}": packet.values[f"u{k}"] for k in range(SIGNALS)}, packet.seq)
""".replace("SIGNALS", str(SIGNALS))
LOCKSTEP = 'mode = "lockstep", timeout = "20 s", late = "stop"'


def outside_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds of a macro step of such a component with four inputs and four outputs, beside a compiled function
    that sends and takes them; medians of runs. With each row comes the share of the work that is done."""
    (folder / "plain.py").write_text(FUNCTION + CLASS)
    (folder / "machine.py").write_text(f"from numba import njit\n\n@njit{FUNCTION}")
    kinds = {
        "compiled Python function": ('python = "machine.py:step"', ""),
        "Python function": ('python = "plain.py:step"', ""),
        "Python class": ('python = "plain.py:Step"', ""),
        "shared memory, lock-step": (f'shared_memory = {{ name = "NAME", {LOCKSTEP} }}', "memory"),
        "UDP binary, lock-step": (f'udp = {{ format = "binary", {LOCKSTEP} }}', "binary"),
        "UDP JSON, lock-step": (f'udp = {{ format = "json", {LOCKSTEP} }}', "json"),
    }
    for what, (how, peer) in kinds.items():
        name = f"rovbrush_bench_{uuid4().hex[:12]}"
        steps = 5_000 if not peer else 1_000
        seconds = _seconds(folder, how.replace("NAME", name), peer, name, steps, QUICK if quick else RUNS)
        row = {"kind": what, "signals": SIGNALS, "runs": len(seconds), "us_per_step": 1e6 * statistics.median(seconds)}
        yield 1.0 / len(kinds), row | {"best_us_per_step": 1e6 * min(seconds)}


def _seconds(folder: Path, how: str, peer: str, name: str, steps: int, runs: int) -> list[float]:
    """Of each step, in so many pieces of one run."""
    wires = [f'"c.y{k} -> d.u{k}"' for k in range(SIGNALS)] + [f'"d.y{k} -> c.u{k}"' for k in range(SIGNALS)]
    declared = "".join(f"declare.inputs.u{k} = 0.0\ndeclare.outputs.y{k} = 0.0\n" for k in range(SIGNALS)) * bool(peer)
    (folder / "outside.toml").write_text(
        f'format = 2\nstop_time = "{(runs + 1) * steps} ms"\nconnections = [{", ".join(wires)}]\nrecord = ["d.y0"]\n'
        f'[components.c]\n{how}\nperiod = "1 ms"\n{declared}\n'
        f'[components.d]\npython = "machine.py:step"\nperiod = "1 ms"\n'
    )
    with Session(make_plan(assemble(str(folder / "outside.toml")))) as session, _peer(session, peer, name):
        found = []
        for _ in range(runs + 1):
            begin = time.perf_counter()
            session.advance(cycles=steps)
            found.append((time.perf_counter() - begin) / steps)
        if session.failure:
            raise RunError(session.failure)
    return found[1:]  # the first warms up


@contextmanager
def _peer(session: Session, kind: str, name: str) -> Iterator[None]:
    """The other process; it ends by itself where nothing comes any more."""
    if not kind:
        yield
        return
    link = getattr(session.instances["c"], "model").link  # noqa: B009 (every participant of this system has one)
    where = name if kind == "memory" else str(link.port)
    other = subprocess.Popen([sys.executable, "-c", PEER, kind, where], stdout=subprocess.PIPE, text=True)
    try:
        if kind != "memory":
            assert other.stdout is not None
            link.peer = ("127.0.0.1", int(other.stdout.readline()))
        yield
    finally:
        other.terminate()
        other.communicate()
