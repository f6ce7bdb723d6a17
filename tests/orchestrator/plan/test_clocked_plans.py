"""Clocks in a plan: every tick is shown, and clocks that contradict each other are one clear error before time 0."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from clock_build import built, clocked
from helpers import plan_of, read_system
from native_build import needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan

pytestmark = needs_gcc

C, D, A, B = ("controller", "1 s"), ("controller", "1 s"), ("producer", "1 s"), ("consumer", "1 s")


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = built(tmp_path_factory.mktemp("clocks"))
    clocked(folder / "slower.fmu", "controller", period="1/50")
    exact = 'intervalDecimal="0.016666667" intervalCounter="1" resolution="60" shiftCounter="2"'
    later = f'intervalVariability="constant" {exact}'
    clocked(folder / "later.fmu", "controller", tick=later)
    clocked(folder / "endless.fmu", "controller", tick='intervalVariability="constant"')
    twofold = 'intervalVariability="constant" intervalDecimal="0.5" intervalCounter="1" resolution="60"'
    clocked(folder / "twofold.fmu", "controller", tick=twofold)
    return folder


def test_the_plan_shows_every_tick_as_an_exact_time(tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Any] = {"c": C, "p": ("plant", "50 ms"), "a": ("partitions", "100 ms"), "b": B}
    text = explain(plan_of(tmp_path, fmus, parts, ["p.x -> c.y", "c.u -> p.u", "a.alarm -> b.sample"], stop="1 s"))
    for words in (
        "c.tick ticks every 1/60 s: 0 s, 1/60 s, 1/30 s, 50 ms, 1/15 s,",
        "a.fast ticks every 10 ms: 0 s, 10 ms, 20 ms,",
        "a.slow ticks every 1/30 s: 0 s, 1/30 s, 1/15 s, 100 ms,",
        "(31 of them in 1 s)",
        "a.burst ticks at times that a tells as it goes (countdown)",
        "a.alarm ticks when a says so",
        "b.sample ticks with a.alarm",
        "sampled at the ticks of tick",
    ):
        assert words in text
    assert "step on     a" not in text and "get         c" not in text and "set         c" not in text
    assert "b.sample never ticks: no clock drives it" in explain(plan_of(tmp_path, fmus, {"b": B}))


@pytest.mark.parametrize(
    ("parts", "wires", "why"),
    [
        ({"c": C, "d": ("slower", "1 s")}, ["c.tick -> d.tick"],
         r"contradict each other: c.tick ticks every 1/60 s, d.tick every 20 ms"),
        ({"c": C, "d": ("later", "1 s")}, ["c.tick -> d.tick"], r"d.tick every 1/60 s from 1/30 s on"),
        ({"a": A, "c": C}, ["a.crossing -> c.tick"], r"its own times; a.crossing \(triggered\) cannot drive it"),
        ({"a": A, "b": B, "c": C}, ["a.crossing -> b.sample", "c.tick -> b.sample"], r"b.sample is driven twice"),
        ({"a": A, "b": B}, ["a.crossing -> b.v"], r"a clock of a is connected with another clock only; b.v is none"),
        ({"a": A, "b": B}, ["a.count -> b.sample"], r"of b is connected with another clock only; a.count is none"),
        ({"a": A, "b": B}, ["a.nothing -> b.sample"], r"'nothing'"),
        ({"a": A, "b": B}, ["b.sample -> a.crossing"], r"of causality output; only an input clock is driven"),
        ({"a": A, "b": B}, ["a.crossing -> b.sample (mean)"], r"a clock ticks, 'mean' has no meaning for it"),
        ({"p": ("plant", "1 s"), "c": C}, ["p.x -> c.y (linear)"], r"set at events only, so 'linear' has no meaning"),
        ({"e": ("endless", "1 s")}, [], r"clock tick: it is constant and states no interval"),
        ({"e": ("twofold", "1 s")}, [], r"clock tick: .* contradict each other"),
    ],
)  # fmt: skip
def test_clocks_that_cannot_tick_so_are_one_clear_error(
    parts: dict[str, Any], wires: list[str], why: str, tmp_path: Path, fmus: Path
) -> None:
    with pytest.raises((InputError, FmuError), match=why):
        make_plan(read_system(tmp_path, fmus, parts, wires))


@pytest.mark.parametrize(
    ("of", "keys", "why"),
    [
        ({"event_mode": "off"}, {}, r'clock tick is activated in event mode, and event_mode = "off"'),
        ({}, {"algorithm": "adaptive"}, r"algorithm adaptive does not go along with events"),
        ({}, {"algorithm": "iterated"}, r"algorithm iterated does not go along with events"),
        ({"clocks": {"tick": "10 ms"}}, {}, r"it is constant, its interval is not to be set"),
        ({"clocks": {"tack": "10 ms"}}, {}, r"has no such clock; did you mean 'tick'\?"),
        ({"clocks": {"tick": "0 s"}}, {}, r"not a positive time|is not to be set"),
    ],
)  # fmt: skip
def test_what_a_clocked_component_cannot_do_is_told_before_time_0(
    of: dict[str, Any], keys: dict[str, Any], why: str, tmp_path: Path, fmus: Path
) -> None:
    with pytest.raises(InputError, match=why):
        make_plan(read_system(tmp_path, fmus, {"c": C}, of={"c": of}, **keys))


def test_an_event_mode_that_is_not_used_is_told(tmp_path: Path, fmus: Path) -> None:
    parts, wires = {"ball": ("ball", "10 ms"), "p": ("plant", "10 ms")}, ["ball.h -> p.u"]
    plan = plan_of(tmp_path, fmus, parts, wires, algorithm="adaptive")
    assert plan.events is None and "ball: the event mode of ball.fmu is not used:" in explain(plan)
    plan = plan_of(tmp_path, fmus, parts, wires, of={"ball": {"event_mode": "off"}})
    assert plan.events is None and "not used" not in explain(plan)
