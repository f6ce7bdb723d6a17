"""`rovbrush serve`: FMUs for masters elsewhere, each instance in a process of its own that ends with its master."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

from ...errors import counted
from ...fmu.files.compiled import ASKED
from ...fmu.fmu import Fmu
from ...processes import end, how_ended, start
from ...sockets import Address, listening, prepared
from ..isolated.channel import Channel, ChannelClosedError, ChannelSilentError, to_json
from . import greeting
from .served import NOT_UNDERSTOOD, SHARED
from .wire import END, Wire

LOOK = 0.5  # s between two looks whether a master is still there
CLOSING = 2.0  # s that a process has to end when its master has gone
STRANGERS = 16  # connections that have not yet said who they are

Say = Callable[[str], object]


class Server:
    """Listens; `address` is where. `most`: instances at once. Raises InputError if it cannot listen."""

    def __init__(self, fmus: Sequence[Fmu], host: str, port: int, token: str, most: int, say: Say) -> None:
        self.fmus = {fmu.digest: fmu for fmu in fmus}
        self.token, self.most, self._say = token, most, say
        self._listener = listening(host, port, token)
        self.address = Address(*self._listener.getsockname()[:2])
        self._stopping = False
        self._lock = threading.Lock()
        self._taken = 0  # of `most`
        self._strangers = threading.Semaphore(STRANGERS)
        self._running: dict[subprocess.Popen[bytes], Wire] = {}

    def serve(self) -> None:
        """Take connections until Ctrl-C or `stop`; then end what runs, and tell its masters."""
        self._listener.settimeout(LOOK)
        try:
            while not self._stopping:
                try:
                    connection, peer = self._listener.accept()
                except TimeoutError:
                    continue
                if not self._strangers.acquire(blocking=False):
                    connection.close()
                    continue
                who = str(Address(*peer[:2])).removeprefix("tcp://")
                threading.Thread(target=self._meet, args=(connection, who), daemon=True).start()
        finally:
            self._listener.close()
            with self._lock:
                running, self._running = self._running, {}
            for process, wire in running.items():
                process.kill()
                _tell_end(wire, "the server was stopped")

    def stop(self) -> None:
        """Let `serve` end, within half a second."""
        self._stopping = True

    def _meet(self, connection: socket.socket, who: str) -> None:
        """Greet a connection, and serve it to its end."""
        wire = Wire(prepared(connection), greeting.LONGEST)
        reserved: list[bool] = []

        def reserve() -> str:
            with self._lock:
                if self._taken >= self.most:
                    return f"it runs {counted(self.most, 'instance')} already; --most allows more"
                self._taken += 1
            reserved.append(True)
            return ""

        known = False
        try:
            served = {digest: fmu.path.name for digest, fmu in self.fmus.items()}
            guest = greeting.welcome(wire, self.token, served, reserve)
            known = True
            self._strangers.release()
            self._run(wire, guest, who)
        except greeting.RefusedError as why:
            self._say(f"refused {who}: {why}")
        except OSError as error:
            self._say(f"lost {who}: {error}")
        finally:
            wire.close()
            if not known:
                self._strangers.release()
            with self._lock:
                self._taken -= len(reserved)

    def _run(self, wire: Wire, guest: greeting.Guest, who: str) -> None:
        fmu = self.fmus[guest.digest]
        process = self._started(wire.socket, fmu, guest)
        with self._lock:
            self._running[process] = wire
        self._say(f"{fmu.path.name} runs for {who} as component {guest.component}")
        begun = time.monotonic()
        while process.poll() is None:
            if _gone(wire.socket):
                end(process, CLOSING)
                break
            with suppress(subprocess.TimeoutExpired):
                process.wait(LOOK)
        with self._lock:
            told = self._running.pop(process, None)
        if told is None:  # the server is being stopped
            return
        code = process.returncode
        how = f"its process {how_ended(code)}" if code else ""
        how = "what came is no call of a master" if code == NOT_UNDERSTOOD else how
        if code:
            _tell_end(wire, how)
        after = f"{time.monotonic() - begun:.1f} s"
        self._say(f"component {guest.component} of {who} ended after {after}{how and f': {how}'}")

    def _started(self, connection: socket.socket, fmu: Fmu, guest: greeting.Guest) -> subprocess.Popen[bytes]:
        here = os.name == "posix"
        place = str(connection.fileno()) if here else SHARED
        command = [sys.executable, "-m", f"{__package__}.served", str(os.getpid()), place]
        command += [str(fmu.path), fmu.digest, guest.component]
        environment = os.environ | {ASKED: "1"} if fmu.own.compiled else None
        if here:
            return start(
                command, pass_fds=(connection.fileno(),), stdin=subprocess.DEVNULL, start_new_session=True,
                env=environment,
            )  # fmt: skip
        process = start(command, stdin=subprocess.PIPE, env=environment)
        assert process.stdin is not None
        process.stdin.write(connection.share(process.pid))  # type: ignore[attr-defined]
        process.stdin.close()
        return process


def _gone(connection: socket.socket) -> bool:
    """Whether the other side has closed, or has not been heard of for half a minute; what came is left there."""
    try:
        return not connection.recv(1, socket.MSG_PEEK)
    except BlockingIOError:
        return False
    except OSError:
        return True


def _tell_end(channel: Channel, how: str) -> None:
    """Tell a master how the process that it speaks to has ended, if it is there."""
    with suppress(ChannelClosedError, ChannelSilentError):
        channel.send(END, to_json(how), 0, time.monotonic() + CLOSING)
    channel.close()
