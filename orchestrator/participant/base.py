"""A running FMU as the master sees it, whatever its FMI version and wherever it runs."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Mapping
from typing import Any

from ..errors import FmuError
from ..fmu.fmu import Fmu

STATUS = {0: "OK", 1: "Warning", 2: "Discard", 3: "Error", 4: "Fatal", 5: "Pending"}
Value = float | int | bool | str


class Instance(ABC):
    """An instance with a guard between its faults and the run. After a fatal error it is never called again.

    Calls by name are for before and after the loop; the loop calls the functions by `address` with `pointer`.
    """

    prefix: str  # of its functions: fmi2, fmi3
    state_functions: tuple[str, str, str]  # names of those that save, restore and forget a state

    def __init__(self, fmu: Fmu, name: str) -> None:
        self.fmu, self.name = fmu, name
        self.messages: deque[str] = deque(maxlen=50)  # an FMU may warn at every step
        self.dead = False
        self.fault = ""  # what befell its process, where it has one of its own

    @property
    @abstractmethod
    def pointer(self) -> int:
        """The component or instance that every FMI function takes first."""

    @abstractmethod
    def address(self, function: str) -> int:
        """Address of an FMI function, for the loop. Raises FmuError if the FMU does not have it."""

    @abstractmethod
    def set_own(self, values: Mapping[str, Value]) -> None:
        """Set variables by the FMU's own names."""

    @abstractmethod
    def get_own(self, name: str) -> Any:
        """Get one variable by the FMU's own name."""

    @abstractmethod
    def enter_initialization(self, stop: float) -> None:
        """From set up to initialization mode, for a run from 0 to `stop` [s]."""

    @abstractmethod
    def exit_initialization(self) -> None:
        """Leave initialization mode; the FMU can be stepped then."""

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

    @abstractmethod
    def close(self, terminate: bool = True) -> None:
        """Terminate and free the instance."""

    def set_all(self, values: Mapping[str, Value]) -> None:
        """Set variables by name; those of a foreign FMU cross to its names, units and directions."""
        own = {}
        for name, value in values.items():
            crossing = self.fmu.crossings.get(name)
            own[crossing.name if crossing else name] = (
                crossing.there(value) if crossing and isinstance(value, float) else value
            )
        self.set_own(own)

    def set(self, name: str, value: Value) -> None:
        """Set one variable by name."""
        self.set_all({name: value})

    def get(self, name: str) -> Any:
        """Get one variable by name."""
        crossing = self.fmu.crossings.get(name)
        value = self.get_own(crossing.name if crossing else name)
        return crossing.back(value) if crossing and isinstance(value, float) else value

    def log_text(self) -> str:
        """What the FMU has logged, as the tail of an error message."""
        return "".join(f"\n{message}" for message in dict.fromkeys(self.messages))

    def call(self, what: str, function: Any, *arguments: Any) -> Any:
        """Call before or after the loop; a bad status becomes an FmuError with the FMU's own words."""
        if self.dead:
            raise FmuError(f"component {self.name}: cannot {what} after a fatal error{self.log_text()}")
        try:
            return function(*arguments)
        except FmuError:
            raise
        except Exception as error:
            status = getattr(error, "status", None)
            self.dead = status == 4
            reason = f"{self.prefix}{STATUS.get(status, status)}" if status is not None else str(error)
            raise FmuError(f"component {self.name}: cannot {what} ({reason}){self.log_text()}") from error

    def why_discarded(self) -> str:
        """What the FMU says about a step that it discarded; empty if it says nothing."""
        return ""

    def require_state(self) -> None:
        """Raise FmuError if the FMU cannot save its state."""
        if not self.fmu.can_save_state:
            raise FmuError(
                f"component {self.name}: {self.fmu.path.name} cannot save its state (canGetAndSetFMUState = false)"
            )


def refused(fmu: Fmu, name: str, error: Exception, log: str) -> FmuError:
    """The error of an FMU that cannot be instantiated."""
    tool = ""
    if fmu.interface.needsExecutionTool:
        made = fmu.description.generationTool or "the tool that made it"
        tool = f"; it needs {made} on this machine, installed and licensed (needsExecutionTool = true)"
    return FmuError(f"component {name}: {fmu.path.name} cannot be instantiated: {error}{tool}{log}")
