"""A live pass along the hull: a current takes the brush off, force control brings it back; it replays bit by bit."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
from helpers import column
from rovbrush.orchestrator.live.driver import Driver
from rovbrush.orchestrator.live.messages import Do
from rovbrush.orchestrator.live.record import Record
from rovbrush.orchestrator.live.touch import Touch, touchable
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.events.read import events_of


def test_a_current_and_another_controller_by_hand_replay_bit_by_bit(native: Path) -> None:
    system = assemble("hull_pass", {"controller.mode": 0}, "16 s", native / "fmi2")
    plan = make_plan(touchable(system))
    with Session(plan) as session:
        driver = Driver(lambda: None, Record("hull_pass"))
        driver.session, driver.touch = session, Touch(plan)
        session.advance(cycles=1600)  # 8 s
        driver._do(Do("set", "vehicle.v_c[3]", -0.5))
        session.advance(cycles=1000)
        driver._do(Do("set", "controller.mode", 2))
        session.advance()
        live = session.run()
    time, delta = column(live, "vehicle.delta")
    assert delta[(time > 8.0) & (time < 10.0)].min() < 0.0, "the brush loses the hull"
    assert delta[time > 15.0].min() > 0.004, "force control has it back"
    entries = tomllib.loads(driver.record.toml())["events"]
    events = events_of(None, system.components, system.connections, entries)
    other = simulate(make_plan(replace(system, events=events)))
    for group, table in zip(other.plan.groups, other.tables, strict=True):
        for k, key in enumerate(group.columns):
            mine = np.ascontiguousarray(column(live, ".".join(key))[1])
            assert mine.tobytes() == np.ascontiguousarray(table[:, k]).tobytes(), key
