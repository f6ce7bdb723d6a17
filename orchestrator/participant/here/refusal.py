"""Why an FMU cannot be instantiated, in words for its user."""

from __future__ import annotations

import re

from ...errors import FmuError
from ...fmu.fmu import Fmu

NOT_LOADED = re.compile(r"Failed to load shared library \S+\. *(?P<reason>.*)", re.DOTALL)  # as fmpy says it
# What the system says of a library that it does not load, and what helps.
REASONS = (
    (r"(?P<it>\S+): cannot open shared object file",
     "it needs {it}, which this machine lacks: install what brings that library, or ask for an FMU that carries it"),
    (r"version `(?P<it>[^']+)' not found",
     "it was built for a newer system than this one ({it}): ask for one that is built for older systems"),
    (r"undefined symbol: (?P<it>\S+)",
     "it uses {it}, which neither it nor any library that it names has: its maker must link it with what has that"),
    (r"invalid ELF header|file too short|wrong ELF class|Exec format error|not a mach-o file|incompatible architecture",
     "that file is no library for this machine: its maker must put the right one there"),
)  # fmt: skip


class NotLoadedError(FmuError):
    """The library of an FMU cannot be loaded; `mend`: what helps, empty where nobody knows."""

    def __init__(self, message: str, mend: str) -> None:
        super().__init__(message)
        self.mend = mend


def refused(fmu: Fmu, name: str, error: Exception, log: str) -> FmuError:
    """The error of an FMU that cannot be instantiated."""
    said = f"component {name}: {fmu.path.name} cannot be instantiated: "
    if found := NOT_LOADED.search(str(error)):
        mend = _mend(found["reason"])
        return NotLoadedError(
            f"{said}its library, {fmu.library.name}, cannot be loaded: {found['reason']}{mend and f'; {mend}'}", mend
        )
    tool = ""
    if fmu.interface.needsExecutionTool:
        made = fmu.description.generationTool or "the tool that made it"
        tool = f"; it needs {made} on this machine, installed and licensed (needsExecutionTool = true)"
    return FmuError(f"{said}{error}{tool}{log}")


def _mend(reason: str) -> str:
    for pattern, mend in REASONS:
        if found := re.search(pattern, reason):
            return mend.format(**found.groupdict())
    return ""
