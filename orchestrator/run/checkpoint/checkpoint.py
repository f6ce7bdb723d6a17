"""A run on disk, to go on with another day: bitwise as if it had not been interrupted.

    checkpoint/checkpoint.json    what was asked for, how far the run is, what must not change, hashes of the files
    checkpoint/checkpoint.sha256  the hash of checkpoint.json
    checkpoint/arrays.npz         the cells of all signals, texts, the state of the algorithm, rows not yet on disk
    checkpoint/0.state, 1.state   the states of the FMUs, by position, as they serialize them
    checkpoint/0.kept             the state that an iteration goes back to
    checkpoint/rows.nc            rows that were on disk already
    checkpoint/events.rows        the rows of events

The folder is written under a temporary name and renamed when complete; it replaces an earlier one. A process that is
killed in between leaves the new one or the old one under a temporary name, where it is found; see `checkpoint_files`.
"""

from __future__ import annotations

import json
import math
import os
import shutil
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import InputError, RunError
from ...files import reason
from ...loop.cells import NOW
from ...participant.base import Participant
from ...plan.plan import Plan
from ..position import Position
from ..session.session import Session
from ..session.state import cells_of, put_back, told_of
from .files import ARRAYS, EVENTS, NAME, ROWS, CheckpointDamagedError, found_in, read_head, seal
from .fingerprint import fingerprint, require_unchanged


def unserializable(plan: Plan) -> str:
    """Which components cannot be part of a checkpoint, and why; empty if all can."""
    names = [
        f"component {name}: {component.fmu.path.name} cannot write its state to disk "
        f"({'canSerialize' if component.fmu.can_save_state else 'canGetAndSet'}FMUstate = false)"
        for name, component in plan.system.components.items()
        if not component.fmu.can_serialize_state
    ]
    return "; ".join(names)


def write_checkpoint(session: Session, folder: Path, request: Mapping[str, Any] | None = None) -> Path:
    """Write `folder`/checkpoint; `request` is kept with it. Raises FmuError, InputError or RunError."""
    if why := unserializable(session.plan):
        raise InputError(f"no checkpoint can be written, the run cannot go on later: {why}")
    if not session.resumable:
        raise InputError(f"no checkpoint can be written of a run that has failed: {session.failure}")
    target, temporary, old = (folder / f for f in (NAME, f".{NAME}.{os.getpid()}.tmp", f".{NAME}.{os.getpid()}.old"))
    try:
        shutil.rmtree(temporary, ignore_errors=True)
        temporary.mkdir(parents=True)
        session.events.write(temporary / EVENTS)
        pool, index = session.memory.texts.content()
        texts = {"texts": pool, "text_index": index}
        np.savez(temporary / ARRAYS, **cells_of(session), **texts, **session.recorder.content())  # type: ignore[arg-type]
        for k, instance in enumerate(session.instances.values()):
            (temporary / f"{k}.state").write_bytes(_state(instance))
            if session.space.states[k]:
                (temporary / f"{k}.kept").write_bytes(instance.serialize(int(session.space.states[k])))
        if session.recorder.stream:
            session.recorder.stream.copy(temporary / ROWS)
        head = {"request": request, "unchanged": fingerprint(session.plan), **told_of(session)}
        seal(temporary, head)
        if target.exists():
            target.rename(old)
        temporary.rename(target)
    except OSError as error:
        raise RunError(f"cannot write {target}: {reason(error)}") from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
        if target.exists():
            shutil.rmtree(old, ignore_errors=True)
        elif old.exists():
            with suppress(OSError):
                old.rename(target)
    return target


def _state(instance: Participant) -> bytes:
    state = instance.save()
    try:
        return instance.serialize(state)
    finally:
        instance.forget(state)


