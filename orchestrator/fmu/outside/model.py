"""What a participant that is no FMU does, as an object: it is given values by name, steps, and gives values by name."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from ...errors import FmuError


class StepFailedError(FmuError):
    """Why a step failed, in words that need no more than who and when, which are added."""


class Model:
    """To be inherited from. `values`: those of all variables by name, in the types that are declared.

    Methods may return a status of FMI (`participant.lifecycle`): None is OK. An exception is Error; its text is kept
    as what it has logged, that of StepFailedError is the message of the run that ends with it.
    """

    def __init__(self, starts: Mapping[str, Any]) -> None:
        self.values: dict[str, Any] = dict(starts)

    def told(self, action: str, *what: Any) -> None:
        """Every call, before it is done: for those who look on."""
        return

    def set_up(self, start: float, stop: float | None) -> None:
        """The run goes from `start` to `stop` [s], if that is known; the first call of all. What is opened here is
        closed in `close`."""
        return

    def set(self, values: Mapping[str, Any]) -> int | None:
        self.values.update(values)
        return None

    def get(self, names: Iterable[str]) -> list[Any]:
        return [self.values[name] for name in names]

    def initialized(self) -> int | None:
        """Parameters and inputs have their values of the start; outputs that depend on them are to be known now."""
        return None

    def step(self, time: float, length: float) -> int | None:
        """Go on from `time` over `length` [s]; to be written."""
        return None

    def save(self) -> Any:
        """Its state, which nobody else changes; where the description says that it can be saved."""
        return dict(self.values)

    def restore(self, state: Any) -> None:
        """As it was when `state` was saved, which stays as it is."""
        self.values = dict(state)

    def written(self, state: Any) -> bytes:
        """A saved state for the disk; where the description says that it can be written."""
        return json.dumps(state).encode()

    def read(self, content: bytes) -> Any:
        """What was written, as a state to restore. Raises ValueError if it is none."""
        return json.loads(content)

    def why_failed(self) -> str:
        """What went wrong in the last step, where more is to be said than the text of its exception."""
        return ""

    def notes(self) -> list[str]:
        """What a run must tell of it at its end."""
        return []

    def machine_code(self) -> Mapping[str, int] | None:
        """Addresses of functions of FMI 2.0 by their names, which are called in place of this object, and of its
        instance (`pointer`), where it has such."""
        return None

    def close(self) -> None:
        """Give back what it holds; called once."""
        return
