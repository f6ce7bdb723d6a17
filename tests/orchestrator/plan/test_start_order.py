"""The order of values at time 0, against what each connection needs."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rovbrush.orchestrator.plan import start
from rovbrush.orchestrator.plan.order import order_of
from rovbrush.orchestrator.plan.start import start_order
from rovbrush.orchestrator.system.connection import Connection


@dataclass
class Answers:
    """An FMU that says only on which inputs its outputs depend."""

    dependencies: dict[str, frozenset[str]] = field(default_factory=dict)
    version: int = 2

    def feedthrough(self, initial: bool) -> dict[str, frozenset[str]]:
        return self.dependencies


@st.composite
def systems(draw: st.DrawFn) -> Any:
    """Components with some inputs and outputs; outputs that depend on all inputs share one set, as in an FMU."""
    names = [f"c{k}" for k in range(draw(st.integers(1, 5)))]
    components, inputs = {}, []
    for name in names:
        own = [f"u{k}" for k in range(draw(st.integers(0, 3)))]
        inputs += [(name, variable) for variable in own]
        everything = frozenset(own)
        some = st.one_of(st.just(everything), st.frozensets(st.sampled_from(own)) if own else st.just(everything))
        components[name] = SimpleNamespace(fmu=Answers({f"y{k}": draw(some) for k in range(3)}), in_events=False)
    source = st.tuples(st.sampled_from(names), st.sampled_from(["y0", "y1", "y2"]))
    connections = tuple(Connection(draw(source), target) for target in draw(st.permutations(inputs)))
    return SimpleNamespace(components=components, connections=connections)


def needs(system: Any, c: Connection) -> list[Connection]:
    """What must come before a connection, one by one."""
    answers = system.components[c.source[0]].fmu.dependencies[c.source[1]]
    return [d for d in system.connections if d.target[0] == c.source[0] and d.target[1] in answers]


def reaches(system: Any, c: Connection) -> set[Connection]:
    """All that must come before a connection, by steps; itself if it stands in a loop."""
    found: set[Connection] = set()
    waiting = needs(system, c)
    while waiting:
        d = waiting.pop()
        if d not in found:
            found.add(d)
            waiting += needs(system, d)
    return found


@given(system=systems())
def test_every_block_comes_behind_what_it_needs_and_loops_are_the_connections_that_need_each_other(system: Any) -> None:
    blocks = start_order(system)
    assert sorted(c.label for block in blocks for c in block.connections) == sorted(c.label for c in system.connections)
    before = {c: reaches(system, c) for c in system.connections}
    place = {c: k for k, block in enumerate(blocks) for c in block.connections}
    for c in system.connections:
        assert all(place[d] <= place[c] for d in before[c])
        together = {d for d in before[c] if c in before[d]} | {c}
        block = blocks[place[c]]
        assert set(block.connections) == together and block.loop == (c in before[c])


@given(system=systems())
def test_where_the_torn_inputs_of_a_loop_are_known_the_others_follow_one_after_the_other(system: Any) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(start, "WHOLE", 0)
        blocks = start_order(system)
    for block in blocks:
        assert sorted(c.label for c in (*block.torn, *block.behind)) == (
            sorted(c.label for c in block.connections) if block.loop else []
        )
        known = set(block.torn)
        for c in block.behind:
            assert set(needs(system, c)) & set(block.connections) <= known
            known.add(c)
        assert bool(block.torn) == block.loop


def chain_of(components: int, signals: int) -> Any:
    """A ring whose components exchange some signals, all outputs depending on all inputs."""
    inputs = [f"u{k}" for k in range(signals)]
    fmu = Answers({f"y{k}": frozenset(inputs) for k in range(signals)})
    one = SimpleNamespace(fmu=fmu, in_events=False)
    connections = tuple(
        Connection((f"c{n}", f"y{k}"), (f"c{(n + 1) % components}", f"u{k}"))
        for n in range(components)
        for k in range(signals)
    )
    return SimpleNamespace(components={f"c{n}": one for n in range(components)}, connections=connections)


@pytest.mark.parametrize(("components", "signals"), [(1, 1), (31, 1), (300, 1), (2, 30), (5, 7)])
def test_a_large_ring_is_torn_at_one_place(components: int, signals: int) -> None:
    (block,) = start_order(chain_of(components, signals))
    assert len(block.torn) == signals and len({c.target[0] for c in block.torn}) == 1
    more = components * signals - 8
    assert block.label.endswith(f" and {more} more") == (more > 0) and block.label.count(",") == min(7, 7 + more)


@given(system=systems())
def test_all_inputs_of_a_small_loop_are_unknowns(system: Any) -> None:
    assert all(block.torn == block.connections and not block.behind for block in start_order(system) if block.loop)


@given(system=systems(), slow=st.sets(st.sampled_from(["c0", "c1", "c2", "c3", "c4"])))
def test_fast_components_come_first_and_sources_before_targets_where_no_cycle_forbids_it(
    system: Any, slow: set[str]
) -> None:
    """Against the rule told plainly: take the first that waits for nobody of its rate, or the first at all."""
    system.order = ()
    periods = {name: 2 if name in slow else 1 for name in system.components}
    order, _ = order_of(system, SimpleNamespace(periods=periods))  # type: ignore[arg-type]
    waiting, wanted = sorted(system.components, key=periods.__getitem__), []
    while waiting:
        rate = [name for name in waiting if periods[name] == periods[waiting[0]]]
        blocked = {c.target[0] for c in system.connections if c.source[0] in rate and c.source[0] != c.target[0]}
        wanted.append(next((name for name in rate if name not in blocked), rate[0]))
        waiting.remove(wanted[-1])
    assert list(order) == wanted
