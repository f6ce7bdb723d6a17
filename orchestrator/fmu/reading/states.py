"""The continuous states of an FMU for Model Exchange, and their derivatives, in the order of its description.

FMI 1.0 says how many there are, not which variables they are: they have numbers for names then.
"""

from __future__ import annotations

from typing import Any

from ..fmu import Fmu


def derivatives_of(fmu: Fmu) -> list[tuple[Any, Any]]:
    """The derivatives of an FMU in their order, each as what is stated of it and its state; FMI 1.0 states none."""
    return [(unknown, unknown.variable.derivative) for unknown in fmu.own.description.derivatives]


def state_names(fmu: Fmu) -> list[str]:
    """The names of its continuous states, elements of arrays by themselves."""
    if fmu.version == 1:
        return [f"state {k + 1}" for k in range(fmu.own.description.numberOfContinuousStates)]
    return [name for _, state in derivatives_of(fmu) for name in fmu.own.expand(state.name)]


def derivative_names(fmu: Fmu) -> list[str]:
    """The names of the derivatives of its states."""
    if fmu.version == 1:
        return [f"of {name}" for name in state_names(fmu)]
    return [name for unknown, _ in derivatives_of(fmu) for name in fmu.own.expand(unknown.variable.name)]
