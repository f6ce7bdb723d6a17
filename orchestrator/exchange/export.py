"""`rovbrush export`: a system as a file for other tools, and what they cannot take from it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..clock import seconds_text
from ..plan.plan import Plan
from ..system.ssp.write import write_ssp
from .container import differences, write_container


@dataclass(frozen=True)
class Exported:
    """The file, what it is, and what its user must know."""

    path: Path
    kind: str
    notes: tuple[str, ...] = ()


def export_ssp(plan: Plan, path: Path, version: str) -> Exported:
    """Write the system as an SSP. Raises InputError or RunError."""
    write_ssp(plan.system, path, version)
    return Exported(path, f"SSP {version}")


def export_container(plan: Plan, path: Path) -> Exported:
    """Write the system as one FMU; the notes say what it does otherwise than the plan. Raises InputError, RunError."""
    notes = write_container(plan.system, path)
    slowest = max(component.period for component in plan.system.components.values())
    step = f"step it every {float(slowest):g} s"
    system = plan.system
    begin = (f"begin its run at {seconds_text(system.start)}",) if system.start else ()
    return Exported(path, "one FMU", (step, *begin, *differences(plan), *notes))
