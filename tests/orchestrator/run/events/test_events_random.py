"""Random systems with random events: the same bits compiled, interpreted and cut, and nothing before the first one."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import pytest
from event_cases import INTEGRAL, KEEP, RAMP, SUM, planned, without_events
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

WIRES = ("r.y -> s.u", "s.y -> i.u", "i.y -> k.u", "k.y -> s.w")


def drawn(case: int) -> Plan:
    """Four mocks in a ring with a ramp, at random rates, and up to five events."""
    draw = random.Random(case)
    algorithm = draw.choice(["gauss-seidel", "jacobi", "iterated"])
    periods = [draw.choice(["0.001", "0.002", "0.003", "0.005"]) for _ in range(4)]
    fmus = {"r": RAMP, "s": SUM, "i": INTEGRAL, "k": KEEP}
    parts = {name: (fmu, h) for (name, fmu), h in zip(fmus.items(), periods, strict=True)}
    wires = [wire for wire in WIRES if draw.random() < 0.8]
    driven = [wire.split(" -> ")[1] for wire in wires]
    free = [name for name in ("s.u", "s.w", "i.u", "k.u", "i.k") if name not in driven]
    events: list[dict[str, Any]] = []
    for _ in range(draw.randint(1, 5)):
        event: dict[str, Any] = {"at": f"{draw.randint(0, 500)}/10000 s"}
        if draw.random() < 0.5:
            event = {"when": f"{draw.choice(['r.y', 's.y', 'i.y'])} {draw.choice('<>')} {draw.uniform(-0.1, 0.1)}"}
            event |= {"repeat": True} if draw.random() < 0.5 else {}
            event |= {"after": f"{draw.randint(1, 100)}/10000 s"} if draw.random() < 0.5 else {}
        if driven and draw.random() < 0.6:
            kind = draw.choice(["hold", "bias", "scale", "noise", "loss"])
            event |= {"fault": kind, "on": draw.choice(driven)}
            event |= {} if kind == "hold" else {"value": draw.uniform(0.0, 2.0)}
            event |= {"for": f"{draw.randint(1, 200)}/10000 s"} if draw.random() < 0.6 else {}
        else:
            event |= {"set": {draw.choice(free or ["i.k"]): draw.uniform(-2.0, 2.0)}}
        events.append(event)
    return planned(parts, wires, events, draw.choice(["0.05", "0.047"]), algorithm=algorithm)


def same(first: Run, second: Run) -> bool:
    rows = [[(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events] for run in (first, second)]
    tables = [[table.tobytes() for table in run.tables] for run in (first, second)]
    return rows[0] == rows[1] and tables[0] == tables[1] and first.failure == second.failure


@pytest.mark.parametrize("case", range(40))
def test_random_events_are_the_same_bits_compiled_interpreted_and_cut(case: int) -> None:
    plan = drawn(case)
    whole = simulate(plan)
    assert same(whole, simulate(plan, interpreted=True))
    draw = random.Random(case)
    with Session(plan) as session:
        while session.tick < plan.clock.stop and not session.over:
            session.advance(cycles=draw.randint(1, 4))
        assert same(whole, session.run())


@pytest.mark.parametrize("case", range(40))
def test_before_the_first_event_a_run_is_that_without_events(case: int) -> None:
    plan = drawn(case)
    run, sound = simulate(plan), simulate(without_events(plan))
    first = min((row.time for row in run.events), default=np.inf)
    for g, group in enumerate(run.plan.groups):
        others = {key: (h, k) for h, other in enumerate(sound.plan.groups) for k, key in enumerate(other.columns)}
        times = run.ticks[g] * float(plan.clock.seconds(1))
        before = times <= first * (1 + 1e-12) if first > 0.0 else np.zeros(len(times), dtype=bool)
        for k, key in enumerate(group.columns):
            if key in others and key[0] != "coupling":
                h, column = others[key]
                found, wanted = run.tables[g][:, k], sound.tables[h][:, column]
                assert found[before].tobytes() == wanted[: len(found)][before].tobytes(), key
