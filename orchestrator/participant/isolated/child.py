"""The process of one isolated FMU: does what it is told until its pipe closes, and never outlives its master.

python -m rovbrush.orchestrator.participant.isolated.child PIPE_IN PIPE_OUT MEMORY MASTER_PID FMU DIGEST NAME
"""

from __future__ import annotations

import ctypes
import json
import os
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...fmu.fmu import Fmu
from ...fmu.kinds import MODEL_EXCHANGE
from ...processes import end_with, watch
from ..base import AskedToEndError, CallError, State
from ..here.loaded import LoadedInstance
from ..lifecycle import ERROR
from ..opening import load
from .channel import CALL, ENDS, STATUS, Channel, ChannelClosedError, aside, from_json, to_json
from .child_events import EVENTS, at_event, eventful
from .child_exchange import Inputs
from .functions import Function, functions
from .memory import Shared, bytes_at, put_pointers, texts_at

BY_NAME = ("configure", "set_all", "get", "set_up", "enter_initialization", "exit_initialization", "step", "save",
           "restore", "forget", "serialize", "deserialize", "terminated", "reached", "look", "solve_by",
           "notes", "forgets", "why_failed", "close")  # fmt: skip

LOOK = 0.1  # s between two looks at what the FMU may log


def main(arguments: list[str]) -> None:
    """Serve until the pipe closes."""
    pipe_in, pipe_out, memory, master = map(int, arguments[:4])
    end_with(master)
    watch(master)
    channel = Channel(aside(pipe_in), aside(pipe_out))
    with suppress(ChannelClosedError):
        Served(Path(arguments[4]), arguments[5], arguments[6], Shared(memory)).answer(channel)
    sys.stdout.flush()
    os._exit(0)  # the libraries of some FMUs crash when they are taken down


class Served:
    """An instance, and its functions by number."""

    def __init__(self, path: Path, digest: str, name: str, shared: Shared) -> None:
        self.path, self.digest, self.name, self.shared = path, digest, name, shared
        self.instance: LoadedInstance | None = None
        self.look_at = 0.0  # when more messages may be said, of time.monotonic
        self.functions: list[Function] = []
        self.loaded: dict[int, Any] = {}
        self.told: State | None = None  # the state that the master knows
        self.inputs = Inputs(shared)

    def answer(self, channel: Channel) -> None:
        """Messages as they come."""
        while True:
            number, letter, body = channel.receive()
            if letter == b"F":
                called = self.called(body)
                news = self.news(asked=False)
                channel.send(letter, called + json.dumps(news).encode() if news else called, number)
                continue
            try:
                answer: dict[str, Any] = {"ok": self.by_name(*from_json(body))}
            except Exception as error:
                answer = {"error": str(error), "status": getattr(error, "status", None)}
                answer |= {"ends": True} if isinstance(error, AskedToEndError) else {}
            channel.send(letter, to_json(answer | self.news(asked=True)), number)

    def news(self, asked: bool) -> dict[str, Any]:
        """What the master must know of the instance: messages, and its state where that has changed. `asked`: by
        name, when there is time to say how many messages were not read too."""
        found: dict[str, Any] = {}
        if self.instance is not None:
            if time.monotonic() > self.look_at:
                self.look_at = time.monotonic() + LOOK
                self.instance.look()
            if self.instance.unread and asked:
                found["unread"] = self.instance.unread
            if self.instance.log.kept:
                found["log"] = self.instance.log.kept
                self.instance.log.kept = []
            if self.instance.state is not self.told:
                self.told = self.instance.state
                found["state"] = self.told.name
        return found

    def by_name(self, what: str, *values: Any) -> Any:
        """A method of the instance."""
        if what == "start":
            kind, clocks, *wanted = values
            fmu = Fmu.open(self.path).of_kind(kind)
            if fmu.digest != self.digest:
                raise ValueError(f"{self.path.name} has changed since the system was read; start again")
            self.instance = (
                load(fmu, self.name, *wanted) if clocks is None else eventful(fmu, self.name, clocks, *wanted)
            )
            self.functions = functions(fmu.version)
            return [self.instance.pointer, self.instance.missing]
        if what in EVENTS:
            return at_event(self.instance, what, *values)
        if self.instance is None or what not in BY_NAME:
            raise CallError(f"{what} cannot be called in a process of its own")
        return getattr(self.instance, what)(*values)

    def called(self, body: bytes) -> bytes:
        """The answer to a call of a function, before what is new of the instance."""
        return STATUS.pack(self.function(body))

    def function(self, body: bytes) -> int:
        """An FMI function with references and values in the shared memory; the status."""
        number, references, values, time, length, final = CALL.unpack(body)
        function, instance = self.functions[number], self.instance
        assert instance is not None
        if number not in self.loaded:
            self.loaded[number] = function.prototype(instance.address(function.name))
        native, pointer, at = self.loaded[number], instance.pointer, self.shared.values
        version, kind = instance.fmu.version, function.kind
        if kind == "step":
            ends = [final, at, at + 1, at + 2, at + 8] if version == 3 else [int(final)]
            ctypes.memset(at, 0, ENDS)  # some FMUs write only what they have to report
            status = native(pointer, time, length, *ends)
        elif kind in ("save", "forget"):
            status = native(pointer, at)
        elif kind == "restore":
            status = native(pointer, ctypes.c_void_p.from_address(at).value)
        elif function.binary:
            status = self.exchange_bytes(function, native, references, values)
        else:
            if function.text and kind == "set":
                put_pointers(at, self.shared.text_addresses(values))
            if kind == "set" and instance.fmu.kind == MODEL_EXCHANGE:
                self.inputs.look(instance, function, references, values)
            sizes = [values] if version == 3 else []
            status = native(pointer, self.shared.references, references, at, *sizes)
            if function.text and kind == "get" and status in (0, 1) and not self.shared.put_texts(texts_at(at, values)):
                instance.log.add(ERROR, "", "its texts are longer than the memory shared with it")
                return 3
        instance.noted(kind, int(status))
        return int(status)

    def exchange_bytes(self, function: Function, native: Any, references: int, count: int) -> int:
        """fmi3SetBinary and fmi3GetBinary: sizes in the shared values, pointers behind them."""
        shared, instance = self.shared, self.instance
        assert instance is not None
        sizes, pointers = shared.values, shared.values + 8 * count
        if function.kind == "set":
            put_pointers(pointers, shared.byte_addresses(count)[1])
        status = int(native(instance.pointer, shared.references, references, sizes, pointers, count))
        if function.kind == "get" and status in (0, 1) and not shared.put_bytes(bytes_at(sizes, pointers, count)):
            instance.log.add(ERROR, "", "its bytes are more than the memory shared with it can hold")
            return ERROR
        return status


if __name__ == "__main__":
    main(sys.argv[1:])
