"""Events as text: when they happen, what they do, and where in the plan they act."""

from __future__ import annotations

from fractions import Fraction

from ...clock import seconds_text
from ...fmu.binary import as_text
from ...fmu.types import Value
from ...system.event import Event, Fault, Key
from ...system.model import System
from ..plan import Plan
from .scenario import from_start, place, spacing


def scenario_in_words(plan: Plan) -> list[str]:
    """Lines of the plan for the events of its system, none where there are none."""
    if not plan.system.events:
        return []
    return ["", "events of the system file", *(line for event in plan.system.events for line in _lines(plan, event))]


def _lines(plan: Plan, event: Event) -> list[str]:
    lines = [f"  {event.name}: {_when(event)}: {what(plan.system, event)}{_how_long(event)}"]
    if event.at is None:
        assert event.when is not None
        seen = seconds_text(plan.clock.seconds(spacing(plan.clock, plan.algorithm, event.when.signal[0])))
        steps = "at the beginning of every macro step" if plan.adaptive else f"every {seen}"
        lines.append(f"    looked at {steps}; acts {_instants(plan, event)}")
        return lines
    if event in from_start(plan.system):
        return [*lines, "    there from the start, in the initialization too"]
    if event.at <= plan.system.start:
        return [*lines, "    over before the run begins: it does nothing"]
    for name in event.components:
        lines.append(f"    {_acts_on(plan, event.at, name)}")
    return lines


def _acts_on(plan: Plan, at: Fraction, name: str) -> str:
    """When an event acts on a component, and how late that is."""
    tick = place(plan.clock, plan.algorithm, name, at)
    if tick >= plan.clock.stop:
        return f"does not act on {name} in this run, which has no step behind it"
    acts = plan.clock.seconds(plan.clock.start + tick)
    late = f", {seconds_text(acts - at)} later: {_whose(plan, name)}" if acts > at else ""
    return f"acts on {name} at {seconds_text(acts)}{late}"


def _whose(plan: Plan, name: str) -> str:
    if plan.adaptive:
        return "the next tick of the clock"
    if plan.algorithm.acts_at_macro_steps:
        return "its next macro step"
    return "its next instant"


def _instants(plan: Plan, event: Event) -> str:
    """The instants at which an event whose time is not known can act."""
    if plan.adaptive:
        return "there, or where that is later exactly then: a step ends there"
    parts = []
    for name in event.components:
        every = seconds_text(plan.clock.seconds(spacing(plan.clock, plan.algorithm, name)))
        kind = "macro step" if plan.algorithm.acts_at_macro_steps else "instant"
        parts.append(f"on {name} at its first {kind} (every {every}) that is not before it")
    return ", ".join(parts)


def _when(event: Event) -> str:
    if event.at is not None:
        return f"at {seconds_text(event.at)}"
    assert event.when is not None
    often = "every time" if event.repeat else "the first time"
    after = f"{seconds_text(event.after)} after " if event.after else ""
    way = "rises" if event.when.rising else "falls"
    return f"{after or 'when '}{event.when.text} ({often} that it {way})"


def _how_long(event: Event) -> str:
    if event.lasting is not None:
        return f", for {seconds_text(event.lasting)}"
    return f", until {seconds_text(event.until)}" if event.until is not None else ""


def what(system: System, event: Event, component: str = "") -> str:
    """What an event does, to all that it touches or to one component."""
    keys = [key for key in event.inputs if component in ("", key[0])]
    if event.fault:
        return ", ".join(_broken(system, event.fault, key) for key in keys)
    return ", ".join(f"{'.'.join(key)} = {quantity(system, key, event.settings[key])}" for key in keys)


def _broken(system: System, fault: Fault, key: Key) -> str:
    name, value = ".".join(key), fault.values[key]
    if value is None:
        return f"{name} stays as it is ({fault.kind})"
    if fault.kind == "scale":
        return f"{name} times {float(value):g} ({fault.kind})"
    said = quantity(system, key, value)
    if fault.kind == "loss":
        return f"{name} is {said} ({fault.kind})"
    noise = f"noise of standard deviation {said}, seed {fault.seed}"
    return f"{name} plus {noise if fault.kind == 'noise' else said} ({fault.kind})"


def quantity(system: System, key: Key, value: Value) -> str:
    """A value with its unit."""
    if isinstance(value, bytes):
        return as_text(value)
    if isinstance(value, bool | str):
        return str(value).lower() if isinstance(value, bool) else repr(value)
    unit = system.components[key[0]].fmu.variables[key[1]].unit
    return f"{value:g}{f' {unit}' if unit and unit != '1' else ''}"
