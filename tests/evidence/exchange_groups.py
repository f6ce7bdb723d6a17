"""Random groups of Model Exchange: lags that may answer at once, oscillators and relays, of FMI 2.0 and 3.0."""

from __future__ import annotations

import random
from pathlib import Path

import exchange_build
import numpy as np
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.file.reader import load_system

from . import seeded

NAME = "exchange_groups"
CLAIM = "both solvers give the same; a run that is taken up gives the same bits, or says that it does not"
COUNT = 2_000
UNIT = "groups of Model Exchange"
LIMIT = 60.0
SAMPLE = 4

NAMES = ("lag", "oscillator", "relay")
AGREE = 1e-4  # of the largest value, at a relative tolerance of 1e-9 over some time constants


def prepare(folder: Path) -> None:
    for version in (2, 3):
        (folder / f"v{version}").mkdir(exist_ok=True)
        for name in NAMES:
            exchange_build.exchange(folder / f"v{version}", name, version)


def one(index: int, folder: Path) -> str:
    rng = seeded(NAME, index)
    text = _system(rng, folder.parent)
    found = {}
    for method in ("dormand-prince", "cvode"):
        plan = _planned(folder, text, method)
        with Session(plan) as session:
            whole, bits = _end(session)
            if session.failure:
                return f"{method}: {session.failure}"
            found[method] = whole
        wrong = _taken_up(plan, rng, folder, bits)
        if wrong:
            return f"{method}: {wrong}"
    a, b = found.values()
    off = float(np.max(np.abs(a - b)))
    return "" if off <= AGREE * max(1.0, float(np.max(np.abs(a)))) else f"the solvers are {off:g} apart\n{text}"


def _system(rng: random.Random, place: Path) -> str:
    """Each input is driven by any output of its kind, by a table or by nothing."""
    names = [rng.choice(NAMES) for _ in range(rng.randint(1, 6))]
    parts, connections = [], []
    outputs = [f"c{k}.{y}" for k, name in enumerate(names) for y in ("xy" if name != "relay" else "")]
    switches = [f"c{k}.on" for k, name in enumerate(names) if name == "relay"]
    for k, name in enumerate(names):
        values = {
            "lag": f"d = {rng.uniform(-0.6, 0.6):.3f}, tau = {rng.uniform(0.2, 2.0):.3f}, gain = 0.5",
            "oscillator": f"mu = {rng.choice((0.5, 3.0, 20.0))}",
            "relay": f"low = {rng.uniform(-0.5, 0.2):.3f}, high = {rng.uniform(0.3, 0.8):.3f}",
        }[name]
        version = rng.choice((2, 3))
        parts.append(
            f'[components.c{k}]\nfmu = "{place}/v{version}/{name}.fmu"\nperiod = "{rng.choice((10, 20))} ms"\n'
            f"parameters = {{ {values} }}\n"
        )
        into = {"lag": "push", "oscillator": "u", "relay": "y"}[name]
        if outputs and rng.random() < 0.7:
            connections.append(f'"{rng.choice(outputs)} -> c{k}.{into}"')
        elif rng.random() < 0.5:
            rows = "time = [0.0, 0.5, 0.5, 2.0], values = [0.0, 1.0, -1.0, 1.0]"
            parts.append(f"inputs = {{ {into} = {{ {rows} }} }}\n")
        if name == "lag" and switches and rng.random() < 0.5:
            connections.append(f'"{rng.choice(switches)} -> c{k}.on"')
    head = f'format = 2\nstop_time = "2 s"\nconnections = [{", ".join(connections)}]\n'
    return head + '[solver]\ntolerance = 1e-9\nmethod = "METHOD"\n' + "".join(parts)


def _planned(folder: Path, text: str, method: str) -> Plan:
    path = folder / "system.toml"
    path.write_text(text.replace("METHOD", method), encoding="utf-8")
    return make_plan(load_system(str(path), folder))


def _end(session: Session) -> tuple[np.ndarray, bytes]:
    session.advance()
    outputs = [session.get(".".join(key)) for key in session.plan.layout.outputs]
    return np.array([float(value) for value in outputs]), session.memory.z.tobytes()


def _taken_up(plan: Plan, rng: random.Random, folder: Path, whole: bytes) -> str:
    """What is wrong with a run that writes a checkpoint, and with one that is taken up there."""
    with Session(plan) as first:
        first.advance(until_tick=rng.randrange(1, plan.clock.stop))
        write_checkpoint(first, folder)
        _, kept = _end(first)
    with Session(plan) as second:
        read_checkpoint(folder).restore(second)
        _, resumed = _end(second)
        told = any("CVODE began anew at the checkpoint" in note for note in second.run().notes)
    if resumed != kept:
        return "the run that was taken up is not the one that wrote the checkpoint"
    if resumed != whole and not told:
        return "other bits than those of the whole run, and not a word of it"
    return ""
