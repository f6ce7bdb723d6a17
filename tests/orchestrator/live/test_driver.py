"""A live run of mocks: what is asked for by hand acts, is recorded, and does the same again bit for bit."""

from __future__ import annotations

import socket
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import pairwise
from typing import Any

import msgspec
import numpy as np
import pytest
from event_cases import INTEGRAL, KEEP, RAMP, planned
from helpers import column
from rovbrush.orchestrator.live.driver import Driver
from rovbrush.orchestrator.live.messages import ROWS, Do, Done, Hello, Said, State, packed_command, unpacked
from rovbrush.orchestrator.live.record import Record
from rovbrush.orchestrator.live.touch import touchable
from rovbrush.orchestrator.live.wire import Wire
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.pacing.pace import Pace
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.events.read import events_of

PARTS = {"a": (RAMP, "0.001"), "b": (KEEP, "0.002"), "c": (INTEGRAL, "0.002")}
WIRES = ["a.y -> b.u"]


def small(stop: str = "0.1", **keys: Any) -> Plan:
    """a.y = t into b.u; c.u and c.k are free."""
    return planned(PARTS, WIRES, [], stop, **keys)


def framed(message: bytes) -> bytes:
    return len(message).to_bytes(4, "little") + message


@contextmanager
def ends() -> Iterator[tuple[Wire, socket.socket]]:
    """The wire of a run, and the socket of whoever looks on."""
    here, there = socket.socketpair()
    with there:
        there.settimeout(10.0)
        yield Wire(here), there
        here.close()


def heard(there: socket.socket) -> list[bytes]:
    """All messages that have come until now."""
    there.setblocking(False)
    found, data = [], b""
    try:
        while piece := there.recv(1 << 20):
            data += piece
    except BlockingIOError:
        pass
    while data:
        size = int.from_bytes(data[:4], "little")
        found.append(data[4 : 4 + size])
        data = data[4 + size :]
    return found


def told(messages: list[bytes], kind: type[Any]) -> list[Any]:
    found = [unpacked(message) for message in messages if not message.startswith(ROWS)]
    return [message for message in found if isinstance(message, kind)]


def driven(plan: Plan, *commands: Do | bytes, speed: float = 0.0) -> tuple[Run, Driver, list[bytes]]:
    """A run that is paused at its start and then does what is commanded, one after the other."""
    live = make_plan(touchable(plan.system))
    with ends() as (wire, there), Session(live) as session:
        for command in commands:
            there.sendall(framed(packed_command(command) if isinstance(command, Do) else command))
        driver = Driver(lambda: wire, Record("mocks"), speed=speed)
        driver.go(session)
        run = session.run()
        wire.push()
        return run, driver, heard(there)


def steps(count: int) -> list[Do]:
    return [Do("step")] * count


def again(plan: Plan, record: Record) -> Run:
    """The run of a scenario, as `rovbrush run --scenario` makes it."""
    entries = tomllib.loads(record.toml())["events"]
    found = events_of(None, plan.system.components, plan.system.connections, entries)
    return simulate(make_plan(replace(plan.system, events=(*plan.system.events, *found))))


def require_same(live: Run, other: Run) -> None:
    """All that the other run recorded is bitwise in the live one, which records what can be touched too."""
    for group, table in enumerate(other.plan.groups):
        columns = live.plan.groups[group].columns
        for k, key in enumerate(table.columns):
            mine = np.ascontiguousarray(live.tables[group][:, columns.index(key)])
            assert mine.tobytes() == np.ascontiguousarray(other.tables[group][:, k]).tobytes(), key


