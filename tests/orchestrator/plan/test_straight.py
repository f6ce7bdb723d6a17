"""Machine code of a plan's own has the bits of its operations, ends where they end, and is made when it pays."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import plan_of, read_system
from hypothesis import HealthCheck, given, settings
from native_build import FREE3, built, moody, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.machine import objects
from rovbrush.orchestrator.loop.straight import code as straight_code
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.plan.speed import straight
from rovbrush.orchestrator.plan.speed.straight import worth_of
from rovbrush.orchestrator.run.blocks.straight_on import ALWAYS, NEVER
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.studies.bench.fmus.mixed import mixed_ring
from rovbrush.orchestrator.studies.bench.fmus.native import ring
from rovbrush.orchestrator.system.file.reader import load_system
from test_fused import CAR, KINDS, WHOLE, bits, by_hand_and_back, stopped_and_on
from test_plan_random import system_of, systems


def has_code(session: Session) -> bool:
    return any(program.code or program.segments for program in session._blocks._programs.values())


def require_the_same(plan: Plan, covered: bool | None = True) -> tuple[Any, ...]:
    """As operations one by one, and with code of its own; what both gave."""
    found = []
    for when in (NEVER, ALWAYS):
        with Session(plan, fuses=when == ALWAYS, straight=when) as session:
            session.advance()
            found.append(bits(session.run()))
            assert covered is None or has_code(session) == (covered and when == ALWAYS)
    assert found[0] == found[1]
    return found[0]


@settings(max_examples=12, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(case=systems())
def test_random_systems_have_the_same_bits_and_failures(case: dict[str, Any], tmp_path: Path, fmus: Path) -> None:
    try:
        plan = make_plan(system_of(case, tmp_path, fmus))
    except InputError:
        return
    require_the_same(plan, covered=None)


@pytest.mark.parametrize("algorithm", KINDS)
def test_every_algorithm_has_the_same_bits(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts, wires = CAR
    if algorithm in ("ecco", "adaptive"):
        parts = {name: (fmu, "2 ms") for name, (fmu, _) in parts.items()}
    plan = plan_of(tmp_path, fmus, parts, wires, stop="100 ms", algorithm=algorithm, **KINDS[algorithm])
    assert not require_the_same(plan)[2]
    assert bool(worth_of(plan).segments) == (algorithm not in ("jacobi", "gauss-seidel"))


@needs_gcc
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(
    "bad",
    [
        {"ON_STEP": "if (t > 0.0049) return fmi2Error;"},
        {"ON_STEP": "if (t > 0.0049) return fmi2Discard;"},
        {"ON_STEP": "if (t > 0.0049) m->x = 0.0 / 0.0;"},
        {"ON_STEP": "if (t > 0.0049) m->x = -1.0 / 0.0;"},
        {"ON_SET": "if (m->steps == 5) return fmi2Error;"},
        {"ON_GET": "if (m->steps == 5) return fmi2Fatal;"},
        {"ON_STEP": WHOLE, "REACHED": "t0 + h0", "TERMINATED": "1"},
    ],
    ids=["error", "discard", "nan", "infinite", "set", "get", "asks to end"],
)  # fmt: skip
def test_who_fails_is_named_as_ever(bad: dict[str, str], algorithm: str, tmp_path: Path) -> None:
    moody(tmp_path / "m.fmu", **bad)
    moody(tmp_path / "g.fmu")
    parts = {"g": ("g.fmu", "1 ms"), "m": ("m.fmu", "1 ms"), "f": ("g.fmu", "1 ms")}
    wires = ["g.x -> m.u", "m.x -> g.u", "m.y -> f.u"]
    plan = make_plan(read_system(tmp_path, tmp_path, parts, wires, "10 ms", algorithm=algorithm))
    found = require_the_same(plan, covered=None if "TERMINATED" in bad else True)
    assert "component m" in found[2] + found[3]


@needs_gcc
def test_fmi_1_2_and_3_and_packed_types_have_the_same_bits(tmp_path: Path) -> None:
    mixed = load_system(str(mixed_ring(tmp_path, stop="5 ms")))
    require_the_same(make_plan(replace(mixed, algorithm="jacobi")))
    built(tmp_path)
    moody(tmp_path / "g.fmu")
    kinds = ["Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Boolean"]
    kinds += ["Enumeration"]
    driven = {name: value for name, value in FREE3.items() if name[1:-3] not in kinds}
    parts = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "2 ms", driven), "g": ("g.fmu", "1 ms")}
    wires = [f"a.{kind}_out -> b.{kind}_in" for kind in kinds]
    system = read_system(tmp_path, tmp_path, parts, [*wires, "a.Float64_out -> g.u"], "5 ms")
    record = tuple(f"{name}.{kind}_out" for name in "ab" for kind in kinds)
    whole = require_the_same(make_plan(replace(system, record=record)))
    assert whole[0] and not whole[2]
    given = worth_of(make_plan(system))  # texts among it
    assert given.segments and given.operations < len(make_plan(system).cycle)
    require_the_same(make_plan(system))


@needs_gcc
def test_more_operations_than_a_piece_has_and_multiple_rates_have_the_same_bits(tmp_path: Path) -> None:
    system = load_system(str(ring(tmp_path, 30, stop="7 ms")))
    require_the_same(make_plan(replace(system, algorithm="jacobi")))
    moody(tmp_path / "g.fmu")
    parts = {"a": ("g.fmu", "1 ms"), "b": ("g.fmu", "2 ms"), "c": ("g.fmu", "3 ms")}
    wires = ["a.x -> b.u", "b.x -> c.u", "c.x -> a.u"]
    # 20 ms are no multiple of 6 ms, and times are no doubles: the last steps are shorter.
    plan = make_plan(read_system(tmp_path, tmp_path, parts, wires, "20 ms"))
    assert not require_the_same(plan)[2]


@needs_gcc
@pytest.mark.parametrize("record", [(), ("c0.y",), ("*",)])
def test_what_is_recorded_is_the_same_whatever_the_blocks(record: tuple[str, ...], tmp_path: Path) -> None:
    system = replace(load_system(str(ring(tmp_path, 12, stop="30 ms"))), record=record)
    plan = make_plan(system)
    whole = require_the_same(plan)
    with Session(plan, straight=ALWAYS) as session:
        for cycles in (1, 7, 2, 20):
            session.advance(cycles=cycles)
        assert bits(session.run()) == whole


@needs_gcc
def test_steps_by_hand_and_snapshots_have_the_same_bits(tmp_path: Path) -> None:
    assert by_hand_and_back(tmp_path, straight=NEVER) == by_hand_and_back(tmp_path, straight=ALWAYS)


@needs_gcc
def test_a_stop_request_ends_it_at_the_same_operation_and_it_goes_on(tmp_path: Path) -> None:
    ends = [stopped_and_on(tmp_path, straight=when) for when in (NEVER, ALWAYS)]
    assert ends[0] == ends[1] and ends[0][0][2].startswith("interrupted")


@pytest.fixture
def nothing_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty cache, and a process that has no code yet."""
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(straight_code, "_loaded", {})
    yield tmp_path / "cache"


