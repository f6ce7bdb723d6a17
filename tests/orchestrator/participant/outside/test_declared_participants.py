"""A participant that is no FMU: its variables as declared, its values in their types, its life and its state."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.fmu.outside.declared import Declared, DeclaredFmu, declared_fmu
from rovbrush.orchestrator.fmu.outside.model import Model
from rovbrush.orchestrator.participant.base import CallError
from rovbrush.orchestrator.participant.outside.instance import DeclaredInstance
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.write import write_ssp

VARIABLES = [
    Declared("u", "input", unit="N"), Declared("on", "input", "Boolean", start=True),
    Declared("k", "parameter", "Integer", start=2, minimum=1, maximum=5),
    Declared("y", "output", unit="N.s"), Declared("n", "output", "Integer"), Declared("odd", "output", "Boolean"),
]  # fmt: skip


class Sums(Model):
    """y' = k u while it is on; n counts steps."""

    closed = 0

    def step(self, time: float, length: float) -> int | None:
        v = self.values
        assert type(v["on"]) is bool and type(v["k"]) is int and type(v["u"]) is float
        v["y"] += length * v["k"] * v["u"] * v["on"]
        v["n"] += 1
        v["odd"] = v["n"] % 2 == 1
        return None

    def close(self) -> None:
        Sums.closed += 1

    def notes(self) -> list[str]:
        return [f"{self.values['n']} steps"]


def fmu(variables: list[Declared] = VARIABLES, **keys: Any) -> DeclaredFmu:
    made: DeclaredFmu = declared_fmu("sums", variables, Path("sums.py"), "Python object", model=Sums, **keys)
    return made


def system(inputs: Mapping[str, Any] | None = None) -> System:
    a = Component("a", fmu(), Fraction(1, 100), parameters={"k": 3}, inputs={"u": 2.0, "on": True})
    b = Component("b", fmu(), Fraction(1, 50))
    wires = (Connection(("a", "y"), ("b", "u"), "hold"), Connection(("a", "odd"), ("b", "on"), "hold"))
    return System("sums", Path("sums.toml"), "", Fraction(1, 10), "jacobi", ("a", "b"), {"a": a, "b": b}, wires)


def run(interpreted: bool) -> Run:
    with Session(make_plan(system()), interpreted=interpreted) as session:
        session.advance()
        return session.run()


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_values_of_all_types_cross_as_declared(interpreted: bool) -> None:
    run_ = run(interpreted)
    assert not run_.failure
    found = Result(run_)
    assert found["a.n"].values.tolist() == list(range(11))
    assert found["a.odd"].values.tolist() == [False, True] * 5 + [False]
    assert found["a.y"].values[-1] == pytest.approx(10 * 0.01 * 3 * 2.0, rel=1e-12)
    assert found["b.y"].values.tolist() == [0.0] * 6  # `odd` is false at all of its instants


def test_it_is_closed_once_and_its_notes_are_those_of_the_end() -> None:
    before = Sums.closed
    found = run(True)
    assert Sums.closed == before + 2
    assert found.notes == ["10 steps", "5 steps"]


def test_a_checkpoint_goes_on_bit_by_bit(tmp_path: Path) -> None:
    whole = run(True)
    plan = make_plan(system())
    with Session(plan, interpreted=True) as session:
        session.advance(cycles=2)
        write_checkpoint(session, tmp_path)
    with Session(plan, interpreted=True) as session:
        read_checkpoint(tmp_path).restore(session)
        session.advance()
        found = session.run()
    assert [a.tobytes() for a in found.tables] == [a.tobytes() for a in whole.tables]


def test_another_digest_refuses_a_checkpoint() -> None:
    assert fmu().digest == fmu().digest
    assert len({fmu().digest, fmu(content=b"other").digest, fmu(VARIABLES[:3]).digest}) == 3


def test_the_plan_says_what_it_is() -> None:
    assert "sums.py, Python object, sha256" in "\n".join(explain(make_plan(system())).splitlines())


def test_files_of_other_tools_cannot_hold_it(tmp_path: Path) -> None:
    wanted = r"component a is no FMU but a Python object \(sums.py\), and"
    with pytest.raises(InputError, match=f"{wanted} a container can hold FMUs only"):
        write_container(system(), tmp_path / "a.fmu")
    with pytest.raises(InputError, match=f"{wanted} an SSP is made of FMUs only"):
        write_ssp(system(), tmp_path / "a.ssp")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("variable", "words"),
    [
        (Declared("x", "input", unit="banana"), "banana"),
        (Declared("x", "input", "Boolean", unit="N"), "x is of type Boolean, which has no unit"),
        (Declared("x", "input", minimum=2.0, maximum=1.0), "x: min = 2 is above max = 1"),
        (Declared("x", "input", start=7.0, maximum=1.0), "start of x = 7 is out of range"),
        (Declared("x", "input", "Integer", start=1.5), "start of x"),
        (Declared("u", "output"), "u is declared twice"),
    ],
)
def test_a_declaration_that_cannot_be_is_refused(variable: Declared, words: str) -> None:
    with pytest.raises(InputError, match=words):
        fmu([Declared("u", "input"), variable])


def test_what_cannot_save_its_state_says_so() -> None:
    instance = DeclaredInstance(fmu(saves=False), "s")
    assert not instance.fmu.can_save_state and not instance.fmu.can_serialize_state
    with pytest.raises(Exception, match="cannot save its state"):
        instance.save()
    with pytest.raises(CallError, match="has no states for the disk"):
        instance.deserialize(b"{}")
