"""An FMU in a process of its own, as an instance like any other: what crashes there is an error here.

The addresses that the loop calls lead to functions of this process that pass references and values on through shared
memory; the loop does not know the difference, and gets the same bits.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, Protocol

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...fmu.sharing import made_by_pythonfmu
from ...fmu.types import Value
from ..base import AskedToEndError, CallError, Participant, State
from ..lifecycle import FATAL, PREFIX, STATE_FUNCTIONS
from ..messages import Logging
from .callbacks import Callbacks
from .channel import STATUS, from_json, to_json
from .child_process import ChildProcess, ProcessLostError
from .memory import Shared

# s for Python and the FMU to start and, where it is Python too, to compile until its first step is done
STARTING = 120.0
SHOWN = {  # what a call is in messages, where its name does not say it
    "close": "terminate or free", "happen": "activate clocks", "activate": "activate clocks",
    "ticking": "ask which clocks tick", "update": "update discrete states", "leave_event_mode": "enter step mode",
    "run_next": "activate a partition", "known": "ask for its next event",
}  # fmt: skip


class Peer(Protocol):
    """Where the FMU runs: a process of this machine, or a server's behind a connection."""

    @property
    def shared(self) -> Shared:
        """The memory through which the loop's values go."""
        ...

    def ask(self, letter: bytes, body: bytes, limit: float) -> bytes:
        """A message and the body of its answer, within `limit` [s]. Raises ProcessLostError if there is none."""
        ...

    def kill(self) -> None:
        """Give it up at once."""
        ...

    def close(self) -> None:
        """End it; the memory is no more then."""
        ...

    def fell_down(self) -> str:
        """How it ended when it was closed, where that was not well."""
        ...


