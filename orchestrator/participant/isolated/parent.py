"""An FMU in a process of its own, as an instance like any other: what crashes there is an error here.

The addresses that the loop calls lead to functions of this process that pass references and values on through shared
memory; the loop does not know the difference, and gets the same bits.
"""

from __future__ import annotations

import base64
import ctypes
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ..base import Instance, Value
from .channel import (
    AT_REFERENCES,
    AT_VALUES,
    CALL,
    REFERENCES,
    SIZE,
    VALUES,
    ChannelClosedError,
    Shared,
    put_pointers,
    receive,
    send,
    texts_at,
)
from .functions import Function, functions

STARTING = 120.0  # s for Python and the FMU to start, at least
CLOSING = 2.0  # s
FATAL = 4


class IsolatedInstance(Instance):
    """Starts the process and instantiates the FMU there. Raises FmuError if that fails. `timeout` [s] for each call."""

    def __init__(self, fmu: Fmu, name: str, timeout: float) -> None:
        super().__init__(fmu, name)
        self.prefix = f"fmi{fmu.version}"
        state = "FMUstate" if fmu.version == 2 else "FMUState"
        self.state_functions = (f"{self.prefix}Get{state}", f"{self.prefix}Set{state}", f"{self.prefix}Free{state}")
        self.timeout = timeout
        self._callbacks: dict[str, Any] = {}
        with tempfile.TemporaryFile(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as memory:
            memory.truncate(SIZE)
            self.shared = Shared(memory.fileno())
            self._start(memory.fileno())
        try:
            self._pointer = int(self._by_name("start", limit=max(timeout, STARTING)))
        except FmuError as error:
            self._end()
            raise FmuError(str(error)) from None

    def _start(self, memory: int) -> None:
        to_child, self._out = os.pipe()
        self._in, from_child = os.pipe()
        ends = (to_child, from_child, memory)
        command = [sys.executable, "-m", f"{__package__}.child", *map(str, ends), str(os.getpid())]
        self.process = subprocess.Popen(
            [*command, str(self.fmu.path), self.fmu.digest, self.name],
            pass_fds=ends,
            stdin=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C is for the master
        )
        os.close(to_child)
        os.close(from_child)
        self._poll = select.poll()
        self._poll.register(self._in, select.POLLIN)

    @property
    def pointer(self) -> int:
        return self._pointer

    def _exchange(self, letter: bytes, body: bytes, limit: float) -> dict[str, Any]:
        """A message and its answer. Raises ChannelClosedError, with `fault` set, if the process is no more or hangs."""
        try:
            send(self._out, letter, body)
            if not self._poll.poll(1000 * limit):
                self.fault = f"its process did not answer within {limit:g} s and was ended"
                self.process.kill()
                raise ChannelClosedError
            answer: dict[str, Any] = json.loads(receive(self._in)[1])
        except ChannelClosedError:
            self.dead = True
            code = self.process.wait()
            self.fault = self.fault or _ended(code)
            raise
        self.messages.extend(answer.get("log", []))
        self.dead = self.dead or bool(answer.get("dead"))
        return answer

    def _by_name(self, what: str, *arguments: Any, limit: float = 0.0) -> Any:
        if self.dead:
            reason = self.fault or "after a fatal error"
            raise FmuError(f"component {self.name}: cannot {what.replace('_', ' ')}: {reason}{self.log_text()}")
        try:
            answer = self._exchange(b"J", json.dumps([what, *arguments]).encode(), limit or self.timeout)
        except ChannelClosedError:
            raise FmuError(
                f"component {self.name}: {self.fault} in the call `{what.replace('_', ' ')}`{self.log_text()}"
            ) from None
        if "error" in answer:
            raise FmuError(answer["error"])
        return answer["ok"]

    def address(self, function: str) -> int:
        if function not in self._callbacks:
            known = functions(self.fmu.version)
            number = next((k for k, f in enumerate(known) if f.name == function), None)
            if number is None:
                raise FmuError(f"component {self.name}: {function} cannot be called in a process of its own")
            self._callbacks[function] = known[number].prototype(self._callback(number, known[number]))
        return ctypes.cast(self._callbacks[function], ctypes.c_void_p).value or 0

    def _callback(self, number: int, function: Function) -> Any:
        """What the loop calls in place of an FMI function. It never raises: errors are the status Fatal."""
        shared = self.shared

        def remote(references: int = 0, values: int = 0, time: float = 0.0, length: float = 0.0) -> int:
            if self.dead:
                return FATAL
            try:
                answer = self._exchange(b"F", CALL.pack(number, references, values, time, length), self.timeout)
            except ChannelClosedError:
                return FATAL
            return int(answer["status"])

        def exchange(_instance: int, references: int, count: int, values: int, size: int | None = None) -> int:
            number_of_values = count if size is None else size
            room = function.size * number_of_values
            if 4 * count > REFERENCES or room > VALUES:
                self.fault = "it has more values than the memory shared with it can hold"
                return FATAL
            ctypes.memmove(shared.base + AT_REFERENCES, references, 4 * count)
            if function.kind == "set" and function.text:
                if not shared.put_texts(texts_at(values, number_of_values)):
                    self.fault = "its texts are longer than the memory shared with it"
                    return FATAL
            elif function.kind == "set":
                ctypes.memmove(shared.base + AT_VALUES, values, room)
            status = remote(count, number_of_values)
            if function.kind == "get" and status <= 1:
                if function.text:
                    put_pointers(values, shared.text_addresses(number_of_values))
                else:
                    ctypes.memmove(values, shared.base + AT_VALUES, room)
            return status

        def step(_instance: int, time: float, length: float, _no_set: int, *ends: int) -> int:
            status = remote(time=time, length=length)
            for end, at, size in zip(ends, (0, 1, 2, 8), (1, 1, 1, 8), strict=False):
                ctypes.memmove(end, shared.base + AT_VALUES + at, size)
            return status

        def state(_instance: int, value: int | None) -> int:
            cell = ctypes.c_void_p.from_address(shared.base + AT_VALUES)
            if function.kind == "set_state":
                cell.value = value
                return remote()
            outside = ctypes.c_void_p.from_address(value or 0)
            cell.value = outside.value
            status = remote()
            outside.value = cell.value
            return status

        return {"set": exchange, "get": exchange, "step": step}.get(function.kind, state)

    def set_own(self, values: Mapping[str, Value]) -> None:
        if values:
            self._by_name("set_all", dict(values))

    def get_own(self, name: str) -> Any:
        return self._by_name("get", name)

    def enter_initialization(self, stop: float) -> None:
        self._by_name("enter_initialization", stop)

    def exit_initialization(self) -> None:
        self._by_name("exit_initialization")

    def save(self) -> int:
        return int(self._by_name("save"))

    def restore(self, state: int) -> None:
        self._by_name("restore", state)

    def forget(self, state: int) -> None:
        self._by_name("forget", state)

    def serialize(self, state: int) -> bytes:
        return base64.b64decode(self._by_name("serialize", state))

    def deserialize(self, content: bytes) -> int:
        return int(self._by_name("deserialize", base64.b64encode(content).decode()))

    def why_discarded(self) -> str:
        return "" if self.dead else str(self._by_name("why_discarded"))

    def close(self, terminate: bool = True) -> None:
        if not self.dead:
            with suppress(FmuError):
                self._by_name("close", terminate)
        self.dead = True
        self._end()

    def _end(self) -> None:
        """End the process: it goes when its pipe closes, and is made to if it does not."""
        for pipe in (self._out, self._in):
            with suppress(OSError):
                os.close(pipe)
        self._out = self._in = -1
        try:
            self.process.wait(CLOSING)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


def _ended(code: int) -> str:
    """How a process ended, in words."""
    if code >= 0:
        return f"its process ended by itself with exit code {code}"
    name = signal.Signals(-code).name if -code in set(signal.Signals) else str(-code)
    words = {"SIGSEGV": " (it reached for memory that is not its own)", "SIGABRT": " (it gave up)"}.get(name, "")
    return f"its process crashed with {name}{words}"
