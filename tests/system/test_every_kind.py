"""One system file with all kinds: Model Exchange with events, a clocked controller of FMI 3.0, a library for Windows
that wine runs, and the brush."""

from __future__ import annotations

import math
import shutil
import zipfile
from pathlib import Path

import clock_build
import exchange_build
import pytest
from helpers import edited
from native_build import needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system
from windows_build import needs_wine

pytestmark = [needs_gcc, needs_wine]
SYSTEM = """
format = 2
description = "a ball for Model Exchange, a drive for Windows, a clocked controller, and the brush"
stop_time = "0.6 s"
connections = [
  "ball.h -> controller.y", "controller.u -> motor.V_in", "motor.omega_b -> brush.omega_b",
  "brush.T_brush -> motor.T_brush",
]
[solver]
tolerance = 1e-10
[components.ball]
fmu = "ball.fmu"
period = "10 ms"
parameters = { e = 0.5 }
[components.controller]
fmu = "controller.fmu"
period = "10 ms"
parameters = { r = 12.0 }
[components.motor]
fmu = "motor.fmu"
period = "0.5 ms"
[components.brush]
fmu = "brush.fmu"
period = "0.5 ms"
inputs = { delta = "5 mm" }
"""
G, E = 9.81, 0.5


def height(t: float) -> float:
    """Of the ball that falls from 1 m, before its second impact."""
    first = math.sqrt(2.0 / G)
    return 1.0 - G * t * t / 2.0 if t < first else E * G * first * (t - first) - G * (t - first) ** 2 / 2.0


def test_all_kinds_run_in_one_plan(tmp_path: Path, native: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    own = native / "fmi2"
    exchange_build.exchange(tmp_path, "ball")
    clock_build.clocked(tmp_path / "controller.fmu", "controller")
    shutil.copy(own / "filament_brush.fmu", tmp_path / "brush.fmu")
    with zipfile.ZipFile(own / "dc_motor.fmu") as archive:
        linux = {name: None for name in archive.namelist() if name.startswith("binaries/linux")}
    edited(own / "dc_motor.fmu", tmp_path / "motor.fmu", linux)
    path = tmp_path / "system.toml"
    path.write_text(SYSTEM, encoding="utf-8")

    text = explain(make_plan(load_system(str(path), tmp_path)))
    for words in ("which wine runs", "model exchange", "tick", "ball.h -> controller.y"):
        assert words in text, words

    result = load(path).run()
    assert result.summary["complete"]
    for t in (0.1, 0.4, 0.5, 0.6):
        assert float(result["ball.h"].sel(time=t)) == pytest.approx(height(t), abs=1e-9)
    assert int(result["controller.ticks"][-1]) == 37  # at 0, 1/60 s ... 36/60 s
    speed = float(result["motor.omega_b"][-1])
    assert math.isfinite(speed) and speed > 0.0 and float(result["brush.T_brush"].min()) < 0.0
