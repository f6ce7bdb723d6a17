"""Operating points of a run, and how it answers there to pulses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import ceil
from typing import Any

import numpy as np

from ...errors import InputError
from ...plan.plan import make_plan
from ...system.model import System
from .channels import Channel
from .operating import period_in, require_angle, require_steady, residuals, starts_in, ticks_of, times_of
from .options import SAMPLES, Options, hyperperiod_of, samples_of, sizes_of
from .probe import Probe, require_states
from .pulses import Pulses, pulses_from, size_of

CLEAN = 0.03  # of a response that is the same for both signs of a pulse: larger pulses are tried above it
HIDDEN = 0.5  # the same: what no model can be made of
LARGER = (1e2, 1e4)  # times the pulses that are taken by default


@dataclass(frozen=True)
class Point:
    """One operating point: the responses there, and what was found of it."""

    time: float
    dt: float
    pulses: Pulses
    notes: dict[str, Any]


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
            again = partial(
                pulses_from, probe, kept, samples=length, most=SAMPLES, count=count, over_the_step=over, progress=share
            )
            pulses = _clean(probe, [value is None for value in stated], sizes, again)
            sizes = list(pulses.sizes)
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
                "period": float(period * one), "faster": _faster(system, channels, probe.dt),
            }  # fmt: skip
            found.append(Point(clock.time(tick), probe.dt, pulses, notes))
    return found


def _faster(system: System, channels: Sequence[Channel], dt: float) -> dict[str, float]:
    """Channels that are taken more often [s] than a sample: what answers to them within it is not in the model."""
    periods = {channel.name: float(system.components[channel.key[0]].period) for channel in channels}
    return {name: period for name, period in periods.items() if period < dt * (1.0 - 1e-9)}


def _clean(probe: Probe, free: Sequence[bool], sizes: Sequence[float], pulses: Callable[..., Pulses]) -> Pulses:
    """The responses by pulses of these sizes, or larger ones where they are `free`, since steps of readings or ripple
    hide those. Raises InputError where all of them are hidden: noise is the same in all runs, and does no harm.
    """
    found = pulses(sizes=sizes)
    for factor in LARGER if any(free) else ():
        if found.even <= CLEAN and np.any(found.values):
            break
        try:
            again = pulses(sizes=[factor * s if f else s for s, f in zip(sizes, free, strict=True)])
        except InputError:  # beyond what an input may be
            break
        found = min(found, again, key=lambda p: (not np.any(p.values), p.even))
    if found.even > HIDDEN:
        names = ", ".join(f"{c.name} by {s:.3g} {c.unit}" for c, s in zip(probe.channels, found.sizes, strict=True))
        raise InputError(
            f"pulses ({names}) are hidden: {found.even:.2g} of their responses is the same for both signs of a pulse "
            f"(allowed {HIDDEN:g}); add more by --size, or set to 0 the parameters by which sensors round, lose or "
            f"switch{_rounding(probe.plan.system)}"
        )
    return found


def _rounding(system: System) -> str:
    """Parameters whose names say that they round or lose samples, and which are not 0: an aid, no proof."""
    found = [
        f"--set {name}.{v}=0"
        for name, c in system.components.items()
        for v in c.fmu.names("parameter")
        if any(word in v.lower() for word in ("quant", "resolution", "dropout"))
        and c.parameters.get(v, c.fmu.variables[v].start) not in (0, 0.0, "0", "0.0", None)
    ]
    return f", for instance {' '.join(found[:4])}" if found else ""
