"""Time, the independent variable of a native FMI 3.0 FMU, is read as any other variable is, and never set."""

from __future__ import annotations

from pathlib import Path

import pytest
from driven import DrivenFmu
from fmpy.fmi1 import FMICallException
from helpers import plan_of
from rovbrush.components.build import COMPONENTS
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.simulation import simulate

STEP = 0.001  # s


def driven(native: Path, name: str, folder: Path) -> tuple[DrivenFmu, dict[str, int]]:
    fmu = DrivenFmu(native / "fmi3" / f"{name}.fmu", folder, {})
    return fmu, {v.name: v.valueReference for v in fmu.description.modelVariables}


@pytest.mark.parametrize("name", COMPONENTS)
def test_time_is_read_together_with_other_variables(name: str, native: Path, tmp_path: Path) -> None:
    fmu, references = driven(native, name, tmp_path / "fmu")
    fmu.start({})
    fmu.slave.doStep(0.0, STEP)
    time = references["time"]
    outputs = [v for v in fmu.description.modelVariables if v.causality == "output" and v.type == "Float64"]
    expected: list[float] = []
    for v in outputs:
        size = int(v.dimensions[0].start) if v.dimensions else 1
        expected += [STEP, *fmu.slave.getFloat64([v.valueReference], nValues=size)]
    wanted = [reference for v in outputs for reference in (time, v.valueReference)]
    assert fmu.slave.getFloat64([*wanted, time], nValues=len(expected) + 1) == [*expected, STEP]
    fmu.close()


def test_time_begins_at_the_start_and_follows_the_state(native: Path, tmp_path: Path) -> None:
    fmu, references = driven(native, "dc_motor", tmp_path / "fmu")
    both = [references["time"], references["i"]]
    fmu.slave.reset()
    fmu.slave.enterInitializationMode(startTime=2.0)
    assert fmu.slave.getFloat64(both)[0] == 2.0
    fmu.slave.exitInitializationMode()
    state = fmu.slave.getFMUState()
    fmu.slave.doStep(2.0, 0.5)
    assert fmu.slave.getFloat64(both)[0] == 2.5
    fmu.slave.setFMUState(state)
    assert fmu.slave.getFloat64(both)[0] == 2.0
    fmu.slave.freeFMUState(state)
    fmu.close()


@pytest.mark.parametrize("call", ["setFloat64", "getInt32", "getBoolean"])
def test_time_is_neither_set_nor_another_type(call: str, native: Path, tmp_path: Path) -> None:
    fmu, references = driven(native, "dc_motor", tmp_path / "fmu")
    fmu.start({})
    with pytest.raises(FMICallException):
        getattr(fmu.slave, call)([references["time"]], *([[3.0]] if call == "setFloat64" else []))
    assert fmu.slave.getFloat64([references["time"]]) == [0.0]
    fmu.close()


def test_time_is_recorded_with_other_signals(native: Path, tmp_path: Path) -> None:
    parts = {"motor": ("dc_motor", "1 ms", {"=V_in": 12.0, "=T_brush": 0.0})}
    plan = plan_of(tmp_path, native / "fmi3", parts, stop="5 ms", record=["motor.time", "motor.i"])
    signals = Signals(simulate(plan))
    assert list(signals["motor.time"].values) == list(signals["motor.time"].time)
    assert signals["motor.i"].values[-1] > 0.0
