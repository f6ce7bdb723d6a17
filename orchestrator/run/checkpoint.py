"""A run on disk, to go on with another day: bitwise as if it had not been interrupted.

    checkpoint/checkpoint.json    what was asked for, how far the run is, what must not change, hashes of the files
    checkpoint/arrays.npz         the cells of all signals, texts, the state of the algorithm, rows not yet on disk
    checkpoint/0.state, 1.state   the states of the FMUs, by position, as they serialize them
    checkpoint/0.kept             the state that an iteration goes back to
    checkpoint/rows.nc            rows that were on disk already

The folder is written under a temporary name and renamed when complete; it replaces an earlier one.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import zipfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import InputError, RunError
from ..participant.base import Instance
from ..plan.plan import Plan
from .fingerprint import fingerprint, require_unchanged
from .session import Position, Session

FORMAT = 1
NAME, HEAD, ARRAYS, ROWS = "checkpoint", "checkpoint.json", "arrays.npz", "rows.nc"


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
        np.savez(temporary / ARRAYS, **_arrays(session), **session.recorder.content())  # type: ignore[arg-type]
        for k, instance in enumerate(session.instances.values()):
            (temporary / f"{k}.state").write_bytes(_state(instance))
            if session.space.states[k]:
                (temporary / f"{k}.kept").write_bytes(instance.serialize(int(session.space.states[k])))
        if session.recorder.stream:
            session.recorder.stream.close()
            shutil.copyfile(session.recorder.stream.path, temporary / ROWS)
        head = {
            "format": FORMAT, "request": request, "at": asdict(session.at), "unchanged": fingerprint(session.plan),
            "files": {path.name: _hash(path) for path in sorted(temporary.iterdir())},
        }  # fmt: skip
        (temporary / HEAD).write_text(json.dumps(head, indent=1) + "\n", encoding="utf-8")
        if target.exists():
            target.rename(old)
        temporary.rename(target)
    except OSError as error:
        raise RunError(f"cannot write {target}: {error.strerror or error}") from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
        if target.exists():
            shutil.rmtree(old, ignore_errors=True)
    return target


def _arrays(session: Session) -> dict[str, np.ndarray]:
    """What a session holds beside its rows; all but the texts are restored in place."""
    space, texts = session.space, session.memory.texts
    pool, index = texts.content()
    return {
        "z": session.memory.z, "clock": space.clock, "work": space.loop.work, "saved": space.loop.saved,
        "texts": pool, "text_index": index,
    }  # fmt: skip


def _state(instance: Instance) -> bytes:
    state = instance.save()
    try:
        return instance.serialize(state)
    finally:
        instance.forget(state)


def _hash(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


@dataclass(frozen=True)
class Checkpoint:
    """A checkpoint on disk, read and found undamaged."""

    folder: Path
    request: Mapping[str, Any] | None
    at: Position
    unchanged: Mapping[str, Any]
    files: tuple[str, ...]
    arrays: Mapping[str, np.ndarray]

    def restore(self, session: Session) -> None:
        """Take a session at time 0 to where the other one was. Raises InputError if anything is not as it was."""
        require_unchanged(self.unchanged, session.plan)
        for name, target in _arrays(session).items():
            found = self.arrays[name]
            if name not in ("texts", "text_index"):
                if found.shape != target.shape or found.dtype != target.dtype:
                    raise InputError(f"{self.folder} is of another version of rovbrush; start again")
                target[...] = found
        session.memory.texts.restore(self.arrays["texts"], self.arrays["text_index"])
        session.recorder.restore(self.arrays, self.folder / ROWS)
        for k, instance in enumerate(session.instances.values()):
            state = instance.deserialize((self.folder / f"{k}.state").read_bytes())
            instance.restore(state)
            instance.forget(state)
            if f"{k}.kept" in self.files:
                session.space.states[k] = instance.deserialize((self.folder / f"{k}.kept").read_bytes())
        session.at = self.at


def read_checkpoint(folder: Path) -> Checkpoint:
    """The checkpoint in a results folder. Raises InputError if there is none or it is damaged."""
    place = folder / NAME
    if not (place / HEAD).is_file():
        raise InputError(
            f"there is no checkpoint in {folder}; `rovbrush run --checkpoint TIME` and Ctrl-C write one into the "
            f"folder of the results"
        )
    try:
        head = json.loads((place / HEAD).read_text(encoding="utf-8"))
        if head["format"] != FORMAT:
            raise InputError(f"{place} has format {head['format']}, this version of rovbrush reads {FORMAT}")
        for name, digest in head["files"].items():
            if Path(name).name != name or _hash(place / name) != digest:
                raise ValueError(f"{name} is not what was written")
        with np.load(place / ARRAYS, allow_pickle=False) as file:
            arrays = dict(file)
        return Checkpoint(
            place, head["request"], Position(**head["at"]), head["unchanged"], tuple(head["files"]), arrays
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError, zipfile.BadZipFile) as error:
        raise InputError(f"{place} is damaged: {error}; start again") from error
