"""What a group has to say in words: what went wrong in a step, and what a run must tell of it."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import counted
from ...fmu.fmu import Fmu
from ...fmu.reading.states import derivative_names
from ...integration import cells
from ...integration.choice import Chosen
from ...integration.memory import number, whole
from ...integration.stiff.libraries import is_there, why_missing
from ..lifecycle import PREFIX, status_text
from .tables import FUNCTIONS

CALLS = {
    cells.IN_TIME: cells.SET_TIME, cells.IN_STATES: cells.SET_STATES, cells.IN_DERIVATIVES: cells.GET_DERIVATIVES,
    cells.IN_INDICATORS: cells.GET_INDICATORS, cells.IN_COMPLETED: cells.COMPLETED,
    cells.IN_EVENT_MODE: cells.ENTER_EVENTS, cells.IN_UPDATE: cells.UPDATE, cells.IN_CONTINUOUS: cells.ENTER_CONTINUOUS,
    cells.IN_GET_STATES: cells.GET_STATES, cells.IN_NOMINALS: cells.GET_NOMINALS,
    cells.IN_DIRECTIONAL: cells.DIRECTIONAL,
}  # fmt: skip
FLAGS = {  # of CVODE, that say something to its user
    -2: "the tolerance is too small for double precision",
    -3: "the error test failed too often, or steps became too small",
    -4: "the equations of a step do not converge",
    -8: "the right-hand side failed",
    -10: "the right-hand side failed again and again, however small the step",
}
BITS = "restart = true under [solver] makes them so"  # of what is taken up at a checkpoint


def why(g: int, fmus: Sequence[Fmu]) -> str:
    """The fault that the table at `g` holds; the member is named by whoever shows it."""
    fault, member, status = (whole(g + c) for c in (cells.FAULT, cells.FAULT_MEMBER, cells.FAULT_STATUS))
    index, time = whole(g + cells.FAULT_INDEX), number(g + cells.FAULT_TIME)
    fmu, at = fmus[member], f"at t = {time:.9g} s"
    prefix = PREFIX[fmu.version]
    if fault in CALLS:
        function = FUNCTIONS[CALLS[fault]][fmu.version - 1]
        return f"{at} {prefix}{function} answered {status_text(prefix, status)}"
    if fault in (cells.IN_SET, cells.IN_GET):
        verb = "set its inputs" if fault == cells.IN_SET else "get its outputs"
        return f"{at} cannot {verb} from other FMUs for Model Exchange ({status_text(prefix, status)})"
    if fault == cells.NOT_FINITE:
        names = derivative_names(fmu)
        what = f"derivative {names[index]}" if 0 <= index < len(names) else "a state"
        return f"{at} {what} is not finite, however small the step"
    if fault == cells.NO_INDICATOR:
        return (
            f"{at} event indicator {index + 1} is not a number, however small the step; its event lies before, and a "
            "max_step under [solver] may find it"
        )
    if fault == cells.TOO_SMALL:
        return f"{at} the step that the tolerance allows is too small for the clock; state a larger tolerance"
    if fault == cells.CHATTERS:
        cause = f"event indicator {index + 1}" if index >= 0 else _cause(index)
        return (
            f"{at} it chatters: more than 1000 events in one step, the last of {cause} (the model needs hysteresis, or "
            "a mode in which it stays there),"
        )
    if fault == cells.UNSETTLED:
        return f"{at} an event does not settle: after 100 rounds it still asks for another one"
    if fault == cells.LOOP_FAILS:
        return f"{at} an algebraic loop through it has no solution that Newton's method finds"
    if fault == cells.SOLVER:
        return f"{at} CVODE gives up: {FLAGS.get(status, f'flag {status}')}"
    return f"{at} the step failed"


def _cause(index: int) -> str:
    if index <= cells.CROSSES:
        return "a crossing"
    return {cells.TIME_EVENT: "a time event", cells.STEP_EVENT: "a step event"}.get(index, "an input")


def notes(g: int, members: Sequence[str], chosen: Chosen | None, goes_back: bool) -> list[str]:
    """What a run must tell: a method that is not the best, where it proved stiff, and where CVODE lost its history."""
    names, found = ", ".join(members), []
    if chosen and chosen.instead:
        found.append(f"{names}: integrated by {chosen.method}, {chosen.reason}")
    if whole(g + cells.STIFF):
        when = f"t = {number(g + cells.SWITCHED):.9g} s"
        if is_there():
            found.append(
                f"{names}: steps were limited by stability at {when}, CVODE goes on from there; "
                'method = "cvode" under [solver] takes it from the start'
            )
        else:
            missing = "" if chosen and chosen.instead else f"; {why_missing()}"
            found.append(f"{names}: steps are limited by stability since {when}, which makes them many{missing}")
    if (count := whole(g + cells.ANEW)) and not goes_back:
        when = f"t = {number(g + cells.ANEW_AT):.9g} s"
        more = f" and at {counted(count - 1, 'later checkpoint')}" if count > 1 else ""
        found.append(
            f"{names}: CVODE began anew at the checkpoint at {when}{more}, as no state holds its history: results are "
            f"within tolerance, but not bit by bit, those of a run without checkpoints; {BITS}"
        )
    return found


def forgotten(g: int, members: Sequence[str]) -> str:
    """What a run that is taken up here does not go on with; empty where it is as if never stopped."""
    if not whole(g + cells.LOST):
        return ""
    return (
        f"{', '.join(members)}: CVODE has no history then; where no event or input begins it anew anyhow, results are "
        f"equal within its tolerance, not bit by bit; {BITS}"
    )
