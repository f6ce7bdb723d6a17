"""FMUs made with pythonfmu save, serialize and restore their state, hidden arrays included."""

from __future__ import annotations

from pathlib import Path

import pytest
from pythonfmu_instance import every_component, started, stir
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.fmi2 import Fmi2Instance as Instance


@every_component
def test_saved_state_restores_bitwise(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as instance:
        stir(instance, 0, 7)
        state = instance.save()
        onward = stir(instance, 7, 12)
        instance.restore(state)
        assert stir(instance, 7, 12) == onward
        instance.forget(state)


@every_component
def test_serialized_state_continues_bitwise_in_another_instance(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as first:
        stir(first, 0, 7)
        state = first.save()
        content = first.serialize(state)
        onward = stir(first, 7, 12)
    with started(fmus / f"{name}.fmu") as second:
        stir(second, 0, 3)
        second.restore(second.deserialize(content))
        assert stir(second, 7, 12) == onward


@pytest.mark.parametrize("name", ["gain", "integrator"])
def test_serialized_state_starts_an_instance_that_was_never_initialized(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as first:
        stir(first, 0, 4)
        content = first.serialize(first.save())
        onward = stir(first, 4, 4)
    second = Instance(Fmu.open(fmus / f"{name}.fmu"), "second")
    second.restore(second.deserialize(content))
    assert stir(second, 4, 4) == onward
    second.close()


def test_state_saved_before_initialization_brings_back_the_start_values(fmus: Path) -> None:
    instance = Instance(Fmu.open(fmus / "integrator.fmu"), "test")
    instance.set("x_start", 5.0)
    state = instance.save()
    instance.set("x_start", 6.0)
    with instance.unguarded():  # FMI 2.0 allows no get before initialization
        assert instance.get("x") == 6.0
        instance.restore(state)
        assert instance.get("x") == 5.0
    instance.close()
