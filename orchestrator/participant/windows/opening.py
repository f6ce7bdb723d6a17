"""The class of an instance for Windows, by its version, its kind, and whether its events are handled."""

from __future__ import annotations

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...fmu.kinds import MODEL_EXCHANGE, SCHEDULED_EXECUTION
from .instance import Windows1Instance, Windows2Instance, Windows3Instance, WindowsInstance

KINDS: dict[int, type[WindowsInstance]] = {1: Windows1Instance, 2: Windows2Instance, 3: Windows3Instance}


def windows_class(fmu: Fmu, in_events: bool) -> type[WindowsInstance]:
    """What runs an FMU under wine; one with clocks needs event mode, whoever runs it.

    Raises FmuError for model exchange of FMI 1.0.
    """
    if fmu.kind == MODEL_EXCHANGE:
        if fmu.version == 1:
            raise FmuError(
                f"FMU {fmu.path}: model exchange of FMI 1.0 is not run under wine; ask for a library of this platform, "
                "or for an export as co-simulation or as a later version"
            )
        from .exchange import Windows2Member, Windows3Member

        return Windows2Member if fmu.version == 2 else Windows3Member
    if fmu.kind == SCHEDULED_EXECUTION:
        from .events import WindowsScheduled

        return WindowsScheduled
    if in_events or fmu.own.clocks:
        from .events import WindowsEvents

        return WindowsEvents
    return KINDS[fmu.version]
