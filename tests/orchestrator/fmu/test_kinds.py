"""An FMU of several kinds is taken for the one that is chosen, or for co-simulation."""

from __future__ import annotations

from pathlib import Path

import pytest
from fmpy.model_description import CoSimulation, ModelDescription, ModelExchange, ScheduledExecution
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu import kinds
from rovbrush.orchestrator.fmu.kinds import interface_of, kinds_of, require_kind, usual_kind


def described(version: int, **interfaces: object) -> ModelDescription:
    return ModelDescription(fmiVersion=f"{version}.0", modelName="m", instantiationToken="t", **interfaces)


def test_co_simulation_is_taken_where_it_is_there_and_every_interface_is_found_by_its_kind() -> None:
    parts = {
        "coSimulation": CoSimulation(modelIdentifier="c"), "modelExchange": ModelExchange(modelIdentifier="m"),
        "scheduledExecution": ScheduledExecution(modelIdentifier="s"),
    }  # fmt: skip
    description = described(3, **parts)
    assert kinds_of(description) == ("co-simulation", "model-exchange", "scheduled-execution")
    assert usual_kind(description) == "co-simulation"
    assert [interface_of(description, kind).modelIdentifier for kind in kinds_of(description)] == ["c", "m", "s"]


def test_a_kind_that_an_fmu_has_not_is_refused_by_name() -> None:
    description = described(2, coSimulation=CoSimulation(modelIdentifier="c"))
    with pytest.raises(FmuError, match='is for co-simulation, not for model exchange; kind = "co-simulation"'):
        require_kind(Path("a.fmu"), description, "model-exchange")


def test_a_kind_that_cannot_be_run_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    both = {"coSimulation": CoSimulation(modelIdentifier="c"), "modelExchange": ModelExchange(modelIdentifier="m")}
    monkeypatch.setattr(kinds, "RUN", {(2, "co-simulation")})
    require_kind(Path("a.fmu"), described(2, **both))
    with pytest.raises(FmuError, match=r"model exchange of FMI 2.0 cannot be run; export it for co-simulation"):
        require_kind(Path("a.fmu"), described(2, **both), "model-exchange")
    with pytest.raises(FmuError, match="is for model exchange only; export it for co-simulation"):
        require_kind(Path("a.fmu"), described(2, modelExchange=ModelExchange(modelIdentifier="m")))
