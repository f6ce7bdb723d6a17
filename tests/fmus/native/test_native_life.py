"""What a native FMU has refused it refuses again, as long as the reason is there."""

from __future__ import annotations

from pathlib import Path

import pytest
from fmpy import extract, read_model_description
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from rovbrush.components.build import COMPONENTS


@pytest.mark.parametrize("name", COMPONENTS)
def test_an_initialization_that_was_refused_is_not_accepted_the_second_time(name: str, native: Path) -> None:
    """Inputs from which outputs follow that are no numbers; with good ones it goes on."""
    fmu = str(native / "fmi2" / f"{name}.fmu")
    description = read_model_description(fmu)
    slave = FMU2Slave(guid=description.guid, unzipDirectory=extract(fmu), instanceName="x",
                      modelIdentifier=description.coSimulation.modelIdentifier)  # fmt: skip
    slave.instantiate()
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    reals = [v for v in description.modelVariables if v.causality == "input" and v.type == "Real"]
    slave.setReal([v.valueReference for v in reals], [1.7e308] * len(reals))
    for _ in range(3):
        try:
            slave.exitInitializationMode()
        except FMICallException:
            continue
        break
    else:
        slave.setReal([v.valueReference for v in reals], [float(v.start) for v in reals])
        slave.exitInitializationMode()
    outputs = [v.valueReference for v in description.modelVariables if v.causality == "output" and v.type == "Real"]
    assert all(abs(value) < float("inf") for value in slave.getReal(outputs))
    slave.freeInstance()
