"""`rovbrush export`: a system as a file for other tools, and what they cannot take from it."""

from __future__ import annotations

from pathlib import Path

from ..cli.console import console
from ..plan.plan import Plan
from ..system.ssp.write import write_ssp
from .container import differences, write_container


def export_ssp(plan: Plan, path: Path, version: str) -> Path:
    """Write the system as an SSP. Raises InputError or RunError."""
    write_ssp(plan.system, path, version)
    console.print(f"wrote {path} (SSP {version}, {path.stat().st_size // 1000} kB)", markup=False)
    return path


def export_container(plan: Plan, path: Path) -> Path:
    """Write the system as one FMU and say what it does otherwise than the plan. Raises InputError or RunError."""
    notes = write_container(plan.system, path)
    slowest = max(component.period for component in plan.system.components.values())
    console.print(f"wrote {path} ({path.stat().st_size // 1000} kB); step it every {float(slowest):g} s", markup=False)
    for note in (*differences(plan), *notes):
        console.print(note, markup=False)
    return path
