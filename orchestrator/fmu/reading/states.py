"""The continuous states of an FMU for Model Exchange, and their derivatives, in the order of its description."""

from __future__ import annotations

from typing import Any

from ..fmu import Fmu


def derivatives_of(fmu: Fmu) -> list[tuple[Any, Any]]:
    """The derivatives of an FMU in their order, each as what is stated of it and its state."""
    return [(unknown, unknown.variable.derivative) for unknown in fmu.own.description.derivatives]


def state_names(fmu: Fmu) -> list[str]:
    """The names of its continuous states, elements of arrays by themselves."""
    return [name for _, state in derivatives_of(fmu) for name in fmu.own.expand(state.name)]


def derivative_names(fmu: Fmu) -> list[str]:
    """The names of the derivatives of its states."""
    return [name for unknown, _ in derivatives_of(fmu) for name in fmu.own.expand(unknown.variable.name)]
