"""Events of the system file as C: at times and at crossings, on components that can be brought there and on others."""

from __future__ import annotations

from pathlib import Path

import pytest
from emit_cases import PARTS, WIRES, alone, differing, run_of_system, tables_of, unlike
from helpers import edited, system_text
from native_build import needs_gcc
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
FIXED = {'canHandleVariableCommunicationStepSize="true"': 'canHandleVariableCommunicationStepSize="false"'}
EVENTS = """
[[events]]
name = "early"
at = "0 s"
fault = "bias"
on = "f.v1"
value = 0.25
for = "7.3 ms"

[[events]]
name = "between"
at = "10.37 ms"
set = { "b.m" = 2.5, "a.m" = 1.25 }

[[events]]
name = "noise"
at = "20 ms"
fault = "noise"
on = "f.x2"
value = 0.01
seed = 7
until = "33.1 ms"

[[events]]
name = "held"
at = "25 ms"
fault = "hold"
on = "a.x"
for = "9 ms"

[[events]]
name = "lost"
at = "41/800 s"
fault = "loss"
on = "b.F"
value = 0.5
for = "6 ms"

[[events]]
name = "crossing"
when = "f.F > -3.9"
after = "1.5 ms"
repeat = true
set = { "f.k" = 44.0 }

[[events]]
name = "back"
when = "a.x < 0.0985"
fault = "scale"
on = "f.v2"
value = 1.5
for = "4.25 ms"
"""


def eventful(folder: Path, carried: Path, late: str = "", stop: str = "0.1 s", **keys: object) -> System:
    """Two masses and their force with all kinds of events; `late`: an FMU whose step cannot vary."""
    for name in ("mass", "force"):
        changes = dict(FIXED) if name == late else {}
        tunable = {'causality="parameter" variability="fixed"': 'causality="parameter" variability="tunable"'}
        edited(carried / f"{name}.fmu", folder / f"{name}.fmu", {}, {**changes, **tunable})
    wires = WIRES if late else [wire.replace(" (mean)", "") for wire in WIRES]  # nobody waits for a mean
    text = system_text(PARTS, wires, stop, **{"algorithm": "gauss-seidel"} | keys)
    (folder / "case.toml").write_text(text + EVENTS)
    return load_system(str(folder / "case.toml"), folder)


@pytest.mark.parametrize(("late", "stop"), [("", "0.1 s"), ("mass", "0.1 s"), ("force", "0.1 s"), ("", "62.5 ms")])
def test_events_of_all_kinds_are_those_of_the_run(late: str, stop: str, carried: Path, tmp_path: Path) -> None:
    system = eventful(tmp_path, carried, late, stop)
    run = run_of_system(system)
    happened = " ".join(str(row) for row in run.events)
    assert all(name in happened for name in ("early", "between", "noise", "held", "lost", "crossing", "back"))
    assert differing(tables_of(system, tmp_path / "c"), run) == []


def test_one_fmu_has_the_events_too(carried: Path, tmp_path: Path) -> None:
    system = eventful(tmp_path, carried, algorithm="jacobi")
    export_fmu(system, tmp_path / "whole.fmu")
    assert unlike(alone(tmp_path / "whole.fmu"), run_of_system(system)) == []
