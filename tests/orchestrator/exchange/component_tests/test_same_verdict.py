"""`test-component` and `run --replace` agree on whether an FMU fits, where the system needs what a system needs."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import Part, edited, read_system
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.component_tests.verdicts import make_bench
from rovbrush.orchestrator.system.assemble import apply_changes
from rovbrush.orchestrator.system.request import changes_of

PARTS: dict[str, Part] = {
    "motor": ("dc_motor", "0.5 ms", {"=V_in": 12.0}),
    "brush": (
        "filament_brush",
        "0.5 ms",
        {"=delta": -0.02, "=delta_dot": 0.0, "=v_rov": 0.0, "=friction_scale": 1.0, "=tilt_x": 0.0},
    ),
}
WIRES = ["motor.omega_b -> brush.omega_b", "brush.T_brush -> motor.T_brush"]
SPEED = 'name="omega_b" valueReference="20" description="brush speed" causality="output"'
VOLTAGE = 'name="V_in" valueReference="16" description="input voltage"'
RESISTANCE = 'causality="parameter" variability="fixed" initial="exact">\n\t\t\t<Real unit="Ohm"'
NONE = RESISTANCE.replace("parameter", "local").replace("exact", "calculated")
BOUNDS = ' min="0.0001" max="100.0" nominal="0.08"'
SURPLUS = (
    '<ScalarVariable name="heat" valueReference="900" causality="input" variability="continuous"><Real start="1.5"/>'
    "</ScalarVariable></ModelVariables>"
)
CASES: dict[str, tuple[dict[str, str], str, bool]] = {
    "as it is": ({}, "", True),
    "an input with another name": ({VOLTAGE: VOLTAGE.replace("V_in", "u_a")}, "", False),
    "an input that is mapped": ({VOLTAGE: VOLTAGE.replace("V_in", "u_a")}, '[variables]\nV_in = "u_a"', True),
    "an input that is said to be missing": ({VOLTAGE: VOLTAGE.replace("V_in", "u_a")}, '[variables]\nV_in = ""', True),
    "a surplus input": ({"</ModelVariables>": SURPLUS}, "", True),
    "an output that is said to be missing": (
        {SPEED: SPEED.replace("omega_b", "n")}, '[variables]\nomega_b = ""', False),
    "an output with another name": ({SPEED: SPEED.replace("omega_b", "n")}, "", False),
    "another unit of the same kind": ({VOLTAGE: VOLTAGE, '<Real unit="V" start': '<Real unit="mV" start',
        "<UnitDefinitions>": '<UnitDefinitions><Unit name="mV"/>'}, "", True),
    "a unit of another kind": ({'<Real unit="V" start': '<Real unit="kg" start',
        "<UnitDefinitions>": '<UnitDefinitions><Unit name="kg"/>'}, "", False),
    "a parameter that is calculated there": ({f'{RESISTANCE}{BOUNDS} start="0.08"': f"{NONE}{BOUNDS}"}, "", True),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_both_say_the_same(case: str, tmp_path: Path, fmus: Path) -> None:
    xml, mapping, fits = CASES[case]
    theirs, path = edited(fmus / "dc_motor.fmu", tmp_path / "their.fmu", {}, xml), tmp_path / "map.toml"
    path.write_text(mapping)
    bench = make_bench(theirs, "dc_motor", path)
    assert (not bench.comparison.failures) == fits, bench.comparison.failures
    system = read_system(tmp_path, fmus, PARTS, WIRES)
    changes = changes_of([f"motor={theirs}"], [f"motor={path}"], [])
    if fits:
        assert "motor" in apply_changes(system, changes).components
    else:
        with pytest.raises(InputError):
            apply_changes(system, changes)
