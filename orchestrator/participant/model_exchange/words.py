"""What went wrong in a step of a group, in words."""

from __future__ import annotations

from collections.abc import Sequence

from ...fmu.fmu import Fmu
from ...fmu.reading.states import derivative_names
from ...integration import cells
from ...integration.memory import number, whole
from ..lifecycle import PREFIX, status_text
from .tables import FUNCTIONS

CALLS = {
    cells.IN_TIME: cells.SET_TIME, cells.IN_STATES: cells.SET_STATES, cells.IN_DERIVATIVES: cells.GET_DERIVATIVES,
    cells.IN_INDICATORS: cells.GET_INDICATORS, cells.IN_COMPLETED: cells.COMPLETED,
    cells.IN_EVENT_MODE: cells.ENTER_EVENTS, cells.IN_UPDATE: cells.UPDATE, cells.IN_CONTINUOUS: cells.ENTER_CONTINUOUS,
    cells.IN_GET_STATES: cells.GET_STATES, cells.IN_NOMINALS: cells.GET_NOMINALS,
}  # fmt: skip
FLAGS = {  # of CVODE, that say something to its user
    -2: "the tolerance is too small for double precision",
    -3: "the error test failed too often, or steps became too small",
    -4: "the equations of a step do not converge",
    -8: "the right-hand side failed",
    -10: "the right-hand side failed again and again, however small the step",
}


def why(g: int, fmus: Sequence[Fmu]) -> str:
    """The fault that the table at `g` holds; the member is named by whoever shows it."""
    fault, member, status = (whole(g + c) for c in (cells.FAULT, cells.FAULT_MEMBER, cells.FAULT_STATUS))
    index, time = whole(g + cells.FAULT_INDEX), number(g + cells.FAULT_TIME)
    fmu, at = fmus[member], f"at t = {time:.9g} s"
    prefix = PREFIX[fmu.version]
    if fault in CALLS:
        function = FUNCTIONS[CALLS[fault]][fmu.version == 3]
        return f"{at} {prefix}{function} answered {status_text(prefix, status)}"
    if fault in (cells.IN_SET, cells.IN_GET):
        verb = "set its inputs" if fault == cells.IN_SET else "get its outputs"
        return f"{at} cannot {verb} from other FMUs for Model Exchange ({status_text(prefix, status)})"
    if fault == cells.NOT_FINITE:
        names = derivative_names(fmu)
        what = f"derivative {names[index]}" if 0 <= index < len(names) else "a state"
        return f"{at} {what} is not finite, however small the step"
    if fault == cells.TOO_SMALL:
        return f"{at} the step that the tolerance allows is too small for the clock; state a larger tolerance"
    if fault == cells.CHATTERS:
        cause = f"event indicator {index + 1}" if index >= 0 else _cause(index)
        return (
            f"{at} it chatters: more than 1000 events in one step, the last of {cause}; the model needs hysteresis, or "
            f"a mode in which it stays"
        )
    if fault == cells.UNSETTLED:
        return f"{at} an event does not settle: after 100 rounds it still asks for another one"
    if fault == cells.LOOP_FAILS:
        return f"{at} an algebraic loop through it has no solution that Newton's method finds"
    if fault == cells.SOLVER:
        return f"{at} CVODE gives up: {FLAGS.get(status, f'flag {status}')}"
    return f"{at} the step failed"


def _cause(index: int) -> str:
    return {cells.TIME_EVENT: "a time event", cells.STEP_EVENT: "a step event"}.get(index, "an input")
