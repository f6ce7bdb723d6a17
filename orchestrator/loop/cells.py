"""Where things are in the arrays of the loop: cells, columns, and what the loop returns."""

from __future__ import annotations

# What `run` returns.
DONE, INTERRUPTED, BAD_STATUS, NOT_FINITE, NOT_CONVERGED, ENDED, UNFIT, PAUSED, WAITING, LATE = range(10)
GAVE_UP = -1  # machine code, where Python would raise: no plan should bring that about

# `control`: a stop request from outside; where the run ended and why; the operation with which the first cycle goes on;
# the stop that the FMUs were promised [ticks from the start]; an instant behind which a component does not want to go
# on, or an event happens between two instants; the start [ticks from time 0]; the instant from which on an event is due
# [ticks from time 0], and the first of the moments (below) in the memory of the solver; which part of several turns,
# or operation of a segment, ended the run. The loop reads them where it
# needs them: a local of its own, alive over all operations, costs 10 % of a small step.
STOP_REQUEST, AT_OPERATION, AT_CYCLE, STATUS, SLOT, RESUME_AT, PROMISED, ENDS_AT, START = range(9)
EVENT_AT, MOMENTS, PART, CONTROL_CELLS = range(9, 13)
NEVER = 1 << 62  # ticks

# Cells of `control` behind those, where a run keeps pace with the clock on the wall; see `pacing.py`. Addresses of two
# functions; the time of the wall [ns] that belongs to a tick; nanoseconds per tick as a quotient; what to do about a
# deadline that is missed; the tick and the lateness [ns] of the worst one and who needed the most time before it; the
# time of the last mark; who needed the most since the last deadline, and how much; where the clock is read to (two
# cells); deadlines so far, those that were missed, the sum of lateness [ns]; its histogram; and behind it for every
# component, and for all else, how many missed deadlines it needed the most time before.
(
    READ_CLOCK, SLEEP, ORIGIN, ORIGIN_TICK, NANOSECONDS, PER_TICKS, POLICY, WORST, WORST_TICK, WORST_COMPONENT,
    MARKED, SLOWEST, SLOWEST_TIME, SECONDS, PARTS, DEADLINES, MISSED, LATENESS,
) = range(CONTROL_CELLS, CONTROL_CELLS + 18)  # fmt: skip
HISTOGRAM = LATENESS + 1
BINS = 20  # up to 1, 2, 5, 10 ... us, the last one is open
CAUSES = HISTOGRAM + BINS
WARN, STOP_LATE, SKIP = range(3)  # of POLICY

# Cells of a fault in the vector of signals: what it does now, the factor and what is added, or in the same cell what
# stands for the signal; the standard deviation of noise and its seed (a whole number).
MODE, GAIN, OFFSET_OR_VALUE, SIGMA, SEED, FAULT_CELLS = range(6)
ABSENT, CHANGED, REPLACED = range(3)  # of MODE
# Cells of a watched signal: -1, 1 or (not looked at yet) 0 for its side, the value that it crosses, how often it has
# done so since somebody asked.
SIDE, THRESHOLD, CROSSED, WATCH_CELLS = range(4)

# `clock` of steps that vary [ticks]: the instant, the step that is done now, its limits, the stop, an end before
# it, and where in the macro step its second half begins while that is done.
NOW, STEP_TICKS, MINIMUM, MAXIMUM, STOP, UNTIL, OFFSET, CLOCK_CELLS = range(8)

# Moments [s], where there are events: no step goes beyond the first; then for each component how far it has come, and
# behind them for each where its last step, or the part of it that was done last, began.
LATEST, REACHED = range(2)

# `components`: whose signatures its functions have (2: FMI 1.0 and 2.0; 3: FMI 3.0), instance, address of its step
# function, what it writes (FMI 3), its blocks, 1 if no state before a step is restored behind it (FMI 1.0: always), and
# the blocks of what is read again at an instant.
FMI, INSTANCE, DO_STEP, FLAGS, FIRST_IN, LAST_IN, FIRST_OUT, LAST_OUT, FINAL, FIRST_AGAIN, LAST_AGAIN = range(11)

# `blocks`: function, value references and their number, address of the values, their number, first slot, place in
# `raw`, type code, bytes of a value, whether it has a sign.
FUNCTION, REFERENCES, COUNT, VALUES, SIZE, FIRST_SLOT, AT, CODE, BYTES, SIGNED = range(10)
IN_PLACE = -1  # AT of a block whose values lie in the run's vector

# `state_calls`: addresses of the functions that get, set and free a state of an FMU.
GET_STATE, SET_STATE, FREE_STATE = range(3)
