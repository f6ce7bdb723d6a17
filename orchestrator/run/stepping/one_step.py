"""A step by hand, where there is nothing to look after but the loop: it takes less than a block's surroundings.

That is so where nothing happens, nobody looks on, no clock on the wall is kept pace with, and the buffer has room for
more rows, in most steps. `Session._run_block` does all others, with the same bits.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from ...loop.cells import DONE, ENDS_AT, NEVER, STOP_REQUEST
from ...participant.surroundings import exact
from ..blocks.blocks import BLOCK
from ..session.behind import behind_block

if TYPE_CHECKING:
    from .stepping import Stepping

SAMPLE = 16  # quick steps of which one is timed, and stands for the others: the clock takes as long as the loop
QUICK = 1e-4  # s


def one_step(session: Stepping) -> Callable[[], bool]:
    """What does the next cycle of a session that minds signals; False if it is not done to its end: `_run_block` must.

    Raises what `_settle` raises.
    """
    plan, clock, recorder, blocks = session.plan, session.plan.clock, session.recorder, session.loop
    events = session.events
    if plan.adaptive or session.pacer or events.scenario or events.handler or events.macro:
        return lambda: False
    whole, ticks, start = clock.cycles, plan.cycle_ticks, clock.start
    numerator, denominator = clock.numerator, clock.denominator
    cells, now, observers = session.control.data, time.perf_counter, session.observers
    looks, rows = session.participants.minds_rounding, recorder.rows.data
    known: object = None  # what `last` and `full` belong to
    last, others = 0, tuple[tuple[int, int], ...]()
    left = stands_for = 1  # steps to the next that is timed, and how many it stands for

    def step() -> bool:
        nonlocal known, last, others, left, stands_for
        at, one = session.at, blocks.one
        cycle = at.cycle
        if (
            one is None or one[0] is not recorder.arrays or at.operation or cycle >= whole or observers
            or blocks.workers or session.failure or session.is_over or session.closed or cells[ENDS_AT] != NEVER
        ):  # fmt: skip
            return False
        if one is not known:
            known = one
            last, *more = recorder.last_rows() or [NEVER]
            others = tuple(enumerate(more, 1))
        if rows[0] > last or (others and any(rows[k] > most for k, most in others)):
            return False
        cells[STOP_REQUEST] = 0
        left -= 1
        if left > 0:
            code = one[1](cycle)
        else:
            begin = now()
            if begin - blocks.looked > BLOCK / 2:
                return False
            code = one[1](cycle)
            spent = now() - begin
            at.wall += stands_for * spent
            left = stands_for = SAMPLE if spent < QUICK else 1
        if code != DONE or (looks and not exact()):
            blocks.ended(code)
            behind_block(session, code, False, 1)
            return at.cycle > cycle or session.over  # or there is more of the cycle to be done
        at.cycle = cycle + 1
        at.time = ((start + at.cycle * ticks) * numerator) / denominator
        return True

    return step
