"""Where a run was, kept in memory: it goes back there as often as one likes, bit for bit as if it had never left."""

from __future__ import annotations

from dataclasses import dataclass
from types import TracebackType
from typing import Any

import numpy as np

from ...errors import InputError, RovbrushError
from ...loop import cells
from ...participant.base import Participant
from ...plan.plan import Plan
from ..position import Position
from ..recording.happened import Rows
from ..session.session import Session
from ..session.state import cells_of, put_back, told_of

ENDS = [cells.ENDS_AT, cells.EVENT_AT]  # cells of `control` that belong to a position


def unkept(plan: Plan) -> str:
    """Which components cannot be part of a snapshot, and why; empty if all can."""
    return "; ".join(
        f"component {name}: {component.fmu.path.name} cannot save its state "
        f"(canGetAndSetFMU{'S' if component.fmu.version == 3 else 's'}tate = false)"
        for name, component in plan.system.components.items()
        if not component.fmu.can_save_state
    )


@dataclass(eq=False)
class Snapshot:
    """Made by `Session.snapshot`, for its `restore`; it holds a state of every FMU until it is released.

        with session.snapshot() as here:
            ...
            session.restore(here)

    `time`: where it was taken [s]. A session that is closed releases all of its own.
    """

    session: Session
    time: float
    states: dict[str, int]  # of the FMUs, by component
    numbers: dict[str, np.ndarray]
    told: dict[str, Any]
    rows: dict[str, np.ndarray]
    events: Rows
    ends: np.ndarray
    blocks: np.ndarray
    ended: str
    released: bool = False

    def __repr__(self) -> str:
        return f"<Snapshot at {self.time:.9g} s{', released' if self.released else ''}>"

    def release(self) -> None:
        """Give the states back to the FMUs that are alive; nothing the second time."""
        if self.released:
            return
        self.released = True
        for name, state in self.states.items():
            instance = self.session.instances[name]
            if not instance.dead:
                instance.forget(state)

    def __enter__(self) -> Snapshot:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()


def take_snapshot(session: Session) -> Snapshot:
    """Of a session between two steps. Raises InputError for FMUs that cannot save their states, FmuError if one does
    not."""
    if why := unkept(session.plan):
        raise InputError(f"no snapshot can be taken, the run cannot come back: {why}")
    if session.recorder.file is not None:
        raise InputError("no snapshot can be taken of a run whose rows go to a file")
    return Snapshot(
        session, session.time, _saved(session.instances), {k: a.copy() for k, a in cells_of(session).items()},
        told_of(session), session.recorder.content(), session.events.rows, session.control[ENDS],
        session.tables_of_components.copy(), session.ended,
    )  # fmt: skip


def _saved(instances: dict[str, Participant]) -> dict[str, int]:
    """A state of each; none is kept where one refuses."""
    states: dict[str, int] = {}
    try:
        for name, instance in instances.items():
            states[name] = instance.save()
    except BaseException:
        for name, state in states.items():
            instances[name].forget(state)
        raise
    return states


def go_back(session: Session, snapshot: Snapshot) -> None:
    """Bring a session to where its snapshot was taken. Raises InputError for one that is not its own or was released,
    FmuError if an FMU does not go back, which ends the session."""
    if snapshot.session is not session or snapshot.released:
        why = "was released" if snapshot.session is session else "is one of another session"
        raise InputError(f"cannot restore {snapshot!r}: it {why}")
    try:
        for name, state in snapshot.states.items():
            session.instances[name].restore(state)
    except RovbrushError as error:
        session.failure = session.failure or str(error)
        raise
    session.failure, session.ended = "", snapshot.ended
    session.control[ENDS] = snapshot.ends
    session.put_back_components(snapshot.blocks)
    put_back(cells_of(session), snapshot.numbers)
    session.set_by_hand = dict(snapshot.told["set_by_hand"])
    session.recorder.go_back(snapshot.rows)
    session.events.go_back(snapshot.events, snapshot.told["events"])
    session.at = Position(**snapshot.told["at"])
    session.revive()
