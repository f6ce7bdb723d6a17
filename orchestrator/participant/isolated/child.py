"""The process of one isolated FMU: does what it is told until its pipe closes, and never outlives its master.

python -m rovbrush.orchestrator.participant.isolated.child PIPE_IN PIPE_OUT MEMORY MASTER_PID FMU DIGEST NAME
"""

from __future__ import annotations

import base64
import ctypes
import json
import os
import signal
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...fmu.fmu import Fmu
from ..base import Instance
from ..opening import load
from .channel import CALL, ChannelClosedError, Shared, put_pointers, receive, send, texts_at
from .functions import Function, functions

PR_SET_PDEATHSIG = 1


def main(arguments: list[str]) -> None:
    """Serve until the pipe closes."""
    pipe_in, pipe_out, memory, master = map(int, arguments[:4])
    _end_with(master)
    with suppress(ChannelClosedError):
        _serve(pipe_in, pipe_out, Shared(memory), Path(arguments[4]), arguments[5], arguments[6])
    sys.stdout.flush()
    os._exit(0)  # the libraries of some FMUs crash when they are taken down


def _end_with(master: int) -> None:
    """Let the system end this process when its master ends, whatever the FMU does then."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != master:
        os._exit(1)

    def watch() -> None:
        while os.getppid() == master:
            time.sleep(1.0)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def _serve(pipe_in: int, pipe_out: int, shared: Shared, path: Path, digest: str, name: str) -> None:
    served: _Served | None = None
    answer: dict[str, Any]
    while True:
        letter, body = receive(pipe_in)
        if letter == b"F":
            assert served is not None
            answer = {"status": served.function(body, shared)}
        else:
            try:
                what, *values = json.loads(body)
                if what == "start":
                    served = _Served(_open(path, digest, name))
                    answer = {"ok": served.instance.pointer}
                else:
                    assert served is not None
                    answer = {"ok": getattr(served, what)(*values)}
            except Exception as error:
                answer = {"error": str(error)}
        if served is not None:
            answer |= {"log": list(served.instance.messages), "dead": served.instance.dead}
            served.instance.messages.clear()
        send(pipe_out, letter, json.dumps(answer).encode())


def _open(path: Path, digest: str, name: str) -> Instance:
    fmu = Fmu.open(path)
    if fmu.digest != digest:
        raise ValueError(f"{path.name} has changed since the system was read; start again")
    return load(fmu, name)


class _Served:
    """An instance, and its functions by number."""

    def __init__(self, instance: Instance) -> None:
        self.instance = instance
        self.functions = functions(instance.fmu.version)
        self.loaded: dict[int, Any] = {}

    def function(self, body: bytes, shared: Shared) -> int:
        """An FMI function with references and values in the shared memory; the status."""
        number, references, values, time, length = CALL.unpack(body)
        function: Function = self.functions[number]
        if number not in self.loaded:
            self.loaded[number] = function.prototype(self.instance.address(function.name))
        native, pointer, at = self.loaded[number], self.instance.pointer, shared.values
        if function.kind == "step":
            ends = [1] if self.instance.fmu.version == 2 else [True, at, at + 1, at + 2, at + 8]
            return int(native(pointer, time, length, *ends))
        if function.kind in ("get_state", "free_state"):
            return int(native(pointer, at))
        if function.kind == "set_state":
            return int(native(pointer, ctypes.c_void_p.from_address(at).value))
        if function.text and function.kind == "set":
            put_pointers(at, shared.text_addresses(values))
        sizes = [values] if self.instance.fmu.version == 3 else []
        status = int(native(pointer, shared.references, references, at, *sizes))
        if function.text and function.kind == "get" and status <= 1 and not shared.put_texts(texts_at(at, values)):
            self.instance.messages.append("its texts are longer than the memory shared with it")
            return 3
        return status

    def set_all(self, values: dict[str, Any]) -> None:
        self.instance.set_all(values)

    def get(self, name: str) -> Any:
        return self.instance.get(name)

    def enter_initialization(self, stop: float) -> None:
        self.instance.enter_initialization(stop)

    def exit_initialization(self) -> None:
        self.instance.exit_initialization()

    def save(self) -> int:
        return self.instance.save()

    def restore(self, state: int) -> None:
        self.instance.restore(state)

    def forget(self, state: int) -> None:
        self.instance.forget(state)

    def serialize(self, state: int) -> str:
        return base64.b64encode(self.instance.serialize(state)).decode()

    def deserialize(self, content: str) -> int:
        return self.instance.deserialize(base64.b64decode(content))

    def why_discarded(self) -> str:
        return self.instance.why_discarded()

    def close(self, terminate: bool) -> None:
        self.instance.close(terminate)


if __name__ == "__main__":
    main(sys.argv[1:])
