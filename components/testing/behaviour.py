"""Behaviour tests: what a component does on its interface, whoever made it, as functions of a unit under test.

A test is a function `test_claim(unit)` whose docstring is the claim. It uses inputs, outputs and parameters only, takes
parameter values from the unit, and fails by AssertionError. Anything with the few methods of `Unit` can be tested: a
kernel, or an FMU that somebody else sent. What the unit lacks ends the test there, as not applicable.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np


class Running(Protocol):
    """One instance, initialized, with its time at 0. Values are floats, arrays for variables with a size."""

    def set(self, **inputs: Any) -> None: ...
    def step(self, h: float) -> None: ...
    def __getitem__(self, name: str) -> Any: ...
    def save(self) -> Any: ...
    def restore(self, state: Any) -> None: ...


class Unit(Protocol):
    """What is tested. `tolerance` is the relative error granted to its solver on top of a test's own bound."""

    tolerance: float

    def supports(self, name: str) -> bool: ...
    def parameter(self, name: str) -> Any: ...
    def new(self, inputs: Mapping[str, Any] | None = None, **parameters: Any) -> Running: ...
    def observe(self, what: str, deviation: float, bound: float) -> None: ...


Test = Callable[[Unit], None]


def run(unit: Unit, duration: float, h: float, inputs: Mapping[str, Any], **parameters: Any) -> Running:
    """An instance after `duration` [s] in steps of h with constant inputs."""
    return go_on(unit.new(inputs, **parameters), duration, h)


def go_on(running: Running, duration: float, h: float) -> Running:
    """The same instance after another `duration` [s] in steps of h."""
    for _ in range(round(duration / h)):
        running.step(h)
    return running


def read(running: Running, *names: str) -> np.ndarray:
    """Outputs, one behind the other."""
    return np.concatenate([np.atleast_1d(running[name]) for name in names])


def values(unit: Unit, *names: str) -> tuple[Any, ...]:
    """The unit's own values of parameters."""
    return tuple(unit.parameter(name) for name in names)


def where_known(unit: Unit, **parameters: Any) -> dict[str, Any]:
    """Those of the parameters that the unit has: to switch off what it may not even model."""
    return {name: value for name, value in parameters.items() if unit.supports(name)}


def close(unit: Unit, what: str, seen: Any, expected: Any, bound: float, scale: float | None = None) -> None:
    """Fail unless |seen - expected| <= bound*scale for every element; `scale` is the largest |expected| by default.

    The unit's tolerance takes the place of a smaller bound.
    """
    seen, expected = np.atleast_1d(np.asarray(seen, float)), np.atleast_1d(np.asarray(expected, float))
    size = float(np.max(np.abs(expected))) if scale is None else scale
    allowed = max(bound, unit.tolerance)
    error = np.abs(seen - expected)
    deviation = float(np.max(error)) / size if size else float(np.max(error))
    unit.observe(what, deviation, allowed)
    worst = int(np.argmax(np.where(np.isnan(error), np.inf, error)))
    place = f"[{worst + 1}]" if len(error) > 1 else ""
    wanted = float(np.broadcast_to(expected, error.shape)[worst])
    assert deviation <= allowed, (
        f"{what}{place}: {float(seen[worst]):.7g}, expected {wanted:.7g} within {allowed * (size or 1.0):.2g}"
    )


def holds(condition: Any, what: str) -> None:
    """Fail with `what` unless the condition holds."""
    assert condition, what


def same(what: str, seen: Any, expected: Any) -> None:
    """Fail unless two results are equal to the last bit."""
    seen, expected = np.atleast_1d(seen), np.atleast_1d(expected)
    unequal = np.flatnonzero(seen.ravel() != expected.ravel())
    assert not unequal.size, (
        f"{what}: {unequal.size} of {seen.size} numbers differ, the first by "
        f"{seen.ravel()[unequal[0]] - expected.ravel()[unequal[0]]:.3g}"
    )
