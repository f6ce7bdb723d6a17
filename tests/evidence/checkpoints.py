"""A checkpoint that was changed, by accident or on purpose: an error of ours, in time, or a run as it would have been.

Bits, bytes, pieces and whole files are changed, also behind a hash that is right again. A change that the seal finds is
refused; one that is sealed anew must fail, or give a run that ends like any other.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from native_build import feedthrough2
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.assemble import assemble

from . import seeded

NAME = "checkpoints"
CLAIM = "a changed checkpoint gives no crash, no hang and no error but ours"
COUNT = 5_000
UNIT = "changed checkpoints"
LIMIT = 5.0  # s
SAMPLE = 100

VALUES = [0, -1, 1, 3, 1 << 40, -(1 << 62), 1e300, float("nan"), "", "x", None, [], {}, True, [[]], "../../x", 10**400]


def prepare(folder: Path) -> None:
    """A checkpoint of every kind: in memory, and with rows on disk."""
    feedthrough2(folder / "f.fmu")
    free = "n_in = 1, mode_in = 2, on_in = true, s_in = 'on'"
    text = 'format = 2\nstop_time = "0.1 s"\nconnections = ["a.x -> b.u"]\n'
    for name, more in (("a", "u = 1.5, "), ("b", "")):
        text += f'[components.{name}]\nfmu = "{folder}/f.fmu"\nperiod = "1 ms"\ninputs = {{ {more}{free} }}\n'
    (folder / "case.toml").write_text(text)
    with Session(_plan(folder)) as session:
        session.advance(cycles=30)
        session.set("a.u", 2.0)
        write_checkpoint(session, folder / "kept", {"system": "case"})


@cache
def _plan(folder: Path) -> Plan:
    return make_plan(assemble(str(folder / "case.toml")))


def one(index: int, folder: Path) -> str:
    chance, shared = seeded(NAME, index), folder.parent
    shutil.copytree(shared / "kept", folder / "out")
    place = folder / "out" / "checkpoint"
    said = _change(chance, place)
    try:
        checkpoint = read_checkpoint(folder / "out")
        with Session(_plan(shared)) as session:
            checkpoint.restore(session)
            session.advance()
            run = session.run()
    except RovbrushError:
        return ""
    if said.startswith("sealed"):
        return "" if len(run.tables[0]) == 101 and not run.failure else f"{said}: taken, and the run ended otherwise"
    return f"{said}: was taken"


def _change(chance: Random, place: Path) -> str:
    """Change something; what it was."""
    kind = chance.randrange(6)
    files = sorted(place.iterdir())
    if kind < 2:
        path = chance.choice([file for file in files if file.stat().st_size])
        return f"{path.name}: {_change_bytes(chance, path)}"
    if kind == 2:
        return f"{chance.choice(files).name}: {_change_file(chance, chance.choice(files))}"
    head = json.loads((place / "checkpoint.json").read_text())
    said = _change_head(chance, head)
    text = json.dumps(head)
    (place / "checkpoint.json").write_text(text)
    if kind == 3:
        return said
    _seal(place)
    return f"sealed: {said}"


def _change_bytes(chance: Random, path: Path) -> str:
    content = bytearray(path.read_bytes())
    at = chance.randrange(len(content))
    how = chance.choice(["bit", "byte", "cut", "piece", "doubled"])
    if how == "bit":
        content[at] ^= 1 << chance.randrange(8)
    elif how == "byte":
        content[at] = (content[at] + chance.randrange(1, 256)) % 256
    elif how == "cut":
        del content[at:]
    elif how == "piece":
        del content[at : at + chance.randrange(1, 100)]
    else:
        content[at:at] = content[at : at + 100]
    path.write_bytes(bytes(content))
    return how


def _change_file(chance: Random, path: Path) -> str:
    how = chance.choice(["removed", "folder", "pipe", "link", "empty"])
    how = "removed" if how == "empty" and not path.stat().st_size else how
    path.unlink()
    if how == "folder":
        path.mkdir()
    elif how == "pipe":
        os.mkfifo(path)
    elif how == "link":
        path.symlink_to(chance.choice(["/dev/zero", "/dev/null", path.name]))
    elif how == "empty":
        path.write_bytes(b"")
    return f"{path.name} {how}"


def _change_head(chance: Random, head: dict[str, Any]) -> str:
    """Another value, or none, somewhere in the head."""
    at: Any = head
    trail = []
    while True:
        key = chance.choice(list(at) if isinstance(at, dict) else range(len(at)))
        trail.append(str(key))
        inner = at[key]
        if isinstance(inner, (dict, list)) and inner and chance.random() < 0.8:
            at = inner
            continue
        if chance.random() < 0.2:
            del at[key]
            return f"without {'.'.join(trail)}"
        known = at[key]
        at[key] = chance.choice([value for value in VALUES if repr(value) != repr(known)])
        return f"{'.'.join(trail)} = {at[key]!r:.40}"


def _seal(place: Path) -> None:
    digest = hashlib.sha256((place / "checkpoint.json").read_bytes()).hexdigest()
    (place / "checkpoint.sha256").write_text(f"{digest}  checkpoint.json\n")
