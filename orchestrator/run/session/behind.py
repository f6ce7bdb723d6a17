"""What follows from the end of the loop: the run waits and goes on, an event is handled, or the run is over."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...errors import RovbrushError
from ...loop import cells
from ...participant.base import AskedToEndError
from ..ends.asked import asked_to_end
from ..ends.failure import failure_of

if TYPE_CHECKING:
    from .session import Session


def behind_block(session: Session, code: int, due: bool, size: int) -> None:
    """What follows from the end of the loop, with a code, in a block of `size` cycles; `due`: it is time to look
    around."""
    plan, clock, at, control = session.plan, session.plan.clock, session.at, session.control
    begin = at.cycle
    while code != cells.DONE and (_waited(session, code) or _handled(session, code)):
        if session.over:
            return
        size -= at.cycle - begin
        begin = at.cycle
        code, due = session.loop.run(at, size, session.recorder) if size else (cells.DONE, due)
    if due or session.participants.disturbed:
        reached = clock.time(min(session.tick + size * plan.cycle_ticks, clock.stop))
        session.participants.look_around(f"before t = {reached:.9g} s", due)
    if due:
        session.participants.look()
    at.operation = 0
    if code == cells.BAD_STATUS and _asked_to_end(session):
        return
    session.is_over = code == cells.ENDED
    if code != cells.DONE:
        at.cycle = int(control[cells.AT_CYCLE])
        session.interrupted = code == cells.INTERRUPTED
        if session.interrupted:
            at.operation = int(control[cells.AT_OPERATION])
        at.time, failure = failure_of(plan, session.instances, code, control, session.memory.z, session.space)
        session.failure = "" if session.is_over else failure
        if session.interrupted:
            session.failure = f"{session.stop_requests.reason} at t = {at.time:.9g} s"
    else:
        at.cycle = session.counts[0] - 1 if plan.adaptive else at.cycle + size
        tick = session.tick
        at.time = clock.time(tick)
        session.is_over = clock.start + tick >= session.events.ends_at


def _waited(session: Session, code: int) -> bool:
    """Whether the loop stopped to wait for a deadline that is not so near; it is near now."""
    if code != cells.WAITING or session.pacer is None:
        return False
    at, control = session.at, session.control
    at.cycle, at.operation = int(control[cells.AT_CYCLE]), int(control[cells.AT_OPERATION])
    at.wall += session.pacer.wait(session.loop.tick_at(at))
    return True


def _handled(session: Session, code: int) -> bool:
    """Whether the loop stopped for an event, which is handled then; the session is over if that went wrong."""
    try:
        return session.events.handled(code, session.at)
    except AskedToEndError as error:
        session.note_end(str(error))
        session.is_over = code != cells.PAUSED or not _last_rows(session)
    except RovbrushError as error:
        session.failure = str(error)
    return True


def _last_rows(session: Session) -> bool:
    """Let the loop go on to the rows of the planned instant at which it pauses, and no further; False where there
    are none behind the pause."""
    plan, at = session.plan, session.at
    operations = plan.operations(at.cycle)
    tick = at.cycle * plan.cycle_ticks + int(operations[at.operation, 1])
    session.events.end_at(min(plan.clock.start + tick, session.events.ends_at))
    at.operation += 1
    return at.operation < len(operations)


def _asked_to_end(session: Session) -> bool:
    """Whether the component that stopped the loop asks to end: everybody comes to the end of its step then, or
    the run is over at once where that was not done to its end, or may be taken back."""
    plan, at, control = session.plan, session.at, session.control
    asked = asked_to_end(plan, session.instances, control, session.space, session.loop.components)
    if asked is None:
        return False
    session.note_end(asked.text)
    session.loop.no_more_inputs(asked.component)
    at.cycle, at.operation = int(control[cells.AT_CYCLE]), int(control[cells.AT_OPERATION]) + 1
    if asked.whole and not plan.algorithm.saves_states:
        session.events.end_at(min(plan.clock.start + asked.tick, session.events.ends_at))
        if at.operation == len(plan.operations(at.cycle)):
            at.cycle, at.operation = at.cycle + 1, 0
            session.is_over = not plan.adaptive or plan.clock.start + session.tick >= session.events.ends_at
    else:
        session.is_over = True
    if session.is_over:
        at.time, _ = failure_of(plan, session.instances, cells.INTERRUPTED, control, session.memory.z, session.space)
    return True
