"""A system's linear model at times of a run: from saved states, by pulse responses, or by derivatives of states."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...clock import duration
from ...errors import InputError, nearest
from ...plan.plan import make_plan
from ...system.model import System
from .by_states import by_states, why_not_by_states
from .channels import channels_of, free_inputs, signals_of
from .operating import times_of
from .options import METHODS, Options, hyperperiod_of
from .points import Point, points
from .realise import realise
from .statespace import Linear


def linearise(
    system: System, inputs: Sequence[str] = (), outputs: Sequence[str] = (), options: Options = Options(),  # noqa: B008
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
