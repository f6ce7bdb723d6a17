"""Events as text: when they happen, what they do, and where in the plan they act."""

from __future__ import annotations

from fractions import Fraction

from ...clock import seconds_text
from ...fmu.binary import as_text
from ...fmu.types import Value
from ...system.event import Crossing, Event, Fault, Key
from ...system.model import System
from ..exchange import located
from ..plan import Plan
from .scenario import acts_at, from_start, spacing, stopped


def scenario_in_words(plan: Plan) -> list[str]:
    """Lines of the plan for the events of its system, none where there are none."""
    events = [event for event in plan.system.events if event.at is not None or event.when or event.by_hand]
    if not events:  # or none that happens by itself
        return []
    return ["", "events of the system file", *(line for event in events for line in _lines(plan, event))]


def _lines(plan: Plan, event: Event) -> list[str]:
    lines = [f"  {event.name}: {_when(event)}: {what(plan.system, event)}{_how_long(event)}"]
    if event.by_hand:
        return [*lines, "    acts where a step by hand has ended, on all that it touches"]
    if event.at is None:
        assert event.when is not None
        lines.append(f"    {_looked_at(plan, event.when)}; acts {_instants(plan, event)}")
        return lines
    if event in from_start(plan.system):
        return [*lines, "    there from the start, in the initialization too"]
    if event.at <= plan.system.start and event.initial:
        return [*lines, "    over before the run begins: it does nothing"]
    for name in event.components:
        lines.append(f"    {_acts_on(plan, event.at, name)}")
    return lines


def _looked_at(plan: Plan, crossing: Crossing) -> str:
    """Where a crossing is seen."""
    if plan.adaptive:
        return "looked at at the beginning of every macro step"
    if located(plan.system, crossing.signal):
        return f"where it crosses is found by the solver of {crossing.signal[0]}"
    every = seconds_text(plan.clock.seconds(spacing(plan.clock, plan.algorithm, crossing.signal[0])))
    return f"looked at every {every}{' and at every event' if plan.events else ''}"


def _acts_on(plan: Plan, at: Fraction, name: str) -> str:
    """When an event acts on a component, and how late that is."""
    acts = acts_at(plan, name, at)
    if acts >= plan.clock.seconds(plan.clock.start + plan.clock.stop):
        return f"does not act on {name} in this run, which has no step behind it"
    late = f", {seconds_text(acts - at)} later: {_whose(plan, name)}" if acts > at else ""
    ticks = (acts / plan.clock.seconds(1) - plan.clock.start) / plan.clock.periods[name]
    within = ", where a step of it ends" if stopped(plan, name) and ticks.denominator != 1 else ""
    return f"acts on {name} at {seconds_text(acts)}{late}{within}"


def _whose(plan: Plan, name: str) -> str:
    if plan.adaptive:
        return "the next tick of the clock"
    if plan.algorithm.acts_at_macro_steps:
        return "its next macro step"
    return f"its next instant, as {plan.events.late[name]}" if plan.events else "its next instant"


def _instants(plan: Plan, event: Event) -> str:
    """The instants at which an event whose time is not known can act."""
    if plan.adaptive:
        return "there, or where that is later exactly then: a step ends there"
    parts = []
    for name in event.components:
        if stopped(plan, name):
            parts.append(f"on {name} {'exactly then' if event.after else 'at once'}")
            continue
        every = seconds_text(plan.clock.seconds(spacing(plan.clock, plan.algorithm, name)))
        kind = "macro step" if plan.algorithm.acts_at_macro_steps else "instant"
        parts.append(f"on {name} at its first {kind} (every {every}) that is not before it")
    return ", ".join(parts)


def _when(event: Event) -> str:
    if event.by_hand:
        return "by hand"
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
