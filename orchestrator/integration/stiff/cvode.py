"""CVODE between two instants, and what it calls: right-hand side and indicators.

It begins anew after every event, and wherever something was set from outside: its history is none then.
"""

from __future__ import annotations

from numba.extending import register_jitable

from ..advance import EVENT, REACHED, accept, after_step, note_event
from ..cells import (
    ANEW,
    ANEW_AT,
    CURRENT,
    CV_ABSOLUTE,
    CV_DATA,
    CV_FOUND,
    CV_ONE_STEP,
    CV_POINTER,
    CV_REACHED,
    CV_REINIT,
    CV_ROOTS,
    CV_STATES,
    CV_STEP,
    CV_STOP_TIME,
    CV_TOLERANCES,
    CVODE,
    FAILED,
    FAULT,
    INDICATORS,
    K1,
    LOST,
    NOTHING,
    OK,
    RELATIVE,
    RESTART,
    SOLVER,
    STEPS,
    TIME,
    Z_NEW,
    X,
)  # fmt: skip
from ..events.roots import EPSILON, first_changed, keep_indicators
from ..members import evaluate, evaluate_here, fault, indicate, place
from ..memory import call, call_whole, half, into_caller, number, put, put_whole, whole
from ..one_step import trial

NORMAL, ONE_STEP = 1, 2
MOST_AHEAD = 24  # doublings of the smallest step behind a root
STOP_REACHED, ROOT, TOO_MUCH_WORK, TOO_CLOSE = 1, 2, -1, -27


@into_caller
def values_of(g: int, vector: int) -> int:
    """Where the values of a serial vector are: behind its first pointer at CV_DATA, as the macro NV_DATA_S has it, or
    where N_VGetArrayPointer says."""
    if whole(g + CV_DATA) != 0:
        return whole(whole(vector) + whole(g + CV_DATA))
    return call_whole(whole(g + CV_POINTER), vector)


def right_hand_side(time: float, states: int, derivatives: int, g: int) -> int:
    """CVRhsFn; below 0 where it does not go on, 1 where a smaller step may."""
    status = evaluate_here(g, time, values_of(g, states), values_of(g, derivatives))
    return status if status < FAILED else -1


def roots(time: float, states: int, values: int, g: int) -> int:
    """CVRootFn."""
    status = place(g, time, values_of(g, states))
    if status == OK:
        status = indicate(g, values)
    return 0 if status == OK else -1


@register_jitable
def begin_anew(g: int) -> int:
    """CVODE from TIME and X, with the tolerances of now."""
    flag = call(whole(g + CV_REINIT), whole(g + CVODE), number(g + TIME), whole(g + CV_STATES))
    if flag == 0:
        flag = call(whole(g + CV_TOLERANCES), whole(g + CVODE), number(g + RELATIVE), whole(g + CV_ABSOLUTE))
    put_whole(g + RESTART, 0)
    if whole(g + LOST) != 0:
        put_whole(g + LOST, 0)
        if whole(g + ANEW) == 0:
            put(g + ANEW_AT, number(g + TIME))
        put_whole(g + ANEW, whole(g + ANEW) + 1)
    return flag


@into_caller
def advance_by_cvode(g: int, target: float) -> int:
    """From TIME to an instant or to an event before it: REACHED, EVENT, or a status that is bad."""
    put_whole(g + CURRENT, 0)
    flag = begin_anew(g) if whole(g + RESTART) != 0 else 0
    if flag == 0:
        flag = call(whole(g + CV_STOP_TIME), whole(g + CVODE), target)
    task = ONE_STEP if whole(g + CV_ONE_STEP) != 0 else NORMAL
    while flag >= 0:
        put_whole(g + FAULT, NOTHING)
        reached = whole(g + CV_REACHED)
        flag = call(whole(g + CV_STEP), whole(g + CVODE), target, whole(g + CV_STATES), reached, task)
        if flag == TOO_MUCH_WORK:
            flag = 0
            continue
        if flag == TOO_CLOSE and target - number(g + TIME) <= 1e3 * EPSILON * abs(target):
            put(reached, target)  # nothing happens in so short a time
            put_whole(g + RESTART, 1)
            flag = STOP_REACHED
        if flag < 0:
            break
        put(g + TIME, target if flag == STOP_REACHED else number(reached))
        put_whole(g + STEPS, whole(g + STEPS) + 1)
        status = place(g, number(g + TIME), whole(g + X))
        if status == OK:
            status = indicate(g, whole(g + Z_NEW))
        if status != OK:
            return FAILED
        event = first_changed(g)
        if flag == ROOT and event < 0:
            event = just_behind(g, target)
            if event < 0:
                event = first_found(g)
        keep_indicators(g)
        said = after_step(g)
        if event >= 0:
            note_event(g, event)
            if said in (OK, EVENT):
                return EVENT
        if said != OK:
            return said
        if number(g + TIME) >= target:
            return REACHED
    if whole(g + FAULT) == NOTHING:
        fault(g, SOLVER, 0, flag, -1)
    return FAILED


@register_jitable
def first_found(g: int) -> int:
    """The first indicator that CVODE found to cross zero."""
    found = whole(g + CV_FOUND)
    call(whole(g + CV_ROOTS), whole(g + CVODE), found)
    for j in range(whole(g + INDICATORS)):
        if half(found + 4 * j) != 0:
            return j
    return 0


@register_jitable
def just_behind(g: int, target: float) -> int:
    """Go on from a root, at which rounding left what is asked short of its zero, until an indicator changes: which; -1
    if none does before an instant. An FMU that finds itself short of it would say that nothing happens."""
    time = number(g + TIME)
    h = 4.0 * EPSILON * max(abs(time), 1e-3)
    if evaluate(g, time, whole(g + X), whole(g + K1)) != OK:
        return -1
    for _ in range(MOST_AHEAD):
        if time + h > target or trial(g, time, h) != OK or indicate(g, whole(g + Z_NEW)) != OK:
            break
        changed = first_changed(g)
        if changed >= 0:
            accept(g, time + h)
            return changed
        h *= 2.0
    status = place(g, time, whole(g + X))
    if status == OK:
        indicate(g, whole(g + Z_NEW))
    put_whole(g + FAULT, NOTHING)
    return -1
