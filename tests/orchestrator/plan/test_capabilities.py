"""What an FMU says it cannot do is an error before time 0, with the flag and a remedy."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from helpers import plan_of, read_system, system_text
from native_build import FREE2, feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.capabilities import require_state, require_variable_steps
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
FIXED = 'canHandleVariableCommunicationStepSize="false"'


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
def test_the_second_of_an_fmu_that_allows_one_per_process_gets_its_own(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "single.fmu", 'canBeInstantiatedOnlyOncePerProcess="true"', ONCE=1)
    parts = {"a": ("single", "1 ms", FREE2), "b": ("single", "1 ms", FREE2)}
    plan = plan_of(tmp_path, tmp_path, parts, stop="3 ms")
    assert [component.isolation for component in plan.system.components.values()] == ["", "process"]
    assert "canBeInstantiatedOnlyOncePerProcess" in explain(plan)
    assert not simulate(plan).failure
    text = system_text(parts, stop="3 ms").replace("[components.b]\n", '[components.b]\nisolation = "process"\n')
    (tmp_path / "two.toml").write_text(text, encoding="utf-8")
    assert not simulate(make_plan(load_system(str(tmp_path / "two.toml"), tmp_path))).failure


def test_a_fixed_step_must_be_the_one_that_is_declared(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "fixed.fmu", FIXED, '<DefaultExperiment stepSize="0.002"/>')
    with pytest.raises(InputError) as error:
        plan_of(tmp_path, tmp_path, {"a": ("fixed", "1 ms", FREE2)})
    for words in ("fixed.fmu", "canHandleVariableCommunicationStepSize = false", 'write period = "2 ms"', "case.toml"):
        assert words in str(error.value)
    text = explain(plan_of(tmp_path, tmp_path, {"a": ("fixed", "2 ms", FREE2)}))
    assert "fixed step" in text


def test_a_fixed_step_without_a_size_is_any_constant_one(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "fixed.fmu", FIXED)
    system = read_system(tmp_path, tmp_path, {"a": ("fixed", "3 ms", FREE2)}, stop="3 ms")
    assert make_plan(system).clock.periods == {"a": 1}
    with pytest.raises(InputError, match=r"component a: an adaptive algorithm needs steps of different lengths"):
        require_variable_steps(system.components["a"], "an adaptive algorithm")


def test_an_fmu_that_cannot_save_its_state_says_so(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "stateless.fmu", 'canGetAndSetFMUstate="false" canSerializeFMUstate="false"')
    system = read_system(tmp_path, tmp_path, {"a": ("stateless", "1 ms", FREE2)})
    fmu = system.components["a"].fmu
    assert not fmu.can_save_state and not fmu.can_serialize_state
    with pytest.raises(InputError, match=r"component a: iterated coupling needs to restore states, and stateless\.fmu"):
        require_state(system.components["a"], "iterated coupling")
    instance = load(fmu, "a")
    with pytest.raises(FmuError, match=r"component a: stateless\.fmu cannot save its state"):
        instance.save()
    instance.close()


def test_an_fmu_that_needs_its_tool_says_so_when_it_cannot_start(tmp_path: Path) -> None:
    path = feedthrough2(tmp_path / "tool.fmu", 'needsExecutionTool="true"', REFUSES=1)
    with pytest.raises(FmuError) as error:
        load(Fmu.open(path), "a")
    for words in (
        "component a: tool.fmu cannot be instantiated",
        "needsExecutionTool = true",
        "no licence for the tool",
    ):
        assert words in str(error.value)