@needs_gcc
def test_code_is_made_once_it_has_paid_and_loaded_by_the_next_run(
    nothing_kept: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    system = replace(load_system(str(ring(tmp_path, 4))), stop=Fraction(10_000), record=())
    plan = make_plan(system)
    monkeypatch.setattr(straight, "SAVED", 5e-7)
    worth = worth_of(plan)
    assert 10_000 < worth.to_load < worth.to_compile < 100_000
    made: list[str] = []
    own = straight_code.object_of
    monkeypatch.setattr(straight_code, "object_of", lambda text: made.append(text) or own(text))
    with Session(plan) as session:
        session.advance(cycles=worth.to_compile - 1)
        assert not has_code(session) and not made
        session.advance(cycles=10 * worth.to_compile - session.at.cycle)
        assert has_code(session) and len(made) == 1
    monkeypatch.setattr(straight_code, "_loaded", {})
    with Session(plan) as session:
        session.advance(cycles=worth.to_compile - 1)
        assert session.at.cycle < worth.to_compile and has_code(session) and len(made) == 1


@needs_gcc
def test_a_short_run_and_one_without_llvm_make_none(
    nothing_kept: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = make_plan(load_system(str(ring(tmp_path, 4, stop="1 s"))))
    with Session(plan) as session:
        session.advance()
        assert not has_code(session)
    monkeypatch.setattr("rovbrush.orchestrator.run.blocks.straight_on.find_spec", lambda name: None)
    with Session(plan, straight=ALWAYS) as session:
        session.advance()
        assert not has_code(session) and not session.failure
    assert not (nothing_kept / "loops").exists()


@needs_gcc
def test_damaged_code_is_compiled_anew(nothing_kept: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plan = make_plan(load_system(str(ring(tmp_path, 2, stop="3 ms"))))
    whole = require_the_same(plan)
    (entry,) = (nothing_kept / "loops").iterdir()
    content = bytearray((entry / objects.FILE).read_bytes())
    content[len(content) // 2] ^= 255
    (entry / objects.FILE).write_bytes(content)
    monkeypatch.setattr(straight_code, "_loaded", {})
    assert require_the_same(plan) == whole
    assert (entry / objects.FILE).read_bytes() != bytes(content)


@needs_gcc
def test_the_text_holds_no_address_and_is_the_same_for_other_parameters(tmp_path: Path) -> None:
    from rovbrush.orchestrator.loop.straight.text import Straight

    plan = make_plan(load_system(str(ring(tmp_path, 3, stop="3 ms"))))
    texts = []
    for _ in range(2):
        with Session(plan) as session:
            components, blocks = session.loop.components, session.loop.blocks
            written = Straight(plan.cycle, components, blocks, [group.slots for group in plan.groups])
            texts.append(written.whole_text())
            assert not any(str(address) in texts[-1] for address in written.addresses(components, blocks).tolist())
            assert np.all(written.addresses(components, blocks) != 0)
    assert texts[0] == texts[1]


@needs_gcc
def test_the_plan_says_when_it_has_code_of_its_own_and_what_that_costs(tmp_path: Path, fmus: Path) -> None:
    system = load_system(str(ring(tmp_path, 4)))
    short, long = (explain(make_plan(replace(system, stop=Fraction(stop)))) for stop in (10, 100_000))
    worth = worth_of(make_plan(system))
    assert f"machine code of its own: not in this run of 10000 cycles, it pays from {worth.to_load} on (17 " in short
    assert f"code of its own: behind {worth.to_load} of 100000000 cycles, or behind {worth.to_compile} where" in long
    parts, wires = CAR
    plan = plan_of(tmp_path, fmus, parts, wires, stop="100 ms", algorithm="iterated", **KINDS["iterated"])
    assert "(40 of 49 operations, in 5 segments; loaded in 0.1 s" in explain(plan)
