"""FMUs that take steps of one size only: is the period of the component that size?"""

from __future__ import annotations

from fractions import Fraction

from .clock import seconds_text
from .errors import InputError
from .system import Component


def check_step(component: Component) -> None:
    """Raise InputError if the FMU cannot take steps of the component's period."""
    capabilities, experiment = component.fmu.description.coSimulation, component.fmu.description.defaultExperiment
    if capabilities is None or capabilities.canHandleVariableCommunicationStepSize:
        return
    internal = capabilities.fixedInternalStepSize  # FMI 3.0: a period of several such steps will do
    stated = internal or (experiment.stepSize if experiment else None)
    if not stated:
        return
    step = Fraction(str(stated))
    if component.period == step or (internal and (component.period / step).denominator == 1):
        return
    name = component.name
    raise InputError(
        f"component {name}: {component.fmu.path.name} takes steps of {seconds_text(step)} only, the period is "
        f'{seconds_text(component.period)}; give --period {name}="{seconds_text(step)}", or have it exported '
        f"with variable steps or with steps of {seconds_text(component.period)}"
    )
