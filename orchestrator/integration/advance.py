"""One-step methods between two instants: the step chosen by its error, or fixed; events are stops on the way."""

from __future__ import annotations

from math import ceil

from numba.extending import register_jitable

from .cells import (
    CELL,
    CROSS_WHO,
    CROSSES,
    CROSSING,
    CROSSING_COUNT,
    CROSSINGS,
    CURRENT,
    CVODE,
    CVODES,
    DORMAND_PRINCE,
    FAILED,
    FIRST_INDICATOR,
    INDICATOR_COUNT,
    INDICATORS,
    K1,
    LONGEST,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    METHOD,
    NEXT_STEP,
    OK,
    REJECTED,
    RESTART,
    RETRY,
    STATES,
    STEP,
    STEP_EVENT,
    STEPS,
    STIFF,
    SWITCHED,
    TIME,
    TOO_SMALL,
    X_NEW,
    Z_NEW,
    X,
)  # fmt: skip
from .events.roots import EPSILON, first_changed, keep_indicators, locate
from .events.rounds import log
from .members import completed, evaluate, fault, indicate, place
from .memory import into_caller, number, put, put_whole, whole
from .one_step import error_of, last_derivative, stiffness, trial

REACHED, EVENT, SWITCH, BAD = range(10, 14)  # how an advance ended; BAD: below it stands a status
SAFE, GROWTH, SHRINK, EASY = 0.9, 5.0, 0.2, 1e-4  # of the step; an error that is too small to be looked at
CALM, TOO_STIFF, STIFF_LIMIT, RELIEVED = 8, 15, 3.25, 6  # steps without a look; how often the limit was met


@register_jitable
def owner(g: int, indicator: int) -> int:
    """The member that an indicator of the group belongs to."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        first = whole(row + FIRST_INDICATOR) // CELL
        if first <= indicator < first + whole(row + INDICATOR_COUNT):
            return m
    return 0


@register_jitable
def note_event(g: int, indicator: int) -> None:
    """Log an event that an indicator of the group shows."""
    crossed = indicator - (whole(g + INDICATORS) - whole(g + CROSSING_COUNT))
    if crossed >= 0:
        log(g, whole(whole(g + CROSSINGS) + CROSSING * crossed + CROSS_WHO), CROSSES - crossed)
        return
    m = owner(g, indicator)
    first = whole(whole(g + MEMBERS) + MEMBER * m + FIRST_INDICATOR) // CELL
    log(g, m, indicator - first)


@into_caller
def after_step(g: int) -> int:
    """What members say to an accepted step: OK, EVENT or a status."""
    said = completed(g)
    if said < 0:
        log(g, -said - 1, STEP_EVENT)
        return EVENT
    return said


@register_jitable
def advance(g: int, target: float) -> int:
    """From TIME to an instant or to an event before it: REACHED, EVENT, SWITCH (to CVODE), or a status that is bad."""
    fixed = number(g + STEP)
    if whole(g + CURRENT) == 0:
        status = evaluate(g, number(g + TIME), whole(g + X), whole(g + K1))
        if status != OK:
            return FAILED if status == RETRY else status
        put_whole(g + CURRENT, 1)
    count, met, relieved = 0, 0, 0
    while True:
        time = number(g + TIME)
        left = target - time
        h = number(g + NEXT_STEP)
        if fixed > 0.0:
            h = left / max(ceil(left / fixed - 1e-9), 1.0)
        h = min(h, number(g + LONGEST))
        clipped = h >= left * (1.0 - 1e-9)
        if clipped:
            h = left
        status = trial(g, time, h)
        error = 0.0
        if status == OK and fixed == 0.0:
            error = error_of(g, h)
            if error > 1e20:
                status = RETRY
        if status == OK and error <= 1.0:
            status = indicate(g, whole(g + Z_NEW))
        if status == FAILED or (status == RETRY and fixed > 0.0):
            return FAILED
        if status == RETRY or error > 1.0:
            put_whole(g + REJECTED, whole(g + REJECTED) + 1)
            shrunk = 0.25 * h if status == RETRY else h * max(SHRINK, SAFE * error**-0.2)
            put(g + NEXT_STEP, shrunk)
            if shrunk <= 16.0 * EPSILON * abs(time) or shrunk < 1e-30 or time + shrunk == time:
                if status != RETRY:
                    fault(g, TOO_SMALL, 0, 0, -1)
                return FAILED
            continue
        event = first_changed(g)
        if event >= 0:
            found = locate(g, h)
            if found < 0.0:
                return FAILED
            clipped = clipped and found == h
            h = found
            event = first_changed(g)
        accept(g, target if clipped else time + h)
        if clipped and time + h != target and place(g, target, whole(g + X)) != OK:
            return FAILED
        if fixed == 0.0:
            grow(g, h, error, clipped)
        said = after_step(g)
        if event >= 0:
            note_event(g, event)
            if said in (OK, EVENT):
                return EVENT
        if said != OK:
            return said
        if clipped:
            return REACHED
        count += 1
        if count > CALM and fixed == 0.0 and whole(g + STIFF) == 0 and whole(g + METHOD) == DORMAND_PRINCE:
            if stiffness(g, h) > STIFF_LIMIT:
                met, relieved = met + 1, 0
            else:
                relieved += 1
                met = 0 if relieved == RELIEVED else met
            if met == TOO_STIFF:
                put_whole(g + STIFF, 1)
                put(g + SWITCHED, number(g + TIME))
                if whole(g + CVODE) != 0:
                    put_whole(g + METHOD, CVODES)
                    put_whole(g + RESTART, 1)
                    return SWITCH


@register_jitable
def accept(g: int, time: float) -> None:
    """The trial step becomes the state of the group."""
    x, new, k1, last = whole(g + X), whole(g + X_NEW), whole(g + K1), last_derivative(g)
    for j in range(0, CELL * whole(g + STATES), CELL):
        put(x + j, number(new + j))
        put(k1 + j, number(last + j))
    put(g + TIME, time)
    put_whole(g + STEPS, whole(g + STEPS) + 1)
    keep_indicators(g)


@register_jitable
def grow(g: int, h: float, error: float, clipped: bool) -> None:
    """The next step by the error of this one; one that an instant cut short says little of longer ones."""
    if clipped and number(g + NEXT_STEP) > h and error < 0.03:
        return
    if error > EASY:
        put(g + NEXT_STEP, h * min(GROWTH, max(SHRINK, SAFE * error**-0.2)))
    else:
        put(g + NEXT_STEP, h * GROWTH)
