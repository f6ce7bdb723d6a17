"""An autopilot as a component: its variables, as the files of an FMU would declare them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ...ardupilot.interface import Options, inputs_of, outputs_of
from .declared import Declared, DeclaredFmu, declared_fmu


def autopilot_fmu(name: str, options: Options) -> DeclaredFmu:
    """What is known of it before it is heard. It keeps its own time and state: steps of one length, nothing saved."""
    sides = (("input", inputs_of(options)), ("output", outputs_of(options)))
    variables = [
        Declared(scalar, causality, unit=signal.unit, description=signal.description, sampled=True)  # type: ignore[arg-type]
        for causality, signals in sides
        for signal in signals
        for scalar in signal.scalars
    ]
    path = Path(f"ArduSub at UDP {options.port}")
    found: DeclaredFmu = declared_fmu(
        name, variables, path, "link to an autopilot", settings=options, saves=False, writes=False, varies=False
    )
    where = f"UDP {options.host}:{options.port}"
    return replace(found, remark=f"{name} waits up to {options.timeout:g} s for an autopilot that sends to {where}")
