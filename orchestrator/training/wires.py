"""What an agent sets and sees in a session: looked up once, then read from cells and written to the FMUs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from ..errors import InputError
from ..plan.plan import Plan
from ..plan.schedule.layout import Key
from ..run.memory.ports import cell_of
from ..run.stepping.stepping import Stepping
from .signals import Signal


def observed_names(plan: Plan, names: Sequence[str]) -> tuple[str, ...]:
    """Those of some signals that the loop is to read: outputs and locals; others it has, or nothing changes them."""

    def read(name: str) -> bool:
        owner, variable = key_of(name)
        component = plan.system.components.get(owner)
        return component is not None and component.fmu.variables[variable].causality in ("output", "local")

    return tuple(dict.fromkeys(name for name in names if read(name)))


def key_of(name: str) -> Key:
    """Component and variable of a full name."""
    component, _, variable = name.partition(".")
    return component, variable


class Wires:
    """Between an agent and a session, as long as that is open. Same bits as its `set` and `get`."""

    def __init__(self, session: Stepping, actions: Sequence[Signal], observations: Sequence[Signal]) -> None:
        self.session, self.signals = session, actions
        self._setters = [(s.low, s.high, session.writer(s.name)) for s in actions]
        cells = [cell_of(session.plan, session.memory, key_of(s.name)) for s in observations]
        self.observe: Callable[[], np.ndarray]
        if None in cells:
            self.observe = partial(_gathered, [session.reader(s.name) for s in observations])
        else:
            z, at = session.memory.z, np.array(cells, dtype=np.intp)
            self.observe = lambda: z[at]

    def set(self, action: object) -> list[float]:
        """Set the actions, and give them as numbers. Raises InputError for what is no such vector or out of bounds;
        nothing is set then."""
        given = np.asarray(action, dtype=np.float64)
        values: list[float] = given.tolist()
        if given.ndim != 1 or len(values) != len(self._setters):
            names = ", ".join(s.name for s in self.signals)
            raise InputError(f"the action has the shape {given.shape}, not ({len(self._setters)},): {names}")
        for value, (low, high, _) in zip(values, self._setters, strict=True):
            if not low <= value <= high:
                raise self._outside(values)
        for value, (_, _, write) in zip(values, self._setters, strict=True):
            write(value)
        return values

    def _outside(self, values: list[float]) -> InputError:
        pairs = zip(values, self.signals, strict=True)
        value, s = next((v, s) for v, s in pairs if not s.low <= v <= s.high)
        return InputError(
            f"action {s.name} = {value:g} {s.unit}: {s.low:g} to {s.high:g} are allowed "
            f"(gymnasium.wrappers.ClipAction clips)"
        )

    def reader(self, name: str) -> Callable[[], Any]:
        """What reads a signal by its name, or `time` [s]."""
        if name == "time":
            return lambda: self.session.time
        return self.session.reader(name)


def _gathered(readers: list[Callable[[], Any]]) -> np.ndarray:
    return np.array([read() for read in readers], dtype=np.float64)
