"""Between two steps an output answers at once to an input that was set, and nothing else is touched by that."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.loaded import LoadedInstance
from rovbrush.orchestrator.participant.opening import load
from test_native_equality import CASES


def started(path: Path) -> LoadedInstance:
    instance = load(Fmu.open(path), "one")
    instance.begin(1.0)
    instance.exit_initialization()
    return instance


def test_the_force_follows_the_speed_that_is_set(fmus: Path) -> None:
    wheel = started(fmus / "wheel.fmu")
    wheel.step(0.0, 0.01)
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
            wheel.step(0.01 * k, 0.01)
        values.append([wheel.get(name) for name in ("F", "z_w", "J")])
        wheel.close()
    assert values[0] == values[1]


def test_a_state_saved_behind_a_set_input_has_the_answer(fmus: Path) -> None:
    wheel = started(fmus / "wheel.fmu")
    wheel.step(0.0, 0.01)
    wheel.set("v_c", 0.5)
    state = wheel.save()
    force = wheel.get("F")
    wheel.set("v_c", 0.7)
    assert wheel.get("F") != force
    wheel.restore(state)
    assert wheel.get("F") == force and wheel.get("v_c") == 0.5
    wheel.forget(state)
    wheel.close()


@pytest.mark.parametrize("name", CASES)
def test_python_and_native_fmus_answer_with_the_same_bits(name: str, fmus: Path, native: Path) -> None:
    """Read behind every set and every step, and once more behind a state that was saved between the two."""
    h, ranges = CASES[name]
    seen = []
    for path in (fmus / f"{name}.fmu", native / "fmi2" / f"{name}.fmu", native / "fmi3" / f"{name}.fmu"):
        generator = np.random.default_rng(7)
        instance = started(path)
        outputs, found = instance.fmu.names("output"), []
        for k in range(40):
            changing = [v for v in instance.fmu.names("input") if v.split("[")[0] in ranges]
            instance.set_all({v: float(generator.uniform(*ranges[v.split("[")[0]])) for v in changing})
            state = instance.save()
            found += [instance.get(v) for v in outputs]
            instance.step(k * h, h)
            found += [instance.get(v) for v in outputs]
            instance.restore(state)
            instance.forget(state)
            found += [instance.get(v) for v in outputs]
            instance.step(k * h, h)
        seen.append(np.array(found, dtype=float).tobytes())
        instance.close()
    assert seen[0] == seen[1] == seen[2]
