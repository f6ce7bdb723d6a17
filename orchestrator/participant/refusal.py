"""Why an FMU cannot be instantiated, in words for its user."""

from __future__ import annotations

from ..errors import FmuError
from ..fmu.fmu import Fmu


def refused(fmu: Fmu, name: str, error: Exception, log: str) -> FmuError:
    """The error of an FMU that cannot be instantiated."""
    tool = ""
    if fmu.interface.needsExecutionTool:
        made = fmu.description.generationTool or "the tool that made it"
        tool = f"; it needs {made} on this machine, installed and licensed (needsExecutionTool = true)"
    return FmuError(f"component {name}: {fmu.path.name} cannot be instantiated: {error}{tool}{log}")
