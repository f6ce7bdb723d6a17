"""What cannot be written as C yet, found before anything is written: who or what it is, and what serves instead."""

from __future__ import annotations

from ..errors import InputError, listed
from ..fmu.kinds import CO_SIMULATION, WORDS
from ..fmu.types import BINARY, TEXT
from ..loop.operations import NAMES
from ..plan.algorithms.registry import ALGORITHMS, algorithm_of
from ..plan.plan import Plan
from ..system.model import System
from ..system.replace.view import crossings_of
from .code.operations.rows import WRITTEN

CONTAINER = "take --container, or an SSP (--ssp)"


def check_system(system: System) -> None:
    """Raise InputError for what a system of C cannot hold; before it is planned."""
    if system.events and not algorithm_of(system).one_pass:
        others = " and ".join(f"'{kind.name}'" for kind in ALGORITHMS if kind.one_pass)
        raise InputError(
            f"events with algorithm '{system.algorithm}' are not written as C, and the system has "
            f"{system.events[0].name} {system.events[0].where}; choose {others}, or take an SSP (--ssp)"
        )
    for name, component in system.components.items():
        fmu = component.fmu
        component.require_file("only FMUs can be written into one program")
        if fmu.version == 1 or fmu.kind != CO_SIMULATION:
            what = "of FMI 1.0" if fmu.version == 1 else f"taken for {WORDS[fmu.kind]}"
            raise InputError(
                f"component {name}: {fmu.path.name} is {what}, and FMUs of FMI 2.0 and 3.0 for co-simulation are "
                f"written as C; export it so, or the system as an SSP (--ssp)"
            )
        if component.elsewhere:
            raise InputError(
                f"component {name} runs at {component.isolation}, which no file can hold; take its FMU here: remove "
                f"isolation"
            )
        if crossings_of(fmu):
            raise InputError(
                f"component {name} has its variables mapped, which is not written as C; put the FMU itself in its "
                f"place, or export an SSP (--ssp)"
            )
        if fmu.structure:
            raise InputError(
                f"component {name}: structural parameters ({listed(fmu.structure)}) are not set in C; export an SSP "
                f"(--ssp)"
            )
    for c in system.connections:
        kind = system.components[c.source[0]].fmu.type_of(c.source[1])
        if kind is not None and kind.code in (TEXT, BINARY):
            raise InputError(
                f"connection {c.label} passes a {kind.name}, which is not done in C; {CONTAINER} {c.where}"
            )


def check_plan(plan: Plan) -> None:
    """Raise InputError for what its operations ask for that is not written as C."""
    for name, component in plan.system.components.items():
        if component.in_events:
            raise InputError(
                f'component {name}: its event mode is not written as C; event_mode = "off" under [components.{name}] '
                f"leaves it out, or {CONTAINER}"
            )
    for rows in (plan.cycle, plan.last):
        for code in rows[:, 0].tolist():
            if code not in WRITTEN:
                raise InputError(
                    f"the operation '{NAMES[code]}' of {plan.system.name} is not written as C; {CONTAINER}"
                )
