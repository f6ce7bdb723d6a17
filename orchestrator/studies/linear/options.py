"""What may be said of how a linear model is made, and what it means for a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ...clock import duration, seconds_text
from ...errors import InputError, nearest
from ...fmu.attributes import parse_value
from ...plan.plan import Plan
from ...system.model import System
from ...system.quantities import in_own_unit
from .channels import Channel
from .operating import ALLOWED

SAMPLES = 2000  # at most, of a response that does not die out
STARTS = 8  # of pulses over a period
METHODS = ("auto", "states", "pulses")


@dataclass(frozen=True)
class Options:
    """How a linear model is made; texts as on the command line, empty ones are the defaults."""

    at: Sequence[str] = ()
    sample: str = ""  # time between two samples; the hyperperiod
    length: str = ""  # of a response; until it has died out, SAMPLES at most
    sizes: Mapping[str, object] | None = None  # of what is added, by the channel's name
    order: int | None = None
    period_of: str = ""
    starts: int = STARTS
    residual: float = ALLOWED
    method: str = "auto"
    sampled: bool = False  # a continuous model as a sampled one too


def hyperperiod_of(plan: Plan) -> Fraction:
    """The time [s] in which the schedule repeats."""
    return plan.clock.seconds(plan.clock.hyperperiod)


def samples_of(text: str, one: Fraction, option: str) -> int:
    """A time in hyperperiods. Raises InputError where it is no whole number of them."""
    seconds = duration(text, option)
    if (seconds / one).denominator != 1:
        raise InputError(
            f"{option} {text}: it must be a multiple of {seconds_text(one)}, in which the schedule repeats"
        )
    return int(seconds / one)


def sizes_of(system: System, channels: Sequence[Channel], given: Mapping[str, object]) -> list[float | None]:
    """What is to be added to each channel, in its own unit; None where that was not said. Raises InputError."""
    known = {channel.name: channel for channel in channels} | {channel.target: channel for channel in channels}
    found: dict[str, float] = {}
    for name, value in given.items():
        full = system.full_name(name)
        channel = known.get(full)
        if channel is None:
            raise InputError(f"--size {name}: it is no input of the linear model{nearest(full, known)}")
        fmu, variable = system.components[channel.key[0]].fmu, channel.key[1]
        label = f"--size {name}"
        number = in_own_unit(fmu, variable, value, label, difference=True)
        size = float(parse_value(replace_bounds(fmu.variables[variable]), number, label, fmu.type_of(variable)))
        if size <= 0.0:
            raise InputError(f"{label} = {size:g} must be above 0")
        found[channel.name] = size
    return [found.get(channel.name) for channel in channels]


def replace_bounds(variable: Any) -> Any:
    """A variable whose differences may be anything."""
    from attrs import evolve

    return evolve(variable, min=None, max=None)
