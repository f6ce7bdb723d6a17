"""Systems to sweep over, and sweeps that run in a process of their own."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from helpers import Part, system_text
from rovbrush.orchestrator.studies.sweep.design.design import Design, make_design, vary_entries
from rovbrush.orchestrator.system.file.reader import load_system

SUMMARY = '\n[summary]\nwindow = { start = 0.005 }\nx_last = "last x.x"\ny_mean = "mean x.held"\n'
PARTS: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0}), "x": ("integrator", "1 ms")}


def plain_case(folder: Path, stop: str = "10 ms", mode: int = 0) -> Path:
    """A stranger's FMU whose `mode` decides what goes wrong."""
    path = folder / "plain.toml"
    start = {"mode": mode, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    path.write_text(system_text({"p": ("plain", "1 ms", start)}, stop=stop) + '\n[summary]\ny_last = "last p.y"\n')
    return path


def design_of(path: Path, fmus: Path, *vary: str, **keys: Any) -> Design:
    return make_design(load_system(str(path), fmus), vary_entries(vary), **keys)


def begun(system: Path, fmus: Path, out: Path, points: int) -> subprocess.Popen[str]:
    """A sweep in a process group of its own that has finished some points."""
    command = [sys.executable, "-m", "rovbrush.orchestrator", "sweep", str(system), "--vary", "p.u=0:1:40", "--out",
               str(out), "--fmus", str(fmus), "--workers", "2"]  # fmt: skip
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    until = time.monotonic() + 60.0
    while lines(out) < 1 + points:
        assert process.poll() is None and time.monotonic() < until, process.communicate(timeout=10)
        time.sleep(0.02)
    return process


def lines(out: Path) -> int:
    path = out / "points.jsonl"
    return path.read_bytes().count(b"\n") if path.is_file() else 0


def running(pid: int) -> bool:
    """Whether a process is there and no mere entry of one that ended."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False
