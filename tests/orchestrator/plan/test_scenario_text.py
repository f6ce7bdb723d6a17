"""What `plan` says of events: when they act, on whom, and how late."""

from __future__ import annotations

from typing import Any

import pytest
from event_cases import FIXED, INTEGRAL, KEEP, RAMP, bonded, planned, ramp_into_keep
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan

PARTS = {"slow": (INTEGRAL, "0.005"), "fast": (RAMP, "0.001"), "b": (KEEP, "0.002"), "fixed": (FIXED, "0.005")}


def said(plan: Plan) -> list[str]:
    """The lines of the plan on events."""
    lines = explain(plan).split("\n")
    begin = lines.index("events of the system file") + 1
    return [line.strip() for line in lines[begin : lines.index("", begin)]]


CASES: list[tuple[dict[str, Any], list[str]]] = [
    ({"at": "5 ms", "set": {"slow.u": 2.0}}, ["event 1: at 5 ms: slow.u = 2", "acts on slow at 5 ms"]),
    (
        {"at": "3.5 ms", "set": {"slow.u": 2.0}},
        ["event 1: at 3.5 ms: slow.u = 2", "acts on slow at 3.5 ms, where a step of it ends"],
    ),
    (
        {"name": "n", "at": "1 ms", "fault": "noise", "on": "b.u", "value": 0.5, "seed": 3, "until": "4 ms"},
        [
            "n: at 1 ms: b.u plus noise of standard deviation 0.5, seed 3 (noise), until 4 ms",
            "acts on b at 2 ms, 1 ms later: its next instant, as u is the mean over its whole step",
        ],
    ),
    (
        {"when": "fast.y > 0.004", "after": "2 ms", "repeat": True, "fault": "hold", "on": "fast.y", "for": "3 ms"},
        [
            "event 1: 2 ms after fast.y > 0.004 (every time that it rises): b.u stays as it is (hold), for 3 ms",
            "looked at every 1 ms and at every event; acts on b at its first instant (every 2 ms) that is not "
            "before it",
        ],
    ),
    (
        {"at": "3.5 ms", "set": {"fixed.u": 2.0}},
        [
            "event 1: at 3.5 ms: fixed.u = 2",
            "acts on fixed at 5 ms, 1.5 ms later: its next instant, as its step cannot vary",
        ],
    ),
    (
        {"when": "fast.y > 0.004", "set": {"fixed.u": 2.0, "slow.u": 1.0}},
        [
            "event 1: when fast.y > 0.004 (the first time that it rises): fixed.u = 2, slow.u = 1",
            "looked at every 1 ms and at every event; acts on fixed at its first instant (every 5 ms) that is not "
            "before it, on slow at once",
        ],
    ),
    (
        {"at": 0, "fault": "loss", "on": "b.u"},
        ["event 1: at 0 s: b.u is 0 (loss)", "there from the start, in the initialization too"],
    ),
    (
        {"at": "19 ms", "set": {"fixed.u": -1.0}},
        ["event 1: at 19 ms: fixed.u = -1", "does not act on fixed in this run, which has no step behind it"],
    ),
]


@pytest.mark.parametrize(("event", "lines"), CASES)
def test_the_plan_says_when_an_event_acts_on_whom_and_how_late(event: dict[str, Any], lines: list[str]) -> None:
    plan = planned(PARTS, ["fast.y -> b.u"], [event], "0.02")
    assert said(plan) == lines


def test_macro_steps_and_steps_that_vary_are_named() -> None:
    iterated = ramp_into_keep({"at": "1.5 ms", "fault": "loss", "on": "b.u"}, algorithm="iterated")
    assert said(iterated)[1] == "acts on b at 2 ms, 500 us later: its next macro step"
    ecco = bonded({"at": "0.1234 s", "fault": "loss", "on": "p.e"}, algorithm="ecco")
    assert said(ecco)[1] == "acts on p at 123.4 ms"


def test_every_operation_of_events_is_a_line() -> None:
    text = explain(
        planned(PARTS, ["fast.y -> b.u"], [{"when": "fast.y > 1", "fault": "bias", "on": "b.u", "value": 1}], "0.02")
    )
    assert "watch       fast.y for event 1: fast.y > 1" in text
    assert "pause       for what happens at this instant, if anything does, then the list goes on" in text
    assert "fault       b.u by event 1, as long as it lasts: bias" in text
