"""What is asked for often is found quicker, and is the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from pythonfmu_instance import H, started


@pytest.mark.parametrize("order", ["as declared", "backwards", "every other", "one", "twice the same", "none"])
def test_values_are_the_same_in_whatever_order_and_however_often_they_are_asked_for(order: str, fmus: Path) -> None:
    with started(fmus / "dc_motor.fmu", V_in=12.0) as motor:
        described = motor.fmu.variables
        outputs = [described[name].valueReference for name in motor.fmu.names("output")]
        asked = {
            "as declared": outputs,
            "backwards": outputs[::-1],
            "every other": outputs[::2],
            "one": outputs[3:4],
            "twice the same": [outputs[2], outputs[2]],
            "none": [],
        }[order]
        for k in range(4):
            motor.set("T_brush", 0.1 * k)
            motor.step(k * H, H)
            each = [motor.slave.getReal([reference])[0] for reference in asked]
            assert motor.slave.getReal(asked) == each
            assert motor.slave.getReal(asked) == each
            motor.set("T_brush", 0.3 * k)  # outputs answer at once
            again = motor.slave.getReal(asked)
            assert again == [motor.slave.getReal([reference])[0] for reference in asked]
            motor.slave.setReal([], [])


def test_inputs_may_be_set_in_any_order_between_steps(fmus: Path) -> None:
    runs = []
    for names in (["V_in", "T_brush"], ["T_brush", "V_in"]):
        with started(fmus / "dc_motor.fmu") as motor:
            rows = []
            for k in range(6):
                values = {"V_in": 12.0 - k, "T_brush": 0.2 * k}
                motor.slave.setReal([motor.fmu.variables[n].valueReference for n in names], [values[n] for n in names])
                motor.step(k * H, H)
                rows.append(motor.slave.getReal([motor.fmu.variables["omega_b"].valueReference]))
            runs.append(rows)
    assert runs[0] == runs[1]
    assert runs[0][0] != runs[0][-1]
