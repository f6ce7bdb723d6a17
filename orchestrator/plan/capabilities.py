"""What FMUs say they cannot do, held against the system before time 0: an error that names FMU, flag and remedy."""

from __future__ import annotations

from ..clock import Clock, seconds_text, whole_stops
from ..errors import InputError
from ..fmu.kinds import MODEL_EXCHANGE
from ..system.component import Component
from ..system.model import System


def check_capabilities(system: System) -> None:
    """Raise InputError for a component that cannot run as the system wants it."""
    for component in system.components.values():
        _check_step(system, component)
        itself = component.fmu.kind != MODEL_EXCHANGE
        if component.tolerance is not None and component.fmu.version == 1 and itself:
            raise InputError(
                f"component {component.name}: FMI 1.0 takes no tolerance for co-simulation; leave it out, or set a "
                f"parameter of {component.fmu.path.name} if it has one for that ({system.path.name})"
            )


def _check_step(system: System, component: Component) -> None:
    fmu, where = component.fmu, f"({system.path.name})"
    inside, recommended = fmu.internal_step, fmu.recommended_step
    if fmu.can_vary_step:
        return
    if inside is not None and (component.period / inside).denominator != 1:
        raise InputError(
            f"component {component.name}: {fmu.path.name} steps by {seconds_text(inside)} inside "
            f"(canHandleVariableCommunicationStepSize = false, fixedInternalStepSize); period = "
            f'"{seconds_text(component.period)}" is no multiple of it; take one {where}'
        )
    if inside is None and recommended is not None and recommended > 0 and component.period != recommended:
        raise InputError(
            f"component {component.name}: {fmu.path.name} has a fixed step (canHandleVariableCommunicationStepSize = "
            f'false) of {seconds_text(recommended)}; write period = "{seconds_text(recommended)}" instead of '
            f'"{seconds_text(component.period)}" {where}'
        )


def check_last_step(system: System, clock: Clock) -> None:
    """Raise InputError for a component that would have to end at the stop with a shorter step and cannot."""
    short = [c for c in system.components.values() if clock.stop % clock.periods[c.name]]
    fixed = [c for c in short if not c.fmu.can_vary_step]
    if not fixed:
        return
    component, start, stop = fixed[0], system.start, system.stop
    others = [c.period for c in system.components.values() if not c.fmu.can_vary_step]
    whole = f"the stop time {seconds_text(stop)}"
    if start:
        whole = f"the time from {seconds_text(start)} to {seconds_text(stop)}"
    raise InputError(
        f"component {component.name}: period {seconds_text(component.period)} does not divide {whole}, and "
        f"{component.fmu.path.name} cannot make a shorter last step (canHandleVariableCommunicationStepSize = false); "
        f"stop at {whole_stops(others, start, stop)}, or take a period that divides it ({system.path.name})"
    )


def require_variable_steps(component: Component, purpose: str) -> None:
    """Raise InputError if `purpose` needs steps of several lengths and the FMU allows one only."""
    if not component.fmu.can_vary_step:
        raise InputError(
            f"component {component.name}: {purpose} needs steps of different lengths, and {component.fmu.path.name} "
            f"does not allow them (canHandleVariableCommunicationStepSize = false); take another algorithm or FMU"
        )


def require_state(component: Component, purpose: str) -> None:
    """Raise InputError if `purpose` needs to go back and the FMU cannot."""
    if not component.fmu.can_save_state:
        raise InputError(
            f"component {component.name}: {purpose} needs to restore states, and {component.fmu.path.name} "
            f"cannot save its own (canGetAndSetFMUState = false); take another algorithm or FMU"
        )


def remarks(component: Component) -> str:
    """What is worth knowing of an FMU in the plan, as the tail of its line."""
    fmu, found = component.fmu, []
    if component.isolation:
        where = f"at {component.isolation}" if component.elsewhere else "in a process of its own"
        found.append(f"{where}{f': {component.apart}' if component.apart else ''}")
    if not fmu.can_vary_step:
        found.append("fixed step")
    if not fmu.can_save_state:
        found.append("cannot save its state")
    if fmu.interface.needsExecutionTool:
        found.append("needs its tool on this machine")
    if fmu.recommended_step is not None and fmu.recommended_step != component.period:
        found.append(f"made for {seconds_text(fmu.recommended_step)}")
    return "".join(f"; {text}" for text in found)
