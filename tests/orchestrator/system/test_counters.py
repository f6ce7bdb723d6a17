"""`(mean of a.counter)` in a system file: how it may be written, and every way to write it wrong."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from helpers import column, plan_of, read_system, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.files.manifest import manifest
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.sweep.workers.point import digest
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp
from rovbrush.orchestrator.units import Unit, integral_gain

PARTS = {"s": ("push", "1 ms"), "t": ("mass1", "5 ms")}
WIRE = "s.F -> t.F (mean of s.p)"

WRONG = {
    "a counter that there is not": (
        "mean of s.P",
        ["mean of s.P: push has no output 'P'", "there are E, F, p", "case.toml, line"],
    ),
    "a parameter": ("mean of s.F_0", ["no output 'F_0'; its 'F_0' is declared with causality parameter", "line"]),
    "another unit": ("mean of s.E", ["the units do not fit: J is not that of N integrated over s", "case.toml, line"]),
    "the value itself": ("mean of s.F", ["the units do not fit: N is not that of N integrated over s", "line"]),
    "another component": (
        "mean of t.x",
        ["mean of t.x: the counter is of another component", "an output of s", "line"],
    ),
    "a component that there is not": ("mean of q.p", ["mean of q.p: the counter has no component", "line"]),
    "no component": ("mean of p", ["mean of p: the counter has no component", "line"]),
    "another transfer": ("hold of s.p", ["unknown transfer 'hold of s.p'", "line"]),
    "nothing": ("mean of", ["unknown transfer 'mean of'", "line"]),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_counter_is_refused_with_its_place(case: str, tmp_path: Path, fmus: Path) -> None:
    words, expected = WRONG[case]
    with pytest.raises(InputError) as refused:
        read_system(tmp_path, fmus, PARTS, [f"s.F -> t.F ({words})"])
    assert all(text in str(refused.value) for text in expected), str(refused.value)


@pytest.mark.parametrize("text", [WIRE, "s.F->t.F  (mean  of s.p)"])
def test_counter_is_kept_with_the_connection(text: str, tmp_path: Path, fmus: Path) -> None:
    (c,) = read_system(tmp_path, fmus, PARTS, [text]).connections
    assert (c.transfer, c.counter, c.per_second, c.counted) == ("mean", "p", 1.0, ("s", "p"))


def test_elements_of_arrays_have_counters_of_their_own(tmp_path: Path, fmus: Path) -> None:
    """An array of another size is refused; `u_thruster` has eight elements, i is one."""
    parts = {"c": ("rov_controller", "20 ms"), "v": ("rov_vehicle", "20 ms")}
    with pytest.raises(InputError, match="1 elements cannot count 8"):
        read_system(tmp_path, fmus, parts, ["c.u_thruster -> v.u_thruster (mean of c.V_in)"])


@pytest.mark.parametrize(
    ("counter", "value", "gain"),
    [("N.s", "N", 1.0), ("kN.s", "N", 1e3), ("N.m.s", "N.m", 1.0), ("J", "W", 1.0), ("kW.h", "W", 3.6e6),
     ("rad", "rad/s", 1.0), ("rev", "rad/s", 6.283185307179586), ("m", "m/s", 1.0), ("s", "1", 1.0), ("C", "A", 1.0)],
)  # fmt: skip
def test_gain_of_a_counter_is_that_of_its_unit_over_the_second(counter: str, value: str, gain: float) -> None:
    assert integral_gain(Unit(counter), Unit(value), "x") == pytest.approx(gain, rel=1e-12)
    assert integral_gain(None, Unit(value), "x") == integral_gain(Unit(counter), None, "x") == 1.0


@pytest.mark.parametrize(("counter", "value"), [("N", "N"), ("J", "N.m"), ("1", "rad/s"), ("N.s2", "N"), ("m/s", "m")])
def test_units_that_are_no_integral_are_refused(counter: str, value: str) -> None:
    with pytest.raises(InputError, match="the units do not fit"):
        integral_gain(Unit(counter), Unit(value), "x")


def test_a_unit_with_a_zero_point_has_no_integral() -> None:
    with pytest.raises(InputError, match="degC has a zero point of its own"):
        integral_gain(Unit("K.s"), Unit("degC"), "x")


def test_ssp_keeps_the_counter_and_the_bits(tmp_path: Path, fmus: Path) -> None:
    system = read_system(tmp_path, fmus, PARTS, [WIRE], stop="50 ms")
    again = load_system(str(write_ssp(system, tmp_path / "case.ssp")))
    assert [replace(c, where="") for c in again.connections] == [replace(c, where="") for c in system.connections]
    runs = [simulate(make_plan(s)) for s in (system, again)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]


def test_counter_decides_results_and_is_in_digest_and_manifest(tmp_path: Path, fmus: Path) -> None:
    counted, plain = (read_system(tmp_path, fmus, PARTS, [wire]) for wire in (WIRE, "s.F -> t.F (mean)"))
    assert digest(counted) != digest(plain)
    (entry,) = manifest(run_of(tmp_path, fmus, PARTS, [WIRE], stop="10 ms"))["connections"]
    assert entry == {"connection": "s.F -> t.F", "transfer": "mean", "counter": "s.p"}


def test_a_run_from_a_checkpoint_within_a_session_goes_on_bit_by_bit(tmp_path: Path, fmus: Path) -> None:
    parts = {"s": ("push", "3 ms"), "t": ("mass1", "5 ms")}  # a step of the source lies across ends of the target's
    plan = plan_of(tmp_path, fmus, parts, [WIRE], stop="150 ms")
    with Session(plan) as session:
        session.advance(cycles=3)
        write_checkpoint(session, tmp_path / "kept")
    with Session(plan) as session:
        read_checkpoint(tmp_path / "kept").restore(session)
        session.advance()
        run = session.run()
    assert column(run, "t.F")[1].tobytes() == column(simulate(plan), "t.F")[1].tobytes()


def test_recorded_or_not_the_counter_is_got(tmp_path: Path, fmus: Path) -> None:
    found = [
        column(run_of(tmp_path, fmus, PARTS, [WIRE], stop="50 ms", record=record), "t.F")[1]
        for record in (["*"], ["t.F"])
    ]
    assert found[0].tobytes() == found[1].tobytes()


def test_a_counter_counts_for_a_mean_alone(tmp_path: Path, fmus: Path) -> None:
    """A program that has the connection held: no counter in the plan, none in its SSP."""
    system = read_system(tmp_path, fmus, PARTS, [WIRE], stop="50 ms")
    held = replace(system, connections=tuple(replace(c, transfer="hold") for c in system.connections))
    again = load_system(str(write_ssp(held, tmp_path / "held.ssp")))
    assert [(c.transfer, c.counter) for c in again.connections] == [("hold", "")]
    plain = read_system(tmp_path, fmus, PARTS, ["s.F -> t.F (hold)"], stop="50 ms")
    runs = [simulate(make_plan(s)) for s in (held, again, plain)]
    assert len({column(run, "t.F")[1].tobytes() for run in runs}) == 1
