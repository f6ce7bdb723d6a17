"""The process of one FMU that is served: what it is told comes over a connection, and so do the values.

python -m rovbrush.orchestrator.participant.elsewhere.served SERVER_PID CONNECTION FMU DIGEST NAME
"""

from __future__ import annotations

import os
import socket
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...processes import end_with, watch
from ..base import CallError
from ..isolated.channel import CALL, LONGEST, STATUS, ChannelBrokenError, ChannelClosedError, aside
from ..isolated.child import Served
from ..isolated.memory import Unshared
from ..lifecycle import good
from . import passing
from .connection import LENGTH
from .wire import Wire

SHARED = "share"  # in place of a descriptor, where sockets have none: what Windows needs comes by the standard input
NOT_UNDERSTOOD = 64  # exit code: what came is no message of a master
HANDLES = ("restore", "forget", "serialize")  # what is called by the handle of a state


def main(arguments: list[str]) -> None:
    """Serve until the connection closes."""
    if os.name == "posix":
        server = int(arguments[0])
        end_with(server)
        watch(server)
        connection = socket.socket(fileno=aside(int(arguments[1])))
    else:
        connection = socket.fromshare(sys.stdin.buffer.read())  # type: ignore[attr-defined]
    code = 0
    try:
        with suppress(ChannelClosedError):
            ServedElsewhere(Path(arguments[2]), arguments[3], arguments[4], Unshared()).answer(
                Wire(connection, LONGEST)
            )
    except ChannelBrokenError:
        code = NOT_UNDERSTOOD
    sys.stdout.flush()
    os._exit(code)  # the libraries of some FMUs crash when they are taken down


class ServedElsewhere(Served):
    """Nothing that a master says reaches beyond the memory, and no state is touched that was not saved here."""

    states: set[int] = set()  # noqa: RUF012 (there is one instance in the process)

    def called(self, body: bytes) -> bytes:
        if len(body) < CALL.size or self.instance is None:
            raise ChannelBrokenError
        head, content = body[: CALL.size], body[CALL.size :]
        number, references, values, *_ = CALL.unpack(head)
        if number >= len(self.functions):
            raise ChannelBrokenError
        function = self.functions[number]
        try:
            passing.put_call(function, references, values, content, self.shared, self.instance.fmu.version)
        except passing.NotFittingError:
            raise ChannelBrokenError from None
        if function.kind in HANDLES and int.from_bytes(content, "little") not in self.states:
            raise ChannelBrokenError
        status = self.function(head)
        found = passing.of_answer(function, values, self.shared) if good(status) else b""
        if function.kind == "save":
            self.states.add(int.from_bytes(found, "little"))
        return STATUS.pack(status) + LENGTH.pack(len(found)) + found

    def by_name(self, what: str, *values: Any) -> Any:
        if what in HANDLES:
            self._require_saved(int(values[0]))
        found = super().by_name(what, *values)
        if what in ("save", "deserialize"):
            self.states.add(int(found))
        return found

    def _require_saved(self, state: int) -> None:
        if state not in self.states:
            raise CallError("a state was named that was not saved here")


if __name__ == "__main__":
    main(sys.argv[1:])
