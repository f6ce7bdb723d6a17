"""A system's linear model at times of a run: from saved states, by pulse responses, or by derivatives of states."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil
from typing import Any

import numpy as np

from ...clock import duration, seconds_text
from ...errors import InputError, nearest
from ...fmu.attributes import parse_value
from ...plan.plan import Plan, make_plan
from ...system.model import System
from ...system.quantities import in_own_unit
from .by_states import by_states, why_not_by_states
from .channels import Channel, channels_of, free_inputs, signals_of
from .operating import (
    ALLOWED,
    period_in,
    require_angle,
    require_steady,
    residuals,
    starts_in,
    ticks_of,
    times_of,
)
from .probe import Probe, require_states
from .pulses import Pulses, pulses_from, size_of
from .realise import realise
from .statespace import Linear

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


@dataclass(frozen=True)
class Point:
    """One operating point: the responses there, and what was found of it."""

    time: float
    dt: float
    pulses: Pulses
    notes: dict[str, Any]


def linearise(
    system: System, inputs: Sequence[str] = (), outputs: Sequence[str] = (), options: Options = Options(),
    progress: Callable[[float], None] = lambda _share: None,
) -> list[Linear]:  # fmt: skip
    """The models at all times of `options.at`, rising.

    `inputs`: free inputs, or connections `a.y -> b.u`, to whose signal something is added; `outputs`: signals, or
    patterns. A system of one component needs neither: all of them are meant. Raises InputError for names that cannot be
    meant, times outside the run, FMUs that cannot save their states, an operating point that is none; RunError.
    """
    if options.method not in METHODS:
        raise InputError(f"--method {options.method}: there are {', '.join(METHODS)}{nearest(options.method, METHODS)}")
    inputs, outputs = _all_of_one(system, inputs, outputs)
    channels = channels_of(system, inputs, "--inputs")
    signals = signals_of(system, outputs, "--outputs")
    if not signals:
        raise InputError("--outputs: name at least one signal")
    why_not = why_not_by_states(system, channels)
    if options.method == "states" and why_not:
        raise InputError(f"--method states: {why_not}")
    if options.method != "pulses" and not why_not:
        models = by_states(system, channels, signals, times_of(system, options.at), options.residual)
        if options.sampled or options.sample:
            dt = duration(options.sample, "--sample") if options.sample else hyperperiod_of(make_plan(system))
            models = [model.sampled(float(dt)) for model in models]
        return models
    if not channels:
        raise InputError("--inputs: pulse responses need an input that nothing drives, or a connection")
    return [
        realised(point, [c.name for c in channels], signals, [c.unit for c in channels], system, options.order)
        for point in points(system, channels, signals, options, False, progress)
    ]


def realised(
    point: Point, inputs: Sequence[str], outputs: Sequence[str], units: Sequence[str], system: System, order: int | None
) -> Linear:
    """The model of the responses at a point."""
    found = realise(point.pulses.values, order)
    notes = {
        **point.notes, "method": "pulses", "order": len(found.A), "singular_values": found.singular[:40].tolist(),
        "error": found.error, "even": point.pulses.even, "sizes": list(point.pulses.sizes),
        "samples": len(point.pulses.values),
    }  # fmt: skip
    D = point.pulses.values[0].copy()
    return Linear(
        found.A, found.B, found.C, D, point.dt, tuple(inputs), tuple(outputs), tuple(units),
        tuple(unit_of(system, name) for name in outputs), (), point.time, notes,
    )  # fmt: skip


def points(
    system: System, channels: Sequence[Channel], signals: Sequence[str], options: Options, over_the_step: bool,
    progress: Callable[[float], None] = lambda _share: None,
) -> list[Point]:  # fmt: skip
    """The responses of `signals` to `channels` at all operating points; see `pulses_from` for `over_the_step`."""
    times = times_of(system, options.at)
    require_states(system)
    angle = require_angle(system, options.period_of)
    plan = make_plan(system)
    if plan.adaptive:
        raise InputError(
            f"with algorithm '{system.algorithm}' steps vary, so there is no map from sample to sample; take another "
            "algorithm, for instance gauss-seidel"
        )
    clock, one = plan.clock, hyperperiod_of(plan)
    every = samples_of(options.sample, one, "--sample") if options.sample else 1
    length = max(samples_of(options.length, one, "--length") // every, 4) if options.length else None
    stated = sizes_of(system, channels, options.sizes or {})
    ticks = [ticks_of(clock, system.start, time) for time in times]
    span = 3 * (length or SAMPLES) * every + 4 * every
    longer = replace(system, stop=max(system.stop, ceil((times[-1] + 2 * span * one) / one) * one + system.start))
    found = []
    with Probe(longer, channels, [*signals, *(a for a in angle if a not in signals)], every) as probe:
        count = len(signals)
        for k, tick in enumerate(ticks):
            probe.session.finish(until_tick=tick)
            probe.require_alive()
            here = probe.keep()
            period = period_in(probe, options.period_of)
            probe.back(here)
            kept, gone = [], 0
            for start in starts_in(period, max(options.starts, 1)):
                for _ in range(start - gone):
                    probe.session.step()
                gone = start
                kept.append(probe.keep())
            sizes = [
                size_of(c, float(probe.session.get(c.target)), value) for c, value in zip(channels, stated, strict=True)
            ]
            probe.of_instants = over_the_step and all(probe.at_once.values())
            over = over_the_step and not probe.of_instants
            share = lambda part, k=k: progress((k + part) / len(ticks))  # noqa: E731
            pulses = pulses_from(probe, kept, sizes, length, SAMPLES, count, over, share)
            probe.back(here)
            largest = np.max(np.abs(pulses.values) * np.array(sizes), axis=(0, 2))
            scale = np.concatenate([largest, np.full(len(probe.signals) - count, 1.0)])
            window = len(pulses.values) // 2
            turns = -(-period // every)
            window = max(round(window * every / period), 1) * period // every if period else max(window, 1)
            steady = residuals(probe, window, turns, scale)
            require_steady(steady, clock.time(tick), options.residual, window * probe.dt)
            probe.back(here)
            for each in (*kept, here):
                each.release()
            notes = {
                "residual": steady[0].value, "residual_of": steady[0].signal, "starts": len(kept),
                "period": float(period * one),
            }  # fmt: skip
            found.append(Point(clock.time(tick), probe.dt, pulses, notes))
    return found


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


def unit_of(system: System, name: str) -> str:
    """The unit of a signal."""
    owner, _, variable = name.partition(".")
    return system.components[owner].fmu.variables[variable].unit or "1"


def _all_of_one(
    system: System, inputs: Sequence[str], outputs: Sequence[str]
) -> tuple[Sequence[str], Sequence[str]]:  # fmt: skip
    """What is meant where nothing is named. Raises InputError where that cannot be known."""
    alone = len(system.components) == 1
    free = free_inputs(system)
    if not inputs:
        if not alone:
            raise InputError(
                "--inputs: name free inputs, or connections to whose signal something is to be added"
                + (
                    f'; for instance {free[0]} or "{system.connections[0].label}"'
                    if free and system.connections
                    else ""
                )
            )
        inputs = free
    if not outputs:
        if not alone:
            raise InputError('--outputs: name signals, or a pattern such as "motor.*"')
        outputs = [f"{next(iter(system.components))}.*"]
    return inputs, outputs
