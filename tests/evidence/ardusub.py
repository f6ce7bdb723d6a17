"""An autopilot at 400 Hz in lock-step with a vehicle: ten minutes as fast as they go, one minute in real time."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
from pathlib import Path
from unittest.mock import patch

import numpy as np
from helpers import FIXTURES
from rovbrush.components.build import HERE, build
from rovbrush.orchestrator import load
from rovbrush.orchestrator.participant.ardusub import link
from rovbrush.orchestrator.run.pacing.pace import Pace

NAME = "ardusub"
CLAIM = "a fake autopilot in a process of its own, at 400 Hz: no frame is lost or doubled in 10 min, nor in 1 min at 1x"
COUNT = 2
UNIT = "runs"
LIMIT = 1800.0
SAMPLE = 0
FINITE = True
SAYS = True

RUNS = ((600, None), (60, Pace()))  # s of simulated time, and how they pass


def prepare(folder: Path) -> None:
    for name in ("rov_vehicle", "rov_sensors"):
        build(HERE / name, folder, 0, ("linux64",))


def one(index: int, folder: Path) -> str:
    seconds, pace = RUNS[index]
    fmus = next(path.parent for path in folder.parent.rglob("native/fmi2/rov_vehicle.fmu"))
    fakes: list[subprocess.Popen[str]] = []
    real = link.listening

    def listening(host: str, _port: int) -> socket.socket:
        """At a port that the system chooses; the autopilot is told which."""
        opened = real(host, 0)
        command = [sys.executable, FIXTURES / "fake_autopilot.py", "--port", str(opened.getsockname()[1])]
        fakes.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
        return opened

    system = load(FIXTURES / "vehicle_and_autopilot.toml", fmus=fmus, stop=f"{seconds} s", record=["autopilot.frame"])
    with patch.object(link, "listening", listening):
        result = system.run() if pace is None else system.run(pace=pace)
    fakes[0].send_signal(signal.SIGINT)
    heard, _ = fakes[0].communicate(timeout=60.0)
    frames = result["autopilot.frame"].values
    notes = [note for note in result.run.notes if "frames" in note]
    how = "as fast as it goes" if pace is None else "at 1x"
    print(f"{seconds} s {how}, {result.run.wall:.1f} s on the wall: {'; '.join(notes)}; the autopilot: {heard.strip()}")
    if result.run.lateness is not None:
        print("\n".join(result.run.lateness.words()), flush=True)
    count = seconds * 400
    wrong = []
    if not np.array_equal(frames, np.arange(count + 1)):
        wrong.append("rows do not have each frame once")
    if not any(f"{count + 1} frames, 0 lost, 0 doubled;" in note for note in notes):
        wrong.append(str(notes))
    if f"{count} frames answered, 0 of them twice, 0 at an odd time" not in heard:
        wrong.append(heard)
    return "; ".join(wrong)
