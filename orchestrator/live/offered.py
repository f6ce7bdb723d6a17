"""What a page offers of a run: sliders with their ends, charts, signals that break."""

from __future__ import annotations

import math
from typing import Any

from ..fmu.types import Value
from ..run.session.session import Session
from ..system.event import Key
from ..system.model import System
from .messages import Hello, Input
from .posts import Posts
from .scene import scene_of, scene_signals
from .touch import KINDS, Touch

CHARTS, TOGETHER = 4, 6  # without any that are stated: how many, and signals in each


def hello_of(session: Session, touch: Touch, posts: Posts, diagram: str) -> Hello:
    system, clock = session.plan.system, session.plan.clock
    names = [signal.name for signal in posts.signals]
    inputs = sorted((_input(system, key) for key in touch.inputs), key=lambda entry: not entry.first)
    return Hello(
        system.name, system.description, clock.time(0), clock.time(clock.stop),
        float(clock.seconds(clock.hyperperiod)), posts.signals, inputs, touch.breakable, touch.happenings,
        charts_of(system, names), diagram, scene_of(system, names),
    )  # fmt: skip


def first_signals(system: System) -> list[str]:
    """The signals that are posted whatever there is beside them: those of charts, scene and figures."""
    figures = [str(name) for figure in system.reporting.get("figures", ()) for name in figure.get("signals", ())]
    charts = [name for chart in (system.live.charts if system.live else ()) for name in chart]
    return [*charts, *scene_signals(system), *figures]


def charts_of(system: System, names: list[str]) -> list[list[int]]:
    """Signals by their number, chart by chart: those of the figures over time, else the first ones."""
    stated = system.live.charts if system.live else []
    if chosen := [numbers for chart in stated if (numbers := [names.index(n) for n in chart if n in names])]:
        return chosen
    found = []
    for figure in system.reporting.get("figures", ()):
        signals = [] if figure.get("along") else [str(name) for name in figure.get("signals", ())]
        numbers = [names.index(name) for name in signals if name in names]
        if numbers:
            found.append(numbers[:TOGETHER])
    return found[:CHARTS] or [[number] for number in range(min(len(names), CHARTS))]


def _input(system: System, key: Key) -> Input:
    component = system.components[key[0]]
    variable = component.fmu.variables[key[1]]
    value: Value = {**component.parameters, **component.inputs}.get(key[1], component.fmu.start(key[1]))
    kind = KINDS[variable.type]
    low, high = _ends(value if not isinstance(value, str | bytes) else 0.0, variable.min, variable.max)
    name = ".".join(key)
    plain: Any = value.item() if hasattr(value, "item") else value
    about = (variable.unit or "", variable.description or "", kind, plain)
    for stated in system.live.controls if system.live else ():
        if stated.input == name:
            low = low if stated.low is None else stated.low
            high = high if stated.high is None else stated.high
            return Input(name, stated.label or name, *about, low, high, True, stated.choices)
    return Input(name, name, *about, low, high)


def _ends(value: float, low: str | None, high: str | None) -> tuple[float, float]:
    """The ends of a slider: those of the variable where it states some that are near enough, else around its value."""
    around = 2.0 * abs(float(value)) or 1.0
    ends = [-around if float(value) <= 0.0 else 0.0, around]
    for k, stated in enumerate((low, high)):
        if stated is not None and math.isfinite(float(stated)) and abs(float(stated)) <= 100.0 * around:
            ends[k] = float(stated)
    return (ends[0], ends[1]) if ends[0] < ends[1] else (float(value), float(value) + 1.0)
