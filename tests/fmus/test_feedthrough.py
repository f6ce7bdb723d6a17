"""Between two steps an output answers at once to an input that was set, and nothing else is touched by that."""

from __future__ import annotations

from pathlib import Path

import pytest
from rovbrush.orchestrator.fmu import Fmu
from rovbrush.orchestrator.instances import load
from rovbrush.orchestrator.loaded import LoadedInstance


def started(path: Path) -> LoadedInstance:
    instance = load(Fmu.open(path), "one")
    instance.enter_initialization(1.0)
    instance.exit_initialization()
    return instance


def test_the_force_follows_the_speed_that_is_set(fmus: Path) -> None:
    wheel = started(fmus / "wheel.fmu")
    wheel.slave.doStep(0.0, 0.01)
    before = wheel.get("F"), wheel.get("z_w")
    wheel.set("v_c", 0.5)
    assert wheel.get("F") == pytest.approx(before[0] + 1000.0 * 0.5)
    assert wheel.get("z_w") == before[1]
    wheel.close()


def test_reading_between_set_and_step_does_not_change_the_step(fmus: Path) -> None:
    values = []
    for read in (False, True):
        wheel = started(fmus / "wheel.fmu")
        for k in range(20):
            wheel.set("v_c", 0.1 * k)
            if read:
                wheel.get("F")
            wheel.slave.doStep(0.01 * k, 0.01)
        values.append([wheel.get(name) for name in ("F", "z_w", "J")])
        wheel.close()
    assert values[0] == values[1]


def test_a_state_saved_behind_a_set_input_has_the_answer(fmus: Path) -> None:
    wheel = started(fmus / "wheel.fmu")
    wheel.slave.doStep(0.0, 0.01)
    wheel.set("v_c", 0.5)
    state = wheel.slave.getFMUState()
    force = wheel.get("F")
    wheel.set("v_c", 0.7)
    assert wheel.get("F") != force
    wheel.slave.setFMUState(state)
    assert wheel.get("F") == force and wheel.get("v_c") == 0.5
    wheel.slave.freeFMUState(state)
    wheel.close()
