"""A step by hand, where there is nothing to look after but the loop: it takes less than a block's surroundings.

That is so where nothing is recorded, nothing happens, nobody looks on and no clock on the wall is kept pace with, in
most steps. `Session._run_block` does all others, with the same bits.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from ..loop.cells import DONE, ENDS_AT, NEVER, STOP_REQUEST
from ..participant.surroundings import exact
from .blocks import BLOCK

if TYPE_CHECKING:
    from .stepping import Stepping


def one_step(session: Stepping) -> Callable[[], bool]:
    """What does the next cycle of a session that minds signals; False if it is not done to its end: `_run_block` must.

    Raises what `_settle` raises.
    """
    plan, clock, recorder, blocks = session.plan, session.plan.clock, session.recorder, session.loop
    events = session.events
    if plan.adaptive or session.pacer or events.scenario or events.handler or events.macro or recorder.columns:
        return lambda: False
    whole, ticks, start = clock.cycles, plan.cycle_ticks, clock.start
    numerator, denominator = clock.numerator, clock.denominator
    cells, now, observers = session.control.data, time.perf_counter, session.observers
    looks = session.participants.minds_rounding

    def step() -> bool:
        at, one = session.at, blocks.one
        cycle, begin = at.cycle, now()
        if (
            one is None or one[0] is not recorder.arrays or begin - blocks.looked > BLOCK / 2 or at.operation
            or cycle >= whole or observers or blocks.workers or session.over or session.closed
            or cells[ENDS_AT] != NEVER
        ):  # fmt: skip
            return False
        cells[STOP_REQUEST] = 0
        code = one[1](cycle)
        at.wall += now() - begin
        if code != DONE or (looks and not exact()):
            blocks.ended(code)
            session.behind_block(code, False, 1)
            return at.cycle > cycle or session.over  # or there is more of the cycle to be done
        at.cycle = cycle + 1
        at.time = ((start + at.cycle * ticks) * numerator) / denominator
        return True

    return step