TOUCHED = [
    *steps(3), Do("set", "c.u", 1.5), *steps(4), Do("break", "a.y", 0.25, "bias"), *steps(2), Do("set", "c.k", 0.3),
    Do("set", "c.u", -0.1), *steps(3), Do("break", "a.y", 0.01, "noise"), *steps(5), Do("mend", "a.y"), *steps(2),
    Do("break", "a.y", None, "hold"), *steps(2), Do("mend", "a.y"), *steps(1), Do("break", "a.y", 7.0, "loss"),
    Do("start"),
]  # fmt: skip


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_what_was_done_by_hand_is_a_scenario_that_gives_the_same_bits(algorithm: str) -> None:
    plan = small(algorithm=algorithm)
    live, driver, messages = driven(plan, *TOUCHED)
    assert not live.failure and not told(messages, Said)
    assert live.end == 0.1
    require_same(live, again(plan, driver.record))
    assert column(live, "c.y")[1][-1] != 0.0


def test_what_nobody_touches_gives_the_bits_of_a_run_without_a_page() -> None:
    plan = small()
    live, driver, _ = driven(plan, Do("start"))
    assert driver.record.lines() == []
    require_same(live, simulate(make_plan(touchable(plan.system))))
    y, other = column(live, "c.y")[1], column(simulate(plan), "c.y")[1]
    assert y.tolist() == other.tolist()


def test_what_is_set_acts_one_step_later() -> None:
    live, driver, _ = driven(small(), *steps(2), Do("set", "c.u", 2.0), Do("start"))
    assert driver.record.lines() == ["6 ms: c.u = 2.0"]
    _, y = column(live, "c.y")
    assert y[:4].tolist() == [0.0] * 4 and y[4] == 0.002 * 2.0


def test_of_what_is_set_twice_at_one_instant_the_last_counts() -> None:
    _, driver, messages = driven(small(), Do("set", "c.u", 1.0), Do("set", "c.u", 3.0), Do("start"))
    assert driver.record.lines() == ["2 ms: c.u = 3.0"]
    assert told(messages, State)[-1].values == {"c.u": 3.0}


def test_a_fault_that_is_mended_before_it_acts_never_was() -> None:
    plan = small()
    live, driver, _ = driven(plan, Do("step"), Do("break", "a.y", 1.0, "bias"), Do("mend", "a.y"), Do("start"))
    assert driver.record.lines() == []
    require_same(live, simulate(make_plan(touchable(plan.system))))


def test_faults_are_shown_until_they_are_mended() -> None:
    _, _, messages = driven(
        small(), Do("break", "a.y", 1.0, "bias"), Do("step"), b"?", Do("mend", "a.y"), Do("step"), Do("end")
    )
    assert told(messages, State)[-1].faults == {}
    assert told(messages, Done)[-1].lines == ["2 ms: a.y: bias 1.0 until 4 ms"]


REFUSED = [
    (Do("set", "b.u", 1.0), "b.u is driven by the connection a.y -> b.u"),
    (Do("set", "c.v", 1.0), "no variable is called 'c.v'"),
    (Do("set", "c.u", "much"), "c.u"),
    (Do("set", "a.y", 1.0), "only inputs and tunable parameters can be set"),
    (Do("break", "c.y", 1.0, "bias"), "no signal 'c.y' can break"),
    (Do("break", "a.y", 1.0, "melt"), "no fault is of the kind 'melt'"),
    (Do("break", "a.y", -1.0, "noise"), "cannot be negative"),
    (Do("mend", "a.y"), "a.y is not broken"),
    (Do("happen", "dusk"), "no event 'dusk' happens by hand"),
    (Do("speed", value=-1.0), "speed = -1.0 is none"),
    (Do("speed", value="fast"), "speed = fast is none"),
    (b'{"what": "explode"}', "no command"),
    (b"\xff\x00", "no command"),
    (msgspec.json.encode({"what": "step", "more": 1}), "no command"),
]


