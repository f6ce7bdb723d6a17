"""What was done by hand between two steps happens: at the instant between them, bit by bit as a scenario has it.

Events have their place before the rows of an instant are written. The run goes back there: nothing that comes behind
it changes anything but these rows, which are written anew.
"""

from __future__ import annotations

from collections import Counter
from contextlib import nullcontext
from typing import TYPE_CHECKING

import numpy as np

from ...errors import RovbrushError
from ...loop.operations import PAUSE, RECORD
from ...participant.base import AskedToEndError
from ..events.instant import Place

if TYPE_CHECKING:
    from .session import Session


def act(session: Session) -> None:
    """Do what waits; what goes wrong is the `failure` of the session."""
    plan, events, at = session.plan, session.events, session.at
    now = plan.clock.seconds(plan.clock.start + session.tick)
    events.hands.begin(now)
    if events.handler is not None and at.cycle > 0:
        _again(session)
        return
    try:
        if events.handler is not None:
            events.handler.at_once(Place(plan, 0, 0), now)
        elif events.macro is not None:
            events.macro.act(session.tick)
    except AskedToEndError as error:
        session.end_early(str(error))
    except RovbrushError as error:
        session.fail(str(error))
    if session.tick == 0:
        session.recorder.begin_again()


def _again(session: Session) -> None:
    """The instant that is reached, once more from its events on."""
    at = session.at
    rows = session.plan.operations(at.cycle - 1)
    pause = int(np.flatnonzero(rows[:, 0] == PAUSE)[-1])
    behind = rows[pause:]
    session.recorder.take_back(Counter(behind[behind[:, 0] == RECORD, 3].tolist()))
    at.cycle, at.operation = at.cycle - 1, pause
    assert session.events.handler is not None
    session.events.handler.plan_next()
    with session.pacer.over() if session.pacer else nullcontext():
        session.one_block()
