"""A participant in a run as the master sees it, whatever its FMI version and wherever it runs."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from ..errors import FmuError
from ..fmu.fmu import Fmu
from ..fmu.types import Value
from ..loop.last_step import length_to
from .lifecycle import OK, SECTION, STATUS, State, after, allowed, status_text, why_not_settable
from .messages import Logging, Messages

__all__ = ["STATUS", "CallError", "Participant", "State"]


ROUNDING = 1e-9  # of a step, by which its end may lie behind the stop without being meant to


class CallError(FmuError):
    """A call of an FMI function was refused; `status` is its answer, None where it was not made."""

    def __init__(self, text: str, status: int | None = None) -> None:
        super().__init__(text)
        self.status = status


class AskedToEndError(CallError):
    """A step behind which the FMU asks to end the simulation, which is its right."""


class Participant(ABC):
    """An instance with a guard between its faults and the run, and between the master and what FMI does not allow.

    Methods make calls by name, before and after the loop; the loop calls five functions by `address` with `pointer`:
    set, get, step, save and restore. `state` follows both: see `lifecycle.py`. After a fatal error nothing is called.
    """

    prefix: str  # of its functions: see lifecycle.PREFIX
    active: frozenset[str] = frozenset()  # clocks that tick in the present round of an event
    state_functions: tuple[str, str, str]  # names of those that save, restore and forget a state; empty in FMI 1.0

    def __init__(self, fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> None:
        self.fmu, self.name = fmu, name
        self.log = Messages(logging)
        self._tolerance = tolerance
        self.promised = math.inf  # s, the stop that it was told
        self.state = State.INSTANTIATED
        self.guarded = True
        self.missing: tuple[str, ...] = ()  # functions of FMI that its library lacks
        self.fault = ""  # what befell its process, where it has one of its own

    # --- what every kind of participant does in its own way ---

    @property
    @abstractmethod
    def pointer(self) -> int:
        """The component or instance that every FMI function takes first."""

    @abstractmethod
    def address(self, function: str) -> int:
        """Address of an FMI function, for the loop. Raises FmuError if the FMU does not have it."""

    def configure(self, values: Mapping[str, Value]) -> None:
        """Set structural parameters, by the FMU's own names, before all else (FMI 3.0)."""
        if values:
            raise CallError(f"component {self.name}: {self.fmu.path.name} has no structural parameters")

    @abstractmethod
    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        """Say that it will run from `start` to `stop` [s], if that is known, and with which tolerance; first of all."""

    def within(self, time: float, length: float) -> float:
        """The length of a step from `time` [s] that does not end behind the stop that was promised, by rounding."""
        if time + length > self.promised >= time + length * (1.0 - ROUNDING):
            return length_to(time, self.promised)
        return length

    @abstractmethod
    def set_own(self, values: Mapping[str, Value]) -> None:
        """Set variables by the FMU's own names."""

    @abstractmethod
    def get_own(self, name: str) -> Any:
        """Get one variable by the FMU's own name."""

    @abstractmethod
    def enter_initialization(self) -> None:
        """Enter initialization mode; it must have been set up."""

    @abstractmethod
    def exit_initialization(self) -> None:
        """Leave initialization mode; the FMU can be stepped then, and its outputs may have changed."""

    @abstractmethod
    def step(self, time: float, length: float) -> None:
        """A step from `time` [s] over `length` [s]; states saved before can be restored after it."""

    @abstractmethod
    def save(self) -> int:
        """Keep the FMU's whole state; a handle for `restore`, `forget` and `serialize`."""

    @abstractmethod
    def restore(self, state: int) -> None:
        """Go back to a kept state, which stays kept."""

    @abstractmethod
    def forget(self, state: int) -> None:
        """Give a kept state back."""

    @abstractmethod
    def serialize(self, state: int) -> bytes:
        """A kept state as bytes, for another process or another day."""

    @abstractmethod
    def deserialize(self, content: bytes) -> int:
        """A state from bytes, kept and ready for `restore`."""

    @property
    def events(self) -> Any:
        """Itself where it has events of its own: see `run.events.happenings.EventMode`; None where it has none."""
        return None

    def stopped(self) -> tuple[float, str] | None:
        """Where its last step ended [s] because of an event that is to be handled, and why; None where that was not so,
        or where what the step has written says it (FMI 3.0 for co-simulation)."""
        return None

    @abstractmethod
    def close(self) -> str:
        """End its life as its state allows: terminate, free. What went wrong in that; empty if nothing did."""

    # --- what all have in common ---

    @property
    def tolerance(self) -> float | None:
        """The relative tolerance of its solver: what was asked for, else what its maker had in mind, if anything."""
        if self._tolerance is not None:
            return self._tolerance
        experiment = self.fmu.description.defaultExperiment
        return float(experiment.tolerance) if experiment is not None and experiment.tolerance else None

    @property
    def messages(self) -> list[str]:
        """The last of what it has logged."""
        return list(self.log.recent)

    def look(self) -> None:
        """Let it say some more; called now and then while it is stepped, and never while a function of it runs."""
        return

    def logged(self) -> list[str]:
        """What it has logged, as lines of a file."""
        return self.log.lines(self.name)

    @property
    def dead(self) -> bool:
        """Whether nothing may be called any more."""
        return self.state in (State.DEAD, State.FREED)

    def noted(self, action: str, status: int) -> None:
        """A call that the loop made, and how it was answered."""
        self.state = after(action, self.state, status)

    @contextmanager
    def unguarded(self) -> Iterator[None]:
        """Calls that FMI does not allow, to see what the FMU makes of them."""
        self.guarded = False
        try:
            yield
        finally:
            self.guarded = True

    def require(self, action: str, what: str) -> None:
        """Raise FmuError where its state does not allow an action."""
        if self.dead:
            ended = self.fault or f"it is {self.state.value}"
            raise CallError(f"component {self.name}: cannot {what}: {ended}{self.log_text()}")
        if self.guarded and not allowed(self.fmu.version, action, self.state):
            raise CallError(
                f"component {self.name}: cannot {what} while it is {self.state.value} "
                f"({SECTION[self.fmu.version]}){self.log_text()}"
            )

    def require_settable(self, name: str) -> None:
        """Raise FmuError for a variable, by the FMU's own name, that cannot be set in its state."""
        why = why_not_settable(self.state, self.fmu.own.variables[name]) if self.guarded else ""
        if why:
            raise CallError(f"component {self.name}: cannot set {name}: {why}")

    def call(self, action: str, what: str, function: Any, *arguments: Any) -> Any:
        """Call if its state allows it; a bad status becomes an FmuError with the FMU's own words."""
        self.require(action, what)
        try:
            result = function(*arguments)
        except FmuError:
            raise
        except Exception as error:
            status = getattr(error, "status", None)
            reason = str(error) if status is None else status_text(self.prefix, status)
            if status is not None:
                self.noted(action, status)
            raise CallError(f"component {self.name}: cannot {what} ({reason}){self.reasons()}", status) from error
        self.noted(action, OK)
        return result

    def set_all(self, values: Mapping[str, Value]) -> None:
        """Set variables by name; those of a foreign FMU cross to its names, units and directions."""
        self.set_own({self.fmu.own_name(name): self.fmu.to_own(name, value) for name, value in values.items()})

    def set(self, name: str, value: Value) -> None:
        """Set one variable by name."""
        self.set_all({name: value})

    def get(self, name: str) -> Any:
        """Get one variable by name."""
        return self.fmu.from_own(name, self.get_own(self.fmu.own_name(name)))

    def begin(self, stop: float) -> None:
        """From new to initialization mode with nothing set, for a run from 0 to `stop` [s]."""
        self.set_up(stop)
        self.enter_initialization()

    def log_text(self) -> str:
        """What the FMU has logged, as the tail of an error message."""
        return self.log.text()

    def reasons(self) -> str:
        """The same for an error of the FMU's own making; how to learn more where it said nothing."""
        return self.log.advice(self.name) + self.log.text()

    def first_event(self) -> None:
        """What is done once all components have left initialization mode; nothing, for most."""
        return

    @property
    def speaker(self) -> Participant:
        """Who is behind the answer to its last step: itself, or another member of its group."""
        return self

    def solve_by(self, settings: Mapping[str, Any], goes_back: bool, rests_in_events: bool = False) -> None:
        """How its states are integrated, where it brings no solver and is in no group: see SolverSettings.
        `goes_back`: its state is saved at every step, and may be restored; `rests_in_events`: see Group."""
        return

    def notes(self) -> list[str]:
        """What a run must tell of it."""
        return []

    def forgets(self) -> str:
        """What a run that is taken up from its saved state does not go on with, in words."""
        return ""

    def why_failed(self) -> str:
        """What went wrong in its last step, where that is known better than by its status."""
        return ""

    def why_discarded(self) -> str:
        """What the FMU says about a step that it discarded; empty if it says nothing."""
        reached = self.reached()
        return f"; it reached t = {reached:.9g} s" if math.isfinite(reached) else ""

    def terminated(self) -> bool:
        """Whether it asks to end, behind a step that it discarded."""
        return False

    def reached(self) -> float:
        """The time [s] that it reached in a step that it discarded; -inf where it does not say."""
        return -math.inf

    def require_state(self) -> None:
        """Raise FmuError if the FMU cannot save its state."""
        if not self.fmu.can_save_state:
            raise FmuError(
                f"component {self.name}: {self.fmu.path.name} cannot save its state (canGetAndSetFMUState = false)"
            )
