"""Runs a plan. `run` is one source with two lives: compiled for speed (`compiled.py`), plain Python as its interpreter.

It calls the FMI functions by address (`versions.py`), allocates nothing and touches no Python object.
"""

from __future__ import annotations

from math import isfinite

import numpy as np

from ..fmu.types import FLOAT
from .calls import call_segment, call_state
from .cells import (
    AT,
    AT_CYCLE,
    AT_OPERATION,
    BAD_STATUS,
    CHANGED,
    CODE,
    COUNT,
    CROSSED,
    DO_STEP,
    DONE,
    ENDED,
    ENDS_AT,
    EVENT_AT,
    FINAL,
    FIRST_AGAIN,
    FIRST_IN,
    FIRST_OUT,
    FIRST_SLOT,
    FLAGS,
    FMI,
    FREE_STATE,
    FUNCTION,
    GAIN,
    GET_STATE,
    IN_PLACE,
    INSTANCE,
    INTERRUPTED,
    LAST_AGAIN,
    LAST_IN,
    LAST_OUT,
    LATEST,
    MODE,
    MOMENTS,
    NEVER,
    NOT_CONVERGED,
    NOT_FINITE,
    NOW,
    OFFSET,
    OFFSET_OR_VALUE,
    PART,
    PAUSED,
    PROMISED,
    REACHED,
    REFERENCES,
    REPLACED,
    RESUME_AT,
    SEED,
    SET_STATE,
    SIDE,
    SIGMA,
    SIZE,
    SLOT,
    START,
    STATUS,
    STEP_TICKS,
    STOP_REQUEST,
    THRESHOLD,
    UNFIT,
    UNTIL,
    VALUES,
)
from .exchange import pack, unpack
from .last_step import length_to
from .lookup import held_at, mean_over
from .noise import gaussian
from .operations import (
    ACCUMULATE,
    ACCUMULATE_ON,
    ADVANCE,
    AT_AN_INSTANT,
    CONTROL,
    COPY,
    ESTIMATE,
    FAULT,
    FIT,
    GAUGE,
    GET,
    HALVE,
    ITERATE,
    LEDGER,
    LINEAR,
    MEAN,
    MIX,
    MOVE,
    MOVES,
    NUMBER,
    PACE,
    PAUSE,
    PUSH,
    QUADRATIC,
    RECORD,
    REPEAT,
    RESTORE,
    REWIND,
    RISE,
    SAMPLE,
    SAVE,
    SEGMENT,
    SERIES,
    SET,
    SOLVE,
    STEP,
    STEP_ON,
    TURNS,
    WATCH,
    WORK,
    WORK_ON,
)  # fmt: skip
from .pacing import WENT_ON, keep_pace, mark
from .solvers.iteration import AGAIN, CONVERGED, iterate
from .solvers.step_control import control as choose_step
from .solvers.step_control import gauge
from .solvers.step_doubling import ACCEPTED, INDICATOR, REJECTED, REPEATED, estimate
from .turns import move, take_turns
from .versions import NO_ROOM, exchange, good, step

FOREVER = 1e300  # s


