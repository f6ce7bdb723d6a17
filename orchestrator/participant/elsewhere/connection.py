"""An FMU at a server as its master sees it, in the place of a process of this machine."""

from __future__ import annotations

import os
import socket
import struct
from collections.abc import Callable
from contextlib import suppress

from ...errors import FmuError, InputError
from ...files import typed
from ...fmu.fmu import Fmu
from ...sockets import SHORTEST_TOKEN, Address, prepared, tcp_address
from ...system.component import Component
from ..isolated.channel import (
    CALL,
    LONGEST,
    STATUS,
    ChannelBrokenError,
    ChannelClosedError,
    ChannelSilentError,
    from_json,
)
from ..isolated.child_process import ProcessLostError
from ..isolated.functions import functions
from ..isolated.memory import Shared, Unshared
from ..isolated.parent import Peer
from ..lifecycle import good
from . import greeting, passing
from .wire import END, Wire

LENGTH = struct.Struct("<I")  # bytes of an answer that belong into the memory
CONNECTING = 10.0  # s
TOKEN = "ROVBRUSH_TOKEN"


def at_server(component: Component) -> Callable[[Fmu, str], Peer]:
    """How to begin a component at the server that its system names. Raises InputError for a token that is none."""
    token = token_of(component.token_file, f"component {component.name}: token_file")
    address = tcp_address(component.isolation)
    return lambda fmu, name: Connection(fmu, name, address, token)


def token_of(file: str | os.PathLike[str], label: str, stated: str = "") -> str:
    """The token in a file, or one that is stated, or that of the environment; empty where there is none.

    Raises InputError for a file that cannot be read, or a token that is too short.
    """
    token, where = stated or os.environ.get(TOKEN, ""), TOKEN if not stated else "--token"
    if file:
        try:
            with open(file, encoding="utf-8") as found:
                token, where = found.read(LONGEST_FILE).strip(), f"{label} = {str(file)!r}"
        except (OSError, UnicodeDecodeError) as error:
            why = getattr(error, "strerror", "") or error
            raise InputError(f"{label} = {str(file)!r} cannot be read: {why}") from None
        if not token:
            raise InputError(f"{where}: the file is empty; {HOW}")
    if token and len(token) < SHORTEST_TOKEN:
        raise InputError(f"{where}: a token has at least {SHORTEST_TOKEN} characters, not {len(token)}; {HOW}")
    return token


LONGEST_FILE = 1 << 16
HOW = '`python -c "import secrets; print(secrets.token_urlsafe(24))"` makes one'


class Connection:
    """Connects and greets. Raises FmuError if the server is not there, or refuses."""

    def __init__(self, fmu: Fmu, name: str, address: Address, token: str) -> None:
        self.where, self._functions = str(address), functions(fmu.version)
        try:
            connected = socket.create_connection((address.host, address.port), CONNECTING)
        except OSError as error:
            why = error.strerror or str(error)
            raise FmuError(
                f"component {name}: nobody answers at {address} ({why}); start `rovbrush serve {typed(fmu.path.name)} "
                f"--port {address.port}` there"
            ) from None
        self.wire = Wire(prepared(connected), greeting.LONGEST)
        try:
            greeting.greet(self.wire, token, fmu.digest, fmu.path.name, name, self.where)
        except BaseException:
            self.wire.close()
            raise
        self.wire.longest = LONGEST
        self.shared: Shared = Unshared()

    def ask(self, letter: bytes, body: bytes, limit: float) -> bytes:
        """A message and the body of its answer, within `limit` [s]; values go both ways with it. Raises
        ProcessLostError if there is none; the connection has been closed then."""
        try:
            if letter != b"F":
                return self._answer(letter, body, limit)
            number, references, values, *_ = CALL.unpack(body)
            function = self._functions[number]
            answer = self._answer(letter, body + passing.of_call(function, references, values, self.shared), limit)
            at = STATUS.size + LENGTH.size
            if len(answer) < at:
                raise ChannelBrokenError
            (length,) = LENGTH.unpack_from(answer, STATUS.size)
            if good(int(STATUS.unpack_from(answer)[0])):
                passing.put_answer(function, values, answer[at : at + length], self.shared)
            return answer[: STATUS.size] + answer[at + length :]
        except ChannelSilentError:
            fault = f"the server at {self.where} did not answer within {limit:g} s, and the connection was closed"
        except (ChannelBrokenError, passing.NotFittingError):
            fault = f"the server at {self.where} sent what is no answer, and the connection was closed"
        except ChannelClosedError:
            fault = f"the connection to {self.where} broke: the server or its machine has gone, or the network"
        self.kill()
        raise ProcessLostError(fault)

    def _answer(self, letter: bytes, body: bytes, limit: float) -> bytes:
        answered, answer = self.wire.ask(letter, body, limit)
        if answered == END:
            with suppress(ValueError):
                found = from_json(answer)
                if isinstance(found, str):
                    self.kill()
                    raise ProcessLostError(f"{found[:500]} at {self.where}")
        if answered != letter or (letter == b"J" and not _is_answer(answer)):
            raise ChannelBrokenError
        return answer

    def kill(self) -> None:
        """Go away at once; the server ends the process."""
        self.wire.close()

    def close(self) -> None:
        self.wire.close()
        self.shared.close()

    def fell_down(self) -> str:
        """What becomes of the process is told at the server."""
        return ""


def _is_answer(content: bytes) -> bool:
    """Whether it answers a call by name: with a result or an error."""
    try:
        found = from_json(content)
    except (ValueError, TypeError, RecursionError):
        return False
    return isinstance(found, dict) and ("ok" in found or isinstance(found.get("error"), str))
