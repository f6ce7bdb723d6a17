"""Continuous models of systems whose FMUs all say which their states are: each by itself, then connected.

With y = C x + D u of all FMUs together and u = K y + E w along the connections, w being the inputs of the model:
y = (I - D K)^-1 (C x + D E w), which also solves loops of direct dependence.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from ...errors import InputError
from ...fmu.kinds import CO_SIMULATION
from ...fmu.reading.states import state_names
from ...participant.here.loaded import LoadedInstance
from ...plan.plan import make_plan
from ...run.stepping.stepping import Stepping
from ...system.event import Key
from ...system.model import System
from .channels import Channel
from .derivatives import Local, local, why_no_states
from .operating import Residual, require_steady, ticks_of
from .statespace import Linear


def why_not_by_states(system: System, channels: Sequence[Channel]) -> str:
    """Why a system has no continuous model of this kind; empty where it has one."""
    several = len(system.components) > 1
    for name, component in system.components.items():
        if why := why_no_states(component.fmu):
            return f"component {name}: {component.fmu.path.name} {why}"
        if component.isolation or component.apart:
            return f"component {name} runs in a process of its own, where its states are out of reach"
        if several and component.fmu.kind == CO_SIMULATION:
            return f"component {name} is for co-simulation: what is connected to it is exchanged at instants"
    if any(not system.is_real(c) for c in system.connections):
        return "a connection carries what is no floating-point number"
    for channel in channels:
        variable = system.components[channel.key[0]].fmu.variables[channel.key[1]]
        if variable.variability != "continuous":
            return f"{channel.target} is not continuous: its FMU takes it at events only"
    return ""


def by_states(
    system: System, channels: Sequence[Channel], signals: Sequence[str], times: Sequence[Fraction], allowed: float
) -> list[Linear]:
    """The models at rising times [s]. Raises InputError for an operating point that is none, FmuError, RunError."""
    plan = make_plan(replace(system, record=tuple(signals)))
    found = []
    with Stepping(plan) as session:
        for time in times:
            session.finish(until_tick=ticks_of(plan.clock, system.start, time))
            instances = session.instances
            found.append(_model(system, instances, channels, signals, float(time), allowed))  # type: ignore[arg-type]
    return found


def _model(
    system: System, instances: dict[str, LoadedInstance], channels: Sequence[Channel], signals: Sequence[str],
    time: float, allowed: float,
) -> Linear:  # fmt: skip
    ins: dict[Key, int] = {}
    outs: dict[Key, int] = {}
    for key in (*(c.target for c in system.connections), *(channel.key for channel in channels)):
        ins.setdefault(key, len(ins))
    asked = [(owner, variable) for owner, _, variable in (name.partition(".") for name in signals)]
    for key in (*(c.source for c in system.connections), *(key for key in asked if key not in ins)):
        outs.setdefault(key, len(outs))
    parts: dict[str, Local] = {}
    for name, instance in instances.items():
        own = [v for owner, v in ins if owner == name], [v for owner, v in outs if owner == name]
        parts[name] = local(instance, *own)
    A, B, C, D = _together(system, parts, ins, outs)
    K, E = np.zeros((len(ins), len(outs))), np.zeros((len(ins), len(channels)))
    for c in system.connections:
        K[ins[c.target], outs[c.source]] += c.gain
    for k, channel in enumerate(channels):
        E[ins[channel.key], k] = 1.0
    try:
        # y = (I - D K)^-1 (C x + D E w)
        solved = np.linalg.solve(np.eye(len(outs)) - D @ K, np.hstack([C, D @ E]))
    except np.linalg.LinAlgError:
        raise InputError(f"t = {time:g} s: a loop of direct dependences has no single solution there") from None
    Cy, Dy = solved[:, : len(A)], solved[:, len(A) :]
    Cu, Du = K @ Cy, K @ Dy + E  # what the inputs are
    rows = [(Cu, Du, ins[key]) if key in ins else (Cy, Dy, outs[key]) for key in asked]
    x, rates = (np.concatenate([getattr(part, v) for part in parts.values()]) for v in ("x", "rates"))
    states = [f"{name}.{v}" for name, c in system.components.items() for v in state_names(c.fmu)]
    whole = A + B @ Cu
    steady = _residuals(whole, x, rates, states)
    require_steady(steady, time, allowed, float("nan"))
    worst = {"residual": steady[0].value, "residual_of": steady[0].signal} if steady else {}
    units = [system.components[o].fmu.variables[v].unit or "1" for o, v in asked]
    return Linear(
        whole, B @ Du, np.array([c[k] for c, _, k in rows]).reshape(len(rows), len(A)),
        np.array([d[k] for _, d, k in rows]).reshape(len(rows), len(channels)), 0.0,
        tuple(c.name for c in channels), tuple(signals), tuple(c.unit for c in channels), tuple(units), tuple(states),
        time, {"method": "states", "by": {name: part.how for name, part in parts.items()}, **worst},
    )  # fmt: skip


def _together(
    system: System, parts: dict[str, Local], ins: dict[Key, int], outs: dict[Key, int]
) -> tuple[np.ndarray, ...]:  # fmt: skip
    """All FMUs beside each other: block-diagonal in the order of `ins` and `outs`."""
    n = sum(len(part.x) for part in parts.values())
    A, B = np.zeros((n, n)), np.zeros((n, len(ins)))
    C, D = np.zeros((len(outs), n)), np.zeros((len(outs), len(ins)))
    first = 0
    for name, part in parts.items():
        x = np.arange(first, first + len(part.x))
        u = [k for (owner, _), k in ins.items() if owner == name]
        y = [k for (owner, _), k in outs.items() if owner == name]
        for whole, own, places in ((A, part.A, (x, x)), (B, part.B, (x, u)), (C, part.C, (y, x)), (D, part.D, (y, u))):
            whole[np.ix_(*places)] = own
        first += len(x)
    return A, B, C, D


def _residuals(A: np.ndarray, x: np.ndarray, rates: np.ndarray, states: Sequence[str]) -> list[Residual]:
    """How far each state is from where all would keep their rates, relative to its size or 1: by the linear model,
    with A (rates + A d) = 0."""
    if not len(x):
        return []
    distance = -np.linalg.pinv(A @ A) @ (A @ rates)
    values = np.abs(distance) / np.maximum(np.abs(x), 1.0)
    found = [Residual(name, float(value)) for name, value in zip(states, values, strict=True)]
    return sorted(found, key=lambda residual: -residual.value)