def run(
    operations: np.ndarray, coefficients: np.ndarray, components: np.ndarray, blocks: np.ndarray,
    z: np.ndarray, whole: np.ndarray, raw: np.ndarray, raw32: np.ndarray, pool: np.ndarray, index: np.ndarray,
    slots: np.ndarray, groups: np.ndarray, buffer: np.ndarray, rows: np.ndarray,
    control: np.ndarray,
    clock: np.ndarray, work: np.ndarray, saved: np.ndarray, solver: np.ndarray,
    states: np.ndarray, state_calls: np.ndarray,
    moves: np.ndarray, turns: np.ndarray,
    first_cycle: int, cycles: int, cycle_ticks: int, numerator: int, denominator: int,
) -> int:  # fmt: skip
    """Execute `operations` for `cycles` cycles; returns DONE, INTERRUPTED, ENDED, BAD_STATUS, NOT_FINITE,
    NOT_CONVERGED, UNFIT, PAUSED, WAITING or LATE.

    operations (m, 8), see operations.COLUMNS; components (n, 11) and their blocks (k, 10), addresses and counts, see
    cells.py; z: all signals; whole: the same cells as whole numbers; raw, raw32: values as FMUs
    want them, bytes and floats of the same memory; pool, index: the texts, see texts.py;
    groups (g, 3): first of its slots, columns, first cell in `buffer`; rows (g): rows recorded so far;
    control (12, more where the run keeps pace): see cells.STOP_REQUEST...;
    clock (7): see cells.NOW..., with steps that vary (cycle_ticks is 0 then), otherwise zeros; work: state
    of the iteration or of the step controller; saved: signals at the beginning of a macro step; solver: memory of the
    loops that are solved at an instant, and the moments of events (cells.MOMENTS); states (n): FMU states; state_calls
    (n, 3): addresses of the functions that get, set and free one; moves, turns: see turns.py.
    """
    stop = ((control[START] + control[PROMISED]) * numerator) / denominator if control[PROMISED] > 0 else FOREVER
    begin = control[RESUME_AT]
    control[RESUME_AT] = 0
    for cycle in range(first_cycle, first_cycle + cycles):
        base = control[START] + cycle * cycle_ticks + clock[NOW] + clock[OFFSET]
        last_tick = -1
        m = begin - 1
        begin = 0
        while m + 1 < operations.shape[0]:
            m += 1
            code, tick, c = operations[m, 0], operations[m, 1], operations[m, 2]
            a, b, p = operations[m, 3], operations[m, 4], operations[m, 5]
            q, k = operations[m, 6], operations[m, 7]
            if tick != last_tick:
                last_tick = tick
                if control[STOP_REQUEST] != 0:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return INTERRUPTED
                if base + tick > control[ENDS_AT]:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return ENDED
            if code == STEP:
                start = base + b
                time = (start * numerator) / denominator
                length = ((a + clock[STEP_TICKS]) * numerator) / denominator
                if time + length > stop:
                    length = length_to(time, stop)
                status = step(
                    components[c, FMI], components[c, DO_STEP], components[c, INSTANCE], time, length,
                    components[c, FINAL], components[c, FLAGS],
                )  # fmt: skip
                if not good(status):
                    control[AT_OPERATION], control[AT_CYCLE], control[STATUS] = m, cycle, status
                    return BAD_STATUS
            elif code in (SET, GET):
                first, last = components[c, FIRST_IN], components[c, LAST_IN]
                if code == GET and a == AT_AN_INSTANT:
                    first, last = components[c, FIRST_AGAIN], components[c, LAST_AGAIN]
                elif code == GET:
                    first, last = components[c, FIRST_OUT], components[c, LAST_OUT]
                for n in range(first, last):
                    if code == SET and blocks[n, AT] != IN_PLACE:
                        beyond = pack(blocks, n, z, whole, raw, raw32, index)
                        if beyond >= 0:
                            control[AT_OPERATION], control[AT_CYCLE], control[SLOT] = m, cycle, beyond
                            return UNFIT
                    function, instance = blocks[n, FUNCTION], components[c, INSTANCE]
                    references, count, values = blocks[n, REFERENCES], blocks[n, COUNT], blocks[n, VALUES]
                    size, fmi = blocks[n, SIZE], components[c, FMI]
                    status = exchange(fmi, function, instance, references, count, values, size)
                    if good(status) and code == GET and blocks[n, AT] != IN_PLACE:
                        full = unpack(blocks, n, z, whole, raw, raw32, pool, index)
                        if full >= 0:
                            status, control[SLOT] = NO_ROOM, full
                    if not good(status):
                        control[AT_OPERATION], control[AT_CYCLE], control[STATUS] = m, cycle, status
                        return BAD_STATUS
                    if code == GET and blocks[n, CODE] == FLOAT:
                        for j in range(blocks[n, FIRST_SLOT], blocks[n, FIRST_SLOT] + blocks[n, SIZE]):
                            if not isfinite(z[j]):
                                control[AT_OPERATION], control[AT_CYCLE], control[SLOT] = m, cycle, j
                                return NOT_FINITE
            elif code == TURNS:
                verdict = take_turns(
                    turns, a, b, moves, p, z, coefficients, components, control,
                    base, clock[STEP_TICKS], numerator, denominator, stop,
                )  # fmt: skip
                if verdict != DONE:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return verdict
            elif code == SEGMENT:
                verdict = call_segment(a, b, base, clock[STEP_TICKS], numerator, denominator, stop)
                if verdict != DONE:
                    control[PART], control[AT_OPERATION], control[AT_CYCLE] = control[AT_OPERATION], m, cycle
                    return verdict
            elif code == MOVES:
                move(moves, a, b, z, coefficients)
            elif code == COPY:
                z[b] = coefficients[k] * z[a] + coefficients[k + 1]
            elif code == LINEAR:
                z[b] = coefficients[k] * (z[a] + coefficients[k + 2] * (z[a] - z[p])) + coefficients[k + 1]
            elif code == ACCUMULATE:
                z[b] += coefficients[k] * (z[p] + z[a])
            elif code == RISE:
                z[b] += coefficients[k] * (z[a] - z[p])
            elif code == MEAN:
                tail = coefficients[k + 2] * z[a] + coefficients[k + 3] * z[p]
                z[b] = coefficients[k] * (z[q] + tail) + coefficients[k + 1]
                z[q] = -tail
            elif code in (MOVE, PUSH):
                z[b] = z[a]
            elif code == NUMBER:
                number = float(np.uint64(whole[a])) if p else float(whole[a])
                z[b] = coefficients[k] * number + coefficients[k + 1]
            elif code == FIT:
                number = np.rint(coefficients[k] * z[a] + coefficients[k + 1]) if p else float(whole[a])
                fit = coefficients[k + 2] <= number < coefficients[k + 3]
                if fit:
                    cell = whole[a]
                    if p:
                        cell = np.int64(number - 2.0**64 if number >= 2.0**63 else number)
                    high, low, fit = cell >> 32, cell & 0xFFFFFFFF, q == 0
                    for j in range(q):
                        fit = fit or (high == coefficients[k + 4 + 2 * j] and low == coefficients[k + 5 + 2 * j])
                    whole[b] = cell
                if not fit:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return UNFIT
            elif code == RECORD:
                first, columns = groups[a, 0], groups[a, 1]
                cell = groups[a, 2] + rows[a] * columns
                for j in range(columns):
                    buffer[cell + j] = z[slots[first + j]]
                rows[a] += 1
            elif code == WORK:
                h = coefficients[k + 2]
                if h == 0.0:
                    h = (clock[STEP_TICKS] * numerator) / denominator
                z[b] += z[q] * (coefficients[k] * z[p] + coefficients[k + 1] * z[a]) * h
            elif code == LEDGER:
                total = z[a] - z[p]
                z[b] = total - z[q]
                z[q] = total
            elif code == QUADRATIC:
                slope, curvature = z[a] - z[p], z[a] - 2.0 * z[p] + z[q]
                value = z[a] + coefficients[k + 2] * slope + coefficients[k + 3] * curvature
                z[b] = coefficients[k] * value + coefficients[k + 1]
            elif code == MIX:
                value = coefficients[k] * z[b] + coefficients[k + 1] * z[a]
                z[b] = value + coefficients[k + 2] * z[p] + coefficients[k + 3]
            elif code == SERIES:
                time = ((base + p) * numerator) / denominator
                end = ((base + p + q + clock[STEP_TICKS]) * numerator) / denominator
                z[b] = mean_over(coefficients, k, time, end)
            elif code == SAMPLE:
                z[b] = held_at(coefficients, k, ((base + p) * numerator) / denominator)
            elif code in (SAVE, RESTORE) and c < 0:
                for j in range(a):
                    if code == SAVE:
                        saved[j] = z[j]
                    else:
                        z[j] = saved[j]
            elif code in (SAVE, RESTORE):
                cell, status = states.ctypes.data + 8 * c, 0
                if code == RESTORE:
                    status = call_state(state_calls[c, SET_STATE], components[c, INSTANCE], states[c])
                else:
                    if states[c] != 0:
                        status = call_state(state_calls[c, FREE_STATE], components[c, INSTANCE], cell)
                        states[c] = 0
                    if good(status):
                        status = call_state(state_calls[c, GET_STATE], components[c, INSTANCE], cell)
                if not good(status):
                    control[AT_OPERATION], control[AT_CYCLE], control[STATUS] = m, cycle, status
                    return BAD_STATUS
            elif code == REWIND:
                rows[a] -= b
            elif code == ITERATE:
                verdict = iterate(z, b, p, q, coefficients, k, work)
                if verdict == CONVERGED:
                    m = a - 1
                elif verdict != AGAIN:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return NOT_CONVERGED
            elif code == SOLVE:
                verdict = iterate(z, b, p, q, coefficients, k, solver[c:])
                if verdict == AGAIN:
                    m -= a + 1
                elif verdict != CONVERGED:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return NOT_CONVERGED
            elif code == REPEAT:
                m = a - 1
            elif code == GAUGE:
                gauge(z, a, b, p, q, (clock[STEP_TICKS] * numerator) / denominator, coefficients, k, work)
            elif code == CONTROL:
                z[a + 1] = (clock[STEP_TICKS] * numerator) / denominator
                z[a + 2] = choose_step(clock, coefficients, k, work)
                z[a] = clock[NOW]
            elif code == HALVE:
                clock[STEP_TICKS] //= 2
            elif code == ADVANCE:
                clock[OFFSET] = clock[STEP_TICKS]
                base = control[START] + cycle * cycle_ticks + clock[NOW] + clock[OFFSET]
            elif code == ESTIMATE:
                z[b + 1] = (2 * clock[STEP_TICKS] * numerator) / denominator
                verdict = estimate(z, p, q, clock, coefficients, k, work)
                if verdict == ACCEPTED:
                    z[b], z[b + 2], z[b + 3] = clock[NOW], work[INDICATOR], work[REPEATED]
                    work[REPEATED] = 0.0
                    m = a - 1
                elif verdict == REJECTED:
                    base = control[START] + cycle * cycle_ticks + clock[NOW]
                else:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return NOT_CONVERGED
            elif code == STEP_ON:
                at = control[MOMENTS]
                here = at + REACHED + c
                time, end = ((base + b) * numerator) / denominator, ((base + b + a) * numerator) / denominator
                length = (a * numerator) / denominator
                if end > solver[at + LATEST]:
                    end = solver[at + LATEST]
                    length = length_to(time, end)
                if solver[here] > time:
                    time = solver[here]
                    length = length_to(time, end)
                if time + length > stop:
                    length = length_to(time, stop)
                solver[here + components.shape[0]] = time
                if time < end:
                    status = step(
                        components[c, FMI], components[c, DO_STEP], components[c, INSTANCE], time, length,
                        components[c, FINAL], components[c, FLAGS],
                    )  # fmt: skip
                    if not good(status):
                        control[AT_OPERATION], control[AT_CYCLE], control[STATUS] = m, cycle, status
                        return BAD_STATUS
                    solver[here] = end
            elif code == PAUSE:
                if a != 0 or base + tick >= control[EVENT_AT]:
                    control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                    return PAUSED
            elif code in (ACCUMULATE_ON, WORK_ON):
                here = control[MOMENTS] + REACHED + c
                h = solver[here] - solver[here + components.shape[0]]
                if code == ACCUMULATE_ON:
                    z[b] += coefficients[k] * h * (z[p] + z[a])
                else:
                    z[b] += z[q] * (coefficients[k] * z[p] + coefficients[k + 1] * z[a]) * h
            elif code == FAULT:
                if z[a + MODE] == REPLACED:
                    whole[b] = whole[a + OFFSET_OR_VALUE]
                elif z[a + MODE] == CHANGED:
                    value = z[a + GAIN] * z[b] + z[a + OFFSET_OR_VALUE]
                    if z[a + SIGMA] != 0.0:
                        counter = control[START] + cycle * cycle_ticks + clock[NOW] + clock[OFFSET] + p
                        value += z[a + SIGMA] * gaussian(whole[a + SEED], q, counter)
                    z[b] = value
            elif code == WATCH:
                value = z[a]
                if p == 1:
                    value = float(whole[a])
                side = 1.0 if (value > z[b + THRESHOLD] if q else value < z[b + THRESHOLD]) else -1.0
                if z[b + SIDE] * side < 0.0 < side:
                    z[b + CROSSED] += 1.0
                    control[EVENT_AT] = -NEVER
                z[b + SIDE] = side
            elif code == PACE:
                if c >= 0:
                    mark(control, c)
                else:
                    verdict = keep_pace(control, cycle * cycle_ticks + clock[NOW] + clock[OFFSET] + a)
                    if verdict != WENT_ON:
                        control[AT_OPERATION], control[AT_CYCLE] = m, cycle
                        return verdict
        if cycle_ticks == 0 and clock[NOW] >= min(clock[UNTIL], control[ENDS_AT]):
            return DONE
    return DONE