@dataclass(frozen=True)
class Checkpoint:
    """A checkpoint on disk, read and found undamaged.

    `set_by_hand`: what was set while the run went, by name. The FMUs' states hold it too, but not the elements of an
    array beside the one that is set next, all of which an FMU wants at once.
    """

    folder: Path
    request: Mapping[str, Any] | None
    at: Position
    unchanged: Mapping[str, Any]
    files: tuple[str, ...]
    arrays: Mapping[str, np.ndarray]
    set_by_hand: Mapping[str, Any]
    events: Mapping[str, Any]  # what has happened of those of the system, and what is to come

    def restore(self, session: Session, force: bool = False) -> None:
        """Take a session at time 0 to where the other one was. Raises InputError if anything is not as it was.

        `force`: see `require_unchanged`.
        """
        try:
            require_unchanged(self.unchanged, session.plan, force)
            self._require_within(session.plan)
            self._restore(session)
        except (ArithmeticError, AttributeError, LookupError, MemoryError, OSError, RuntimeError, TypeError,
                ValueError) as error:  # fmt: skip
            raise InputError(f"{self.folder} is damaged: {reason(error)}; start again") from error

    def _restore(self, session: Session) -> None:
        for name, value in self.set_by_hand.items():
            session.set(name, value)
        try:
            put_back(cells_of(session), self.arrays)
        except ValueError:
            raise InputError(f"{self.folder} is of another version of rovbrush; start again") from None
        session.memory.texts.restore(self.arrays["texts"], self.arrays["text_index"])
        session.recorder.restore(self.arrays, self.folder / ROWS)
        for k, instance in enumerate(session.instances.values()):
            state = instance.deserialize((self.folder / f"{k}.state").read_bytes())
            instance.restore(state)
            instance.forget(state)
            if f"{k}.kept" in self.files:
                session.space.states[k] = instance.deserialize((self.folder / f"{k}.kept").read_bytes())
        session.events.read(self.folder / EVENTS, int(self.events["rows"]))
        session.events.restore(self.events)
        session.at = self.at

    def _require_within(self, plan: Plan) -> None:
        """Raise InputError for a position that the plan does not have, or other rows than were recorded until then."""
        clock, at = plan.clock, self.at
        cycles = clock.stop if plan.adaptive else -(-clock.stop // clock.hyperperiod)
        if not (0 <= at.cycle <= cycles and 0 <= at.operation < max(len(plan.operations(at.cycle)), 1)):
            raise InputError(f"{self.folder} is damaged: there is no operation {at.operation} of cycle {at.cycle}")
        rows = [int(a) + int(b) for a, b in zip(self.arrays["rows"], self.arrays["before"], strict=False)]
        each = [1 if plan.adaptive else -(-clock.hyperperiod // group.period) for group in plan.groups]
        done = min(at.cycle * clock.hyperperiod, clock.stop)
        before = [at.cycle if plan.adaptive else -(-done // group.period) for group in plan.groups]
        within = [count - least - 1 for count, least in zip(rows, before, strict=True)]
        if not all(0 <= count <= (more if at.operation else 0) for count, more in zip(within, each, strict=True)):
            raise InputError(f"{self.folder} is damaged: it holds other rows than {at.cycle} cycles leave")
        now = int(self.arrays["clock"][NOW]) if plan.adaptive else done
        if not (0 <= now <= clock.stop and clock.time(now) <= at.time <= clock.time(now + clock.hyperperiod)):
            raise InputError(f"{self.folder} is damaged: cycle {at.cycle} does not end at t = {at.time:g} s")


def read_checkpoint(folder: Path) -> Checkpoint:
    """The checkpoint in a results folder. Raises InputError if there is none or it is damaged."""
    place = found_in(folder)
    if place is None:
        raise InputError(
            f"there is no checkpoint in {folder}; `rovbrush run --checkpoint TIME` and Ctrl-C write one into the "
            f"folder of the results"
        )
    try:
        head = read_head(place)
        with np.load(place / ARRAYS, allow_pickle=False) as file:
            arrays = dict(file)
        return Checkpoint(
            place, head["request"], _position(head["at"]), head["unchanged"], tuple(head["files"]), arrays,
            dict(head["set_by_hand"]), dict(head["events"]),
        )  # fmt: skip
    except (
        CheckpointDamagedError, OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError,
        zipfile.BadZipFile, json.JSONDecodeError,
    ) as error:  # fmt: skip
        raise InputError(f"{place} is damaged: {error}; start again") from error


def _position(content: Mapping[str, Any]) -> Position:
    """How far the run is. Raises ValueError if that is no position."""
    at = Position(**content)
    whole = all(type(number) is int for number in (at.cycle, at.operation))
    if not whole or not all(isinstance(t, float) and math.isfinite(t) for t in (at.time, at.wall)):
        raise ValueError("the position in the run is none")
    return at