@pytest.mark.parametrize(("command", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_a_command_that_cannot_be_is_answered_and_the_run_goes_on(command: Do | bytes, message: str) -> None:
    live, driver, messages = driven(small(), Do("step"), command, Do("start"))
    assert not live.failure and live.end == 0.1
    assert any(message in said.text for said in told(messages, Said))
    assert driver.record.lines() == []


def test_only_the_viewer_who_asked_is_told_what_is_wrong() -> None:
    _, _, messages = driven(small(), Do("set", "b.u", 1.0, viewer="x"), Do("end"))
    assert [said.viewer for said in told(messages, Said)] == ["x"]


def test_what_is_set_when_no_step_is_left_is_refused() -> None:
    _, _, messages = driven(small("0.004"), Do("step"), Do("set", "c.u", 1.0), Do("start"))
    assert "the run ends at 0.004 s" in told(messages, Said)[0].text


def test_a_run_that_is_ended_by_hand_is_no_failure() -> None:
    live, _, messages = driven(small(), *steps(5), Do("end"))
    assert live.ended == "ended by hand at t = 0.01 s" and not live.failure and live.end == 0.01
    assert told(messages, State)[-1].what == "writing"


def test_whoever_looks_on_is_told_of_all_that_can_be_seen_and_touched() -> None:
    _, _, messages = driven(small(), Do("end"))
    (hello,) = told(messages, Hello)
    assert [entry.name for entry in hello.inputs] == ["c.u", "c.k"]
    assert hello.breakable == ["a.y"] and hello.period == 0.002
    assert {signal.name for signal in hello.signals} >= {"a.y", "b.y", "c.y"}


def test_rows_hold_the_last_lowest_and_highest_value_since_the_message_before() -> None:
    _, _, messages = driven(small(), Do("start"))
    (hello,) = told(messages, Hello)
    rows = [np.frombuffer(m[12:], dtype="<f4").reshape(3, -1) for m in messages if m.startswith(ROWS)]
    k = [signal.name for signal in hello.signals].index("a.y")
    assert rows[-1][0, k] == rows[-1][2, k] == np.float32(0.1)
    assert all((table[1, k] <= table[0, k]) and (table[0, k] <= table[2, k]) for table in rows)
    assert all(new[1, k] >= old[2, k] for old, new in pairwise(rows[1:]))


def test_a_server_that_hangs_costs_rows_and_never_the_run() -> None:
    plan = make_plan(touchable(small("20").system))
    with ends() as (wire, there), Session(plan) as session:
        there.sendall(framed(packed_command(Do("start"))))
        driver = Driver(lambda: wire, Record("mocks"), speed=0.0)
        while wire.post(b"x" * 100_000, 1 << 18):  # nobody reads
            pass
        dropped = wire.dropped
        driver.go(session)
        assert session.run().end == 20.0 and not session.failure
        assert wire.dropped > dropped


def test_a_server_that_dies_does_not_end_the_run() -> None:
    plan = make_plan(touchable(small("1").system))
    with ends() as (wire, there), Session(plan) as session:
        there.sendall(framed(packed_command(Do("start"))))
        there.close()
        Driver(lambda: wire, Record("mocks"), speed=0.0).go(session)
        assert wire.closed and session.run().end == 1.0 and not session.failure


def test_a_run_at_the_speed_that_is_wanted_keeps_no_other_time() -> None:
    """Waiting is the pacer's: at 1000 times real time there are as many deadlines as steps, at ease there are none."""
    plan = make_plan(touchable(small("0.2").system), "")
    for speed, deadlines in ((1000.0, 100), (0.0, 0)):
        with ends() as (wire, there), Session(plan, pace=Pace()) as session:
            there.sendall(framed(packed_command(Do("start"))))
            Driver(lambda wire=wire: wire, Record("mocks"), speed=speed).go(session)
            assert told(heard(there), State)[-1].deadlines == deadlines and session.run().end == 0.2


def test_the_speed_can_be_changed_while_it_goes() -> None:
    plan = make_plan(touchable(small("0.2").system), "")
    with ends() as (wire, there), Session(plan, pace=Pace()) as session:
        for command in (Do("speed", value=500.0), Do("step"), Do("speed", value=0.0), Do("start")):
            there.sendall(framed(packed_command(command)))
        driver = Driver(lambda: wire, Record("mocks"))
        driver.go(session)
        assert driver.speed == 0.0 and session.pacer.factor == 500.0 and session.run().end == 0.2
