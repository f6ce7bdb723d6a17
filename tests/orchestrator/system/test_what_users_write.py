"""Names with any characters, values with units, items by name, inputs left alone, locals that are recorded."""

from __future__ import annotations

from pathlib import Path

import pytest
from cells_fmu import cells, scalar
from helpers import last, read_system, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.recorded import select_recorded
from rovbrush.orchestrator.system.inputs.free_inputs import require_values, start_notes

pytestmark = needs_gcc
ODD = ('a -> "b" [1]', "it's x.y", "tab[1,2].v (mean)", "π <&> 'q'", 'c" -> d.u')


@pytest.fixture
def fmus(tmp_path: Path) -> Path:
    """`odd`: outputs and inputs of strange names; `plain`: units, items, a local and parameters."""
    cells(tmp_path / "odd.fmu", [
        *(scalar(name, 100 + k) for k, name in enumerate(ODD)),
        *(scalar(f"{name} in", 10 + k, "input", start="0") for k, name in enumerate(ODD)),
        *(scalar(f"{name} at", 10 + k, "local") for k, name in enumerate(ODD)),
    ])  # fmt: skip
    cells(tmp_path / "plain.fmu", [
        scalar("u", 0, "input", start="0", unit="m"), scalar("v", 5, "input", start="1.5"), scalar("y", 100),
        scalar("x", 6, "local"), scalar("k", 6, "parameter", start="1", unit="mm", min="0", max="100"),
        scalar("bare", 7, "parameter", start="1"), scalar("n", 1, "parameter", "Integer", start="1"),
        scalar("mode", 3, "parameter", "Enumeration", declaredType="Mode", start="1"),
    ])  # fmt: skip
    return tmp_path


@pytest.mark.parametrize("transfer", ["", " (hold)"])
@pytest.mark.parametrize("name", ODD)
def test_connections_and_record_take_every_name(name: str, transfer: str, fmus: Path) -> None:
    parts = {"a": ("odd", "1 ms"), "b": ("odd", "1 ms")}
    record = [f"b.{name} at", f"a.{name}"]
    run = run_of(fmus, fmus, parts, [f"a.{name} -> b.{name} in{transfer}"], stop="3 ms", record=record)
    expected = 100.0 + ODD.index(name)
    assert last(run, f"a.{name}") == last(run, f"b.{name} at") == expected
    assert sum(len(group.columns) for group in run.plan.groups) == 2


@pytest.mark.parametrize(
    ("given", "value"),
    [
        ("5 mm", 5.0),
        ("0.5cm", 5.0),
        ("5e-3 m", 5.0),
        (".5 cm", 5.0),
        ("7", 7.0),
        (7, 7.0),
        ("5.mm", 5.0),
        ("1e1", 10.0),
        ("1e-300", 1e-300),
    ],
)
def test_a_value_may_have_its_unit(given: object, value: float, fmus: Path) -> None:
    system = read_system(fmus, fmus, {"a": ("plain", "1 ms", {"k": given})})
    assert system.components["a"].parameters["k"] == pytest.approx(value, rel=1e-15)
    assert system.with_values({"a.k": given}, "--set").components["a"].parameters["k"] == pytest.approx(value)


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("k", "5 kg", ["a.k = 5 kg", "kg cannot become mm"]), ("k", "5 furlogs", ["furlogs", "not understood"]),
        ("k", "5 m", ["out of range", "0 to 100 mm"]), ("k", "mm", ["is not a finite number"]),
        ("bare", "5 mm", ["states no unit", 'units = { "bare" = "mm" }']), ("n", "5 mm", ["not a whole number"]),
    ],
)  # fmt: skip
def test_a_unit_that_does_not_fit_is_one_error(name: str, given: str, words: list[str], fmus: Path) -> None:
    with pytest.raises(InputError) as error:
        read_system(fmus, fmus, {"a": ("plain", "1 ms", {name: given})})
    assert all(word in str(error.value) for word in words)


def test_inputs_that_nothing_drives_keep_the_start_values_and_are_named(fmus: Path) -> None:
    system = read_system(fmus, fmus, {"a": ("plain", "1 ms"), "o": ("odd", "1 ms")}, ["o.it's x.y -> a.u"])
    notes = start_notes(system)
    assert notes[0] == "a: nothing drives v = 1.5: the start values of its FMU are kept"
    assert len(notes) == 2 and "it's x.y in = 0" in notes[1]
    assert notes[0] in explain(make_plan(system))
    run = run_of(fmus, fmus, {"a": ("plain", "1 ms", {"=v": 2.0, "=u": "3 mm"})}, stop="2 ms")
    assert start_notes(run.plan.system) == [] and last(run, "a.y") == 100.003


def test_all_inputs_without_any_value_are_named_at_once(fmus: Path) -> None:
    system = read_system(fmus, fmus, {"a": ("plain", "1 ms"), "b": ("plain", "1 ms", {"=u": 1.0})})
    for component in system.components.values():  # as an FMU that breaks the standard says it
        for name in ("u", "v"):
            component.fmu.variables[name].start = None
    with pytest.raises(InputError) as error:
        require_values(system, lambda message, heading: InputError(f"{message} {heading}"))
    assert "inputs a.u, a.v, b.v have no driver" in str(error.value)
    assert "[components.a.inputs] u = 0.0, v = 0.0; [components.b.inputs] v = 0.0" in str(error.value)


def test_locals_and_parameters_are_recorded_by_name(fmus: Path) -> None:
    parts = {"a": ("plain", "1 ms", {"k": 4.0}), "b": ("plain", "2 ms")}
    run = run_of(fmus, fmus, parts, stop="4 ms", record=["a.x", "a.mode", "b.y", "a.k"])
    assert [group.columns for group in run.plan.groups] == [
        (("a", "x"), ("a", "k"), ("a", "mode")), (("b", "y"),)
    ]  # fmt: skip
    assert last(run, "a.x") == last(run, "a.k") == 4.0
    usual = read_system(fmus, fmus, parts)
    assert select_recorded(usual, ["a.*"]).record == ("a.*",)  # inputs and outputs
    assert select_recorded(usual, ["*.x"]).record == ("*.x", "a.x", "b.x")  # nothing but locals is called so
    with pytest.raises(InputError, match=r"--record a\.xx: no variable is called so; did you mean 'a\.x'"):
        select_recorded(usual, ["a.xx"])


@pytest.mark.parametrize("given", ["on", 7, "7"])
def test_an_item_of_an_enumeration_is_given_by_name_or_number(given: object, fmus: Path) -> None:
    system = read_system(fmus, fmus, {"a": ("plain", "1 ms", {"mode": given})})
    assert system.components["a"].parameters["mode"] == 7
    assert system.with_values({"a.mode": given}, "--set").components["a"].parameters["mode"] == 7
    with pytest.raises(InputError, match=r"a\.mode = onn .*did you mean 'on'"):
        system.with_values({"a.mode": "onn"}, "--set")
