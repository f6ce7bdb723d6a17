"""Servers of FMUs for tests, at ports that the system chooses."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from helpers import read_system
from native_build import built, needs_gcc
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.elsewhere import greeting
from rovbrush.orchestrator.participant.elsewhere.connection import TOKEN
from rovbrush.orchestrator.participant.elsewhere.server import Server
from rovbrush.orchestrator.participant.opening import start

PATIENCE = 20.0  # s, of which a test that passes needs a fraction
SERVERS = [needs_gcc, pytest.mark.skipif(os.name != "posix", reason="the servers of the tests need fork")]
PARTS = {"a": ("feedthrough2", "1 ms", {"=u": 1.5}), "b": ("feedthrough2", "1 ms")}


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """FMUs of C."""
    return built(tmp_path_factory.mktemp("native"))


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """No token but that of the test, and no waiting behind a wrong one."""
    monkeypatch.delenv(TOKEN, raising=False)
    monkeypatch.setattr(greeting, "SLOWED", 0.0)


class Serving(Server):
    """A server that keeps what it says."""

    def __init__(self, fmus: list[Path], token: str = "", most: int = 16) -> None:
        self.said: list[str] = []
        super().__init__([Fmu.open(path) for path in fmus], "127.0.0.1", 0, token, most, self.said.append)

    def says(self, words: str) -> str:
        """The line with these words, as soon as it is there."""
        return wait_for(lambda: next((line for line in self.said if words in line), ""), f"{words}: {self.said}")


@contextmanager
def serving(*fmus: Path, token: str = "", most: int = 16) -> Iterator[Serving]:
    """A server in a thread of this process, until the end of the block."""
    server = Serving(list(fmus), token, most)
    thread = threading.Thread(target=server.serve)
    thread.start()
    try:
        yield server
    finally:
        server.stop()
        thread.join()


def wait_for(look: Callable[[], str], what: str) -> str:
    """What `look` finds at last."""
    end = time.monotonic() + PATIENCE
    while not (found := look()):
        assert time.monotonic() < end, what
        time.sleep(0.02)
    return found


def started(folder: Path, native: Path, address: object, **keys: str) -> None:
    """Begin a component at a server, and end it."""
    of = {"a": {"isolation": str(address), **keys}}
    system = read_system(folder, native, {"a": ("feedthrough2", "1 ms", {"=u": 1.5})}, of=of)
    start(system.components["a"]).close()
