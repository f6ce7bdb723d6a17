"""Where things are in the table of a group of FMUs for Model Exchange: bytes behind its address, 8 for each cell.

The first KEPT cells are what a saved state of the group holds, beside the block ARRAYS. Doubles and whole numbers share
the table.
"""

from __future__ import annotations

CELL = 8


def _cells(count: int) -> range:
    return range(0, CELL * count, CELL)


# The group. TIME and NEXT_EVENT [s], and whose that is; NEXT_STEP: the step that the error allows [s]; CURRENT: 1 if K1
# is the right-hand side at TIME; IN_EVENTS: 1 while the members are in event mode; CHANGED: 1 if something was set
# since the last step; RESTART: 1 if CVODE must begin anew; LOST: 1 if it must only because its history is in no saved
# state; ANEW: how often that was so, first at ANEW_AT [s]; STIFF: 1 if the group proved stiff, at SWITCHED [s].
(
    TIME, NEXT_EVENT, NEXT_WHO, NEXT_STEP, CURRENT, IN_EVENTS, METHOD, CHANGED, RESTART, LOST, ANEW, ANEW_AT, STIFF,
    SWITCHED, _END,
) = _cells(15)  # fmt: skip
KEPT = _END // CELL

# What is in the block ARRAYS: states, their derivatives, event indicators, outputs and inputs, inputs from outside.
(
    ARRAYS, ARRAYS_SIZE, X, K1, Z, V, SEEN,
    STATES, MEMBERS, MEMBER_COUNT, INDICATORS, VALUES,
    K2, STAGE, X_NEW, Z_NEW, V_OLD, ABSOLUTE, RELATIVE, NOMINAL,
    ROWS, ROW_COUNT, SOURCES, GAINS, OFFSETS, DISCRETE, DISCRETE_COUNT, WATCHED, WATCHED_COUNT,
    STEP, LONGEST, RESTS_IN_EVENTS, RESTARTS, INFO, ENDS_EARLY, PENDING, WINDOW, IN_WINDOW, MOVED, ASKED,
    CROSSINGS, CROSSING_COUNT,
    LOG, LOG_SIZE, LOG_COUNT, FAULT, FAULT_MEMBER, FAULT_STATUS, FAULT_INDEX, FAULT_TIME,
    STEPS, REJECTED, EVALUATIONS, EVENTS, NO_STATE_BEFORE,
    CVODE, CV_STEP, CV_REINIT, CV_STOP_TIME, CV_ROOTS, CV_TOLERANCES, CV_STATES, CV_ABSOLUTE, CV_REACHED, CV_FOUND,
    CV_POINTER, CV_ONE_STEP, CV_COLUMN, CV_BAND, CV_LOWER, CV_UPPER, SEEDS, SEED_OUT, V_SEEDS, DIRECTIONALS, CV_DATA,
    OWN_SAVE, OWN_RESTORE, OWN_FORGET, OWN_INSTANCE, ENDED, SENT,
    MALLOC, FREE, EVALUATE, EXCHANGE, INDICATE, TRIAL, SETTLE, _LAST,
) = (_END + cell for cell in _cells(90))  # fmt: skip
TABLE = _LAST // CELL

# ENDS_EARLY: 1 if a step ends at an event, which is PENDING then until whoever steps the group has handled it. WINDOW
# [s], IN_WINDOW: the end of the step that parts of a step lead to, and the events before it. MOVED: bits of what
# members say of their states in the rounds of an event, see `events`; ASKED: the last that asked for another round.

# A member, a row of MEMBERS: whose signatures its functions have (2 or 3), instance, addresses of its functions (0 for
# one that need not be called), first state and indicator [bytes] and their numbers; what its directional derivatives
# are taken along, states and then connected inputs: value references and their number, seeds and their number, and
# where in V_SEEDS those of the inputs are; value references of its derivatives and their number;
# FIRST_FMI: 1 if it is of FMI 1.0, which has the signatures of 2 for what is set and got.
(
    VERSION, INSTANCE, SET_TIME, SET_STATES, GET_DERIVATIVES, GET_INDICATORS, GET_STATES, GET_NOMINALS, COMPLETED,
    ENTER_EVENTS, ENTER_CONTINUOUS, UPDATE, FIRST_STATE, STATE_COUNT, FIRST_INDICATOR, INDICATOR_COUNT, DIRECTIONAL,
    KNOWN, KNOWN_COUNT, KNOWN_SEEDS, KNOWN_SIZE, KNOWN_INPUTS, DERIVATIVES, DERIVATIVE_COUNT, FIRST_FMI, MEMBER,
) = _cells(26)  # fmt: skip

# A row of ROWS, what is done with outputs and inputs in each evaluation: kind, member, function, value references and
# their number, address of the values in V, their number. A LOOP: rows that belong to it, unknowns, their addresses and
# the memory of its solver.
KIND, WHO, FUNCTION, REFERENCES, COUNT, AT, SIZE, STATE, ROW = _cells(9)
TAKE, GIVE, GIVE_AS_IS, LOOP = range(4)

# A row of DISCRETE: function that gets, member, reference, type there; function that sets, member, reference, type
# there; gain and offset; room for a value. What was sent last is in SENT.
(
    GET, GET_WHO, GET_REFERENCE, GET_TYPE, PUT, PUT_WHO, PUT_REFERENCE, PUT_TYPE, GAIN, OFFSET, ROOM, LINK,
) = _cells(12)  # fmt: skip
DOUBLE, FLOAT, I8, U8, I16, U16, I32, U32, I64, U64, TRUTH8, TRUTH32, POINTER = range(13)

# A row of CROSSINGS, signals of members whose passing of a value is an event: function that gets, member, reference,
# the address of the value, 1 if the signal rises there, room for it. Their indicators are behind those of all members.
CROSS_GET, CROSS_WHO, CROSS_REFERENCE, CROSS_LIMIT, CROSS_RISES, CROSS_ROOM, CROSSING = _cells(7)

# What is wrong, in FAULT.
(
    NOTHING, IN_TIME, IN_STATES, IN_DERIVATIVES, IN_INDICATORS, IN_SET, IN_GET, IN_COMPLETED, IN_EVENT_MODE, IN_UPDATE,
    IN_CONTINUOUS, IN_GET_STATES, IN_NOMINALS, NOT_FINITE, TOO_SMALL, CHATTERS, UNSETTLED, LOOP_FAILS, SOLVER,
    NO_MEMORY, IN_DIRECTIONAL, NO_INDICATOR,
) = range(22)  # fmt: skip

# Methods.
DORMAND_PRINCE, RUNGE_KUTTA, CVODES = range(3)

# Why a member saw an event, in LOG: an indicator (its number) or one of these; CROSSES less the number of a crossing.
TIME_EVENT, STEP_EVENT, INPUT_EVENT, CROSSES = -1, -2, -3, -4
ENTRY = 24  # bytes of the log: time, member, indicator

# What functions of the group answer: done; it may go with a smaller step; it does not go; a member asks to end; a step
# ends at an event.
OK, RETRY, FAILED, ENDING, STOPPED = range(5)
