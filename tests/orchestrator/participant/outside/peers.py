"""Systems with a peer, and peers, for tests."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.assemble import assemble

SYSTEM = """
format = 2
stop_time = "STOP"
connections = ["clock.n -> peer.n"]

[components.clock]
python = "clock.py:count"
period = "10 ms"

[components.peer]
HOW
period = "10 ms"
declare.inputs.n = 0.0
declare.outputs.double = "0.5 m/s"
declare.outputs.on = true
"""
CLOCK = """
def count(t, h, rate=1.0) -> {"n": float}:
    return rate * round((t + h) / h)
"""


def session(folder: Path, how: str, stop: str = "0.2 s", interpreted: bool = True) -> Session:
    (folder / "clock.py").write_text(CLOCK)
    (folder / "s.toml").write_text(SYSTEM.replace("HOW", how).replace("STOP", stop))
    return Session(make_plan(assemble(str(folder / "s.toml"))), interpreted=interpreted)


def model_of(session: Session) -> Any:
    return getattr(session.instances["peer"], "model", None)


@contextmanager
def in_thread(work: Callable[[threading.Event], None]) -> Iterator[None]:
    """`work` goes on until the event is set."""
    done = threading.Event()
    thread = threading.Thread(target=work, args=(done,))
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