class IsolatedInstance(Participant):
    """Starts the process and instantiates the FMU there. Raises FmuError if that fails. `timeout` [s] for each call.

    `begin`: how to start the process, where it is not one of this machine.
    """

    def __init__(
        self, fmu: Fmu, name: str, timeout: float, logging: Logging = "all", tolerance: float | None = None,
        begin: Callable[[Fmu, str], Peer] | None = None,
    ) -> None:  # fmt: skip
        super().__init__(fmu, name, logging, tolerance)
        self._unread = 0  # messages that the process has counted only
        self.prefix = PREFIX[fmu.version]
        self.state_functions = STATE_FUNCTIONS[fmu.version]
        self.timeout = timeout
        self.compiles = made_by_pythonfmu(fmu)  # perhaps, until its first step
        self.child = begin(fmu, name) if begin else ChildProcess(fmu, name)
        self._callbacks = Callbacks(fmu.version, self.child.shared, self._function, self.fault_here, self.broken_off)
        try:
            started = self._by_name("start", fmu.kind, self.clocks, logging, tolerance, limit=max(timeout, STARTING))
        except FmuError as error:
            self.child.close()
            raise FmuError(str(error)) from None
        self._pointer, self.missing = int(started[0]), tuple(started[1])

    @property
    def clocks(self) -> Mapping[str, str] | None:
        """Intervals that are chosen for it [s], where its events are handled; see `events.IsolatedEvents`."""
        return None

    @property
    def pointer(self) -> int:
        return self._pointer

    def address(self, function: str) -> int:
        found = self._callbacks.address(function)
        if not found:
            raise FmuError(f"component {self.name}: {function} cannot be called in a process of its own")
        return found

    # --- calls ---

    @property
    def limit(self) -> float:
        """How long a call may take [s]."""
        return max(self.timeout, STARTING) if self.compiles else self.timeout

    def _ask(self, letter: bytes, body: bytes, limit: float) -> bytes:
        """A message and the body of its answer. Raises ProcessLostError, with `fault` set, if there is none."""
        try:
            return self.child.ask(letter, body, limit)
        except ProcessLostError as error:
            self._lost(str(error))
            raise

    def _lost(self, fault: str) -> None:
        """What befell the process; the first counts. It is no more then."""
        self.fault = self.fault or fault
        self.state = State.DEAD

    def broken_off(self, error: type[BaseException]) -> None:
        """An exception came while the loop waited for a call: nobody knows what became of that."""
        ctrl_c = issubclass(error, KeyboardInterrupt)
        self._lost(f"its call was broken off by {'a second Ctrl-C' if ctrl_c else error.__name__}")
        self.child.kill()

    def _news(self, found: dict[str, Any]) -> None:
        for message in found.get("log", ()):
            self.log.add(*message)
        self._unread = found.get("unread", self._unread)
        if "state" in found:
            self.state = State[found["state"]]

    def _function(self, kind: str, body: bytes) -> int:
        """A call of the loop: its status. Whatever goes wrong is Fatal, with `fault` set."""
        if self.dead:
            return FATAL
        try:
            answer = self._ask(b"F", body, self.limit)
        except ProcessLostError:
            return FATAL
        if len(answer) > STATUS.size:
            self._news(json.loads(answer[STATUS.size :]))
        if kind == "step":
            self.compiles = False
        return int(STATUS.unpack_from(answer)[0])

    def fault_here(self, fault: str) -> int:
        """Something that cannot be passed on; Fatal."""
        self.fault = fault
        return FATAL

    def _by_name(self, what: str, *arguments: Any, limit: float = 0.0) -> Any:
        shown = SHOWN.get(what, what.replace("_", " "))
        if self.dead:
            reason = self.fault or f"it is {self.state.value}"
            raise CallError(f"component {self.name}: cannot {shown}: {reason}{self.log_text()}")
        try:
            answer = from_json(self._ask(b"J", to_json([what, *arguments]), limit or self.limit))
        except ProcessLostError:
            raise CallError(f"component {self.name}: {self.fault} in the call `{shown}`{self.log_text()}") from None
        self._news(answer)
        if "error" in answer:
            raise (AskedToEndError if answer.get("ends") else CallError)(answer["error"], answer.get("status"))
        return answer["ok"]

    def configure(self, values: Mapping[str, Value]) -> None:
        if values:
            self._by_name("configure", dict(values))

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self._by_name("set_up", stop, start)

    def set_own(self, values: Mapping[str, Value]) -> None:
        if values:
            self._by_name("set_all", dict(values))

    def get_own(self, name: str) -> Any:
        return self._by_name("get", name)

    def enter_initialization(self) -> None:
        self._by_name("enter_initialization")

    def exit_initialization(self) -> None:
        self._by_name("exit_initialization")

    def step(self, time: float, length: float) -> None:
        self._by_name("step", time, length)
        self.compiles = False

    def save(self) -> int:
        return int(self._by_name("save"))

    def restore(self, state: int) -> None:
        self._by_name("restore", state)

    def forget(self, state: int) -> None:
        self._by_name("forget", state)

    def serialize(self, state: int) -> bytes:
        return bytes(self._by_name("serialize", state))

    def deserialize(self, content: bytes) -> int:
        return int(self._by_name("deserialize", content))

    def terminated(self) -> bool:
        return not self.dead and bool(self._by_name("terminated"))

    def reached(self) -> float:
        return -math.inf if self.dead else float(self._by_name("reached"))

    def solve_by(self, settings: Mapping[str, Any], goes_back: bool, rests_in_events: bool = False) -> None:
        self._by_name("solve_by", dict(settings), goes_back, rests_in_events)

    def notes(self) -> list[str]:
        return list(self._asked("notes") or ())

    def forgets(self) -> str:
        return str(self._asked("forgets") or "")

    def why_failed(self) -> str:
        return str(self._asked("why_failed") or "")

    def _asked(self, what: str) -> Any:
        """What it says of itself; None where it says nothing any more."""
        with suppress(FmuError):
            return None if self.dead else self._by_name(what)
        return None

    def logged(self) -> list[str]:
        if not self.dead:
            with suppress(FmuError):  # the last count, and what was not yet passed on
                self._by_name("look")
        return self.log.lines(self.name, self._unread)

    # --- the end ---

    def close(self) -> str:
        said = ""
        if not self.dead:
            try:
                said = self._by_name("close")
            except FmuError as error:
                said = str(error)
        self.child.close()
        if not said and self.state is State.FREED and (fall := self.child.fell_down()):
            said = f"component {self.name}: {fall}"
        self.state = State.FREED
        return said
