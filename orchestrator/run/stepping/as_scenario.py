"""What was done by hand in a run, as a scenario: a file with which another run does the same by itself."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from ...clock import seconds_text
from ...plan.plan import Plan
from ...toml.text import toml_value
from ..events.hands import Done, Hands

OWN = ("name", "by_hand", "for", "until")  # keys that are others in the scenario


def as_scenario(plan: Plan, hands: Hands, reached: Fraction) -> str:
    """The text of the file; `reached`: the time [s] until which the run has gone."""
    begin, end = (seconds_text(time) for time in (plan.system.start, reached))
    lines = [f"description = {toml_value(f'done by hand in {plan.system.name}, from {begin} to {end}')}"]
    for done, ends in hands.spans():
        lines += [
            "",
            "[[events]]",
            *(f"{key} = {toml_value(value)}" for key, value in _table(plan, done, ends).items()),
        ]
    return "\n".join([*lines, ""])


def _table(plan: Plan, done: Done, ends: Fraction | None) -> dict[str, Any]:
    """The keys of an event."""
    event = plan.system.events[done.number] if done.number >= 0 else None
    at = seconds_text(done.time)
    found: dict[str, Any] = {"name": f"{event.name if event else done.name} at {at}", "at": at}
    if done.time <= plan.system.start:
        found["initial"] = False
    if event is None:
        return {**found, "set": {done.name: done.value}}
    found |= {key: value for key, value in event.stated.items() if key not in OWN}
    return {**found, "until": seconds_text(ends)} if ends is not None else found
