"""Events on values of every type: what is set arrives, what breaks is held or lost, Booleans are watched."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Part, system_text
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
STOP, AT = "0.1 s", "0.05 s"


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def system_with(native: Path, folder: Path, version: int, events: str) -> System:
    fmu = str(native / f"feedthrough{version}.fmu")
    free, wires = (FREE2, WIRES2) if version == 2 else (FREE3, WIRES3)
    parts: dict[str, Part] = {"a": (fmu, "10 ms", free), "b": (fmu, "10 ms")}
    (folder / "case.toml").write_text(system_text(parts, wires, stop=STOP) + events, encoding="utf-8")
    return load_system(str(folder / "case.toml"))


def both(system: System) -> Run:
    plan = make_plan(system)
    run, other = simulate(plan), simulate(plan, interpreted=True)
    assert not run.failure and [t.tobytes() for t in run.tables] == [t.tobytes() for t in other.tables]
    return run


def before_and_after(run: Run, name: str) -> tuple[Any, Any]:
    """The values of a signal in the step before the event and in the last one."""
    signal = Signals(run)[name]
    return signal.values[np.searchsorted(signal.time, 0.0499) - 1], signal.values[-1]


@pytest.mark.parametrize(
    ("version", "name", "stated", "value"),
    [
        (2, "n", "3", 3), (2, "mode", "1", 1), (2, "on", "false", False), (2, "s", '"grün"', "grün"),
        (3, "Int8", "127", 127), (3, "UInt64", "9223372036854775807", 2**63 - 1), (3, "Int64", "-1", -1),
        (3, "Float32", "0.25", 0.25), (3, "Boolean", "false", False), (3, "String", '"x"', "x"),
    ],
)  # fmt: skip
def test_a_value_of_any_type_is_set_at_its_instant(
    version: int, name: str, stated: str, value: object, native: Path, tmp_path: Path
) -> None:
    event = f'\n[[events]]\nat = "{AT}"\nset = {{ "a.{name}_in" = {stated} }}\n'
    run = both(system_with(native, tmp_path, version, event))
    first = (FREE2 if version == 2 else FREE3)[f"={name}_in"]
    found = before_and_after(run, f"a.{name}_in")
    assert found == (pytest.approx(first, rel=1e-7) if isinstance(first, float) else first, value)


@pytest.mark.parametrize(
    ("version", "name", "lost"),
    [(2, "n", 0), (2, "mode", 1), (2, "on", False), (2, "s", ""), (3, "Int64", 0), (3, "UInt8", 0), (3, "String", "")],
)
def test_what_is_no_floating_point_number_is_held_or_lost(
    version: int, name: str, lost: object, native: Path, tmp_path: Path
) -> None:
    value = "value = 1\n" if name == "mode" else ""  # an Enumeration has no 0
    loss = f'\n[[events]]\nat = "{AT}"\nfault = "loss"\non = "a.{name}_out"\n{value}'
    run = both(system_with(native, tmp_path, version, loss))
    first = (FREE2 if version == 2 else FREE3)[f"={name}_in"]
    assert before_and_after(run, f"b.{name}_in") == (first, lost)
    other = {"n": "3", "mode": "1", "on": "false", "s": '"x"', "Int64": "5", "UInt8": "5", "String": '"y"'}[name]
    hold = f'\n[[events]]\nat = "{AT}"\nfault = "hold"\non = "b.{name}_in"\n'
    change = f'\n[[events]]\nat = "{AT}"\nset = {{ "a.{name}_in" = {other} }}\n'
    held = both(system_with(native, tmp_path, version, hold + change))
    assert before_and_after(held, f"b.{name}_in") == (first, first)
    assert before_and_after(held, f"a.{name}_out")[1] != first


def test_all_elements_of_an_array_are_set_and_broken_together(native: Path, tmp_path: Path) -> None:
    events = (
        f'\n[[events]]\nat = "{AT}"\nset = {{ "a.a_in" = [8, 7, 6, 5, 4, 3, 2, 1], "a.t_in[2]" = "z" }}\n'
        f'\n[[events]]\nat = "{AT}"\nfault = "scale"\non = "b.a_in"\nvalue = 10\n'
    )
    run = both(system_with(native, tmp_path, 3, events))
    assert [before_and_after(run, f"a.a_in[{k}]")[1] for k in range(1, 9)] == [8, 7, 6, 5, 4, 3, 2, 1]
    assert [before_and_after(run, f"b.a_in[{k}]")[1] for k in range(1, 9)] == [80, 70, 60, 50, 40, 30, 20, 10]
    assert [before_and_after(run, f"b.t_in[{k}]")[1] for k in (1, 2)] == ["a", "z"]


@pytest.mark.parametrize(("when", "seen"), [("a.on_out", 0.07), ("not a.on_out", 0.05), ("a.n_out > 2", 0.07)])
def test_booleans_and_whole_numbers_are_watched(when: str, seen: float, native: Path, tmp_path: Path) -> None:
    events = (
        f'\n[[events]]\nat = "{AT}"\nset = {{ "a.on_in" = false }}\n'
        '\n[[events]]\nat = "0.06 s"\nset = { "a.on_in" = true, "a.n_in" = 3 }\n'
        f'\n[[events]]\nname = "w"\nwhen = "{when}"\nset = {{ "a.u" = 7.0 }}\n'
    )
    run = both(system_with(native, tmp_path, 2, events))
    watched = [row.time for row in run.events if f"w: {when}" in row.what.split("; ")]
    assert watched == pytest.approx([seen if when != "not a.on_out" else 0.06])


def test_only_floating_point_signals_drift(native: Path, tmp_path: Path) -> None:
    event = f'\n[[events]]\nat = "{AT}"\nfault = "bias"\non = "b.n_in"\nvalue = 1\n'
    with pytest.raises(InputError, match=r'fault = "bias" is for floating-point signals, and b\.n_in is a Integer'):
        system_with(native, tmp_path, 2, event)
    boolean = '\n[[events]]\nwhen = "a.on_out > 0.5"\nset = { "a.u" = 1 }\n'
    with pytest.raises(InputError, match=r'a\.on_out is a Boolean; write when = "a\.on_out"'):
        system_with(native, tmp_path, 2, boolean)
    text = '\n[[events]]\nwhen = "a.s_out > 1"\nset = { "a.u" = 1 }\n'
    with pytest.raises(InputError, match=r"a\.s_out is of causality output and type String; take a numeric output"):
        system_with(native, tmp_path, 2, text)
