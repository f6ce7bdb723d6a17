"""Terminals are connected as wholes: the same connections as one by one, or an error that says what does not fit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import column, plan_of, read_system, run_of
from native_build import answers, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp
from terminal_files import member, stream, terminal, with_terminals

pytestmark = needs_gcc

FLANGE = [member("x"), member("v"), member("F", kind="inflow")]
OURS = [
    terminal("plug", member("u", "Float64_in"), member("y", "Float64_out")),
    terminal("turned", member("u", "Float64_out"), member("y", "Float64_in")),
    terminal("lone", member("u", "Float64_in")),
    terminal("words", member("u", "String_out"), member("y", "String_in")),
    terminal("ranks", member("one", "a_out"), member("", "Int8_in"), rule="sequence"),
    terminal("files", member("first", "a_in"), member("", "Int8_out"), rule="sequence"),
    terminal("file", member("first", "a_in"), rule="sequence"),
    terminal("bus", member("a", "a_in"), member("b", "Int8_out"), member("c", "Int16_in"), rule="bus"),
    terminal("coach", member("a", "a_out"), member("b", "Int8_in"), member("d", "Int32_in"), rule="bus"),
    terminal("other", member("z", "Int32_in"), rule="bus"),
    terminal("custom", member("u", "Float64_in"), rule="org.example.own"),
    terminal("current", member("i", "Float64_out", "inflow")),
    terminal("charge", member("i", "Float64_in", "inflow")),
    terminal("drain", member("i", "Float64_in", "outflow")),
    terminal("signal", member("i", "Float64_in")),
    terminal("fluid", member("m", "Float32_out", "outflow"), stream("Float64_in", "Float64_out")),
    terminal("pipe", member("m", "Float32_in", "inflow"), stream("Float64_in", "Float64_out")),
    terminal("nest", member("u", "Float64_in"), terminal("inner", member("a", "a_out"), rule="sequence")),
    terminal("egg", member("u", "Float64_out"), terminal("inner", member("a", "a_in"), rule="sequence")),
    terminal("bad egg", member("u", "Float64_out"), terminal("yolk", member("a", "a_in"), rule="sequence")),
    terminal("tuned", member("u", "Float64_in"), member("M", "M")),
    terminal("same", member("u", "Float64_out"), member("M", "M")),
]
PARTS = {"a": ("toy", "1 ms"), "b": ("toy", "1 ms")}


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("terminals")
    with_terminals(built(folder) / "feedthrough3.fmu", folder / "toy.fmu", OURS)
    (folder / "new").mkdir()
    with_terminals(answers(folder / "new" / "mass.fmu", "mass"), folder / "mass.fmu", [terminal("flange", *FLANGE)])
    # Terminals of FMI 2.0, in the folder for additions to the standard; `right` counts the same force the other way.
    ends = {
        name: [member("x", f"x{k}"), member("v", f"v{k}"), member("F", "F", kind)]
        for k, (name, kind) in enumerate({"left": "outflow", "right": "inflow"}.items(), 1)
    }
    place = "extra/org.fmi-standard.terminals/terminalsAndIcons.xml"
    force = answers(folder / "new" / "force.fmu", "force")
    with_terminals(force, folder / "force.fmu", [terminal(name, *own) for name, own in ends.items()], place)
    return folder


def labels(folder: Path, fmus: Path, wire: str, **keys: object) -> list[str]:
    system = read_system(folder, fmus, PARTS, [wire], **keys)
    turned = {True: "", False: " turned"}
    return [f"{c.label}{turned[c.gain == 1.0]}" for c in system.connections]


@pytest.mark.parametrize(
    ("wire", "expected"),
    [
        ("a.plug -> b.turned", ["b.Float64_out -> a.Float64_in", "a.Float64_out -> b.Float64_in"]),
        ("a.turned -> b.plug", ["a.Float64_out -> b.Float64_in", "b.Float64_out -> a.Float64_in"]),
        ("a.current -> b.charge", ["a.Float64_out -> b.Float64_in turned"]),
        ("a.current -> b.drain", ["a.Float64_out -> b.Float64_in"]),
        ("a.drain -> b.current", ["b.Float64_out -> a.Float64_in"]),
        ("a.fluid -> b.pipe", ["a.Float32_out -> b.Float32_in", "a.Float64_out -> b.Float64_in",
                               "b.Float64_out -> a.Float64_in"]),
        ("a.ranks -> b.files", [*(f"a.a_out[{k}] -> b.a_in[{k}]" for k in range(1, 9)), "b.Int8_out -> a.Int8_in"]),
        ("a.coach -> b.bus", [*(f"a.a_out[{k}] -> b.a_in[{k}]" for k in range(1, 9)), "b.Int8_out -> a.Int8_in"]),
        ("a.egg -> b.nest", ["a.Float64_out -> b.Float64_in", *(f"b.a_out[{k}] -> a.a_in[{k}]" for k in range(1, 9))]),
        ("a.egg.inner -> b.nest.inner", [f"b.a_out[{k}] -> a.a_in[{k}]" for k in range(1, 9)]),
        ("a.same -> b.tuned", ["a.Float64_out -> b.Float64_in"]),
    ],
)  # fmt: skip
def test_terminals_stand_for_the_connections_of_their_members(
    wire: str, expected: list[str], fmus: Path, tmp_path: Path
) -> None:
    assert labels(tmp_path, fmus, wire) == expected


@pytest.mark.parametrize(
    ("wire", "words"),
    [
        ("a.plug -> b.plug", r"a\.plug and b\.plug: member 'u' is input on both sides; an output must meet an input; "
                             r".*member 'y' is output on both sides"),
        ("a.plug -> b.lone", r"a\.plug has the member 'y', which b\.lone lacks"),
        ("a.lone -> b.turned", r"b\.turned has the member 'y', which a\.lone lacks"),
        ("a.ranks -> b.file", r"a\.ranks has 2 members, b\.file has 1"),
        ("a.bus -> b.other", r"the terminals have no signals in common"),
        ("a.bus -> b.plug", r"a\.bus is matched by bus, b\.plug by plug"),
        ("a.custom -> b.plug", r"a\.custom follows the rule 'org\.example\.own', which is none of plug, bus and seq"),
        ("a.current -> b.signal", r"member 'i' is inflow and signal, which are no pair"),
        ("a.bad egg -> b.nest", r"b\.nest has the terminal 'inner', which a\.bad egg lacks"),
        ("a.plug -> b.words", r"no conversion between them; .* as a part of a\.plug -> b\.words"),
        ("a.plug -> b.Float64_in", r"a\.plug is a terminal and b\.Float64_in is none"),
        ("a.Float64_out -> b.plug", r"b\.plug is a terminal and a\.Float64_out is none"),
        ("a.plgu -> b.plug", r"b\.plug is a terminal and a\.plgu is none; did you mean 'plug'\?"),
        ("a.plgu -> b.plgu", r"has no output 'plgu'; did you mean 'plug'\?"),
        ("a.plug -> c.plug", r"no component 'c'"),
    ],
)  # fmt: skip
def test_terminals_that_do_not_fit_are_one_error(wire: str, words: str, fmus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=words) as raised:
        read_system(tmp_path, fmus, PARTS, [wire])
    assert "(case.toml, line 3)" in str(raised.value)


def test_parameters_of_both_terminals_must_be_the_same(fmus: Path, tmp_path: Path) -> None:
    parts = {**PARTS, "b": ("toy", "1 ms", {"M": [1.0, 2.0, 3.0, 5.0]})}
    with pytest.raises(InputError, match=r"'M' is a parameter of both, a\.M = 1\.0, 2\.0, 3\.0, 4\.0 and b\.M"):
        read_system(tmp_path, fmus, parts, ["a.same -> b.tuned"])


def test_two_terminals_are_connected_once(fmus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"input a\.Float64_in is driven twice"):
        read_system(tmp_path, fmus, PARTS, ["a.plug -> b.turned", "b.turned -> a.plug"])


def test_a_transfer_counts_for_all_members(fmus: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, fmus, {**PARTS, "b": ("toy", "2 ms")}, ["a.plug -> b.turned (hold)"])
    assert [c.transfer for c in system.connections] == ["hold", "hold"]


def test_masses_by_terminals_move_as_by_single_wires(fmus: Path, tmp_path: Path) -> None:
    parts = {
        "one": ("mass", "1 ms", {"m": 1.0, "x0": 1.0}), "two": ("mass", "1 ms", {"m": 2.0}),
        "spring": ("force", "1 ms", {"k": 100.0, "d": 0.5}),
    }  # fmt: skip
    whole = run_of(tmp_path, fmus, parts, ["spring.left -> one.flange", "two.flange -> spring.right"], stop="1 s")
    wires = [f"{name}.{v} -> spring.{v}{k}" for k, name in ((1, "one"), (2, "two")) for v in "xv"]
    single = run_of(tmp_path, fmus, parts, [*wires, "spring.F -> one.F", "spring.back -> two.F"], stop="1 s")
    for name in ("one.x", "two.x", "two.v"):
        assert (column(whole, name)[1] == column(single, name)[1]).all(), name
    assert np.ptp(column(whole, "two.x")[1]) > 0.1
    momentum = column(whole, "one.v")[1] + 2.0 * column(whole, "two.v")[1]
    assert abs(momentum).max() < 1e-12, "what flows into one flows out of the other"


def test_plan_and_ssp_show_the_single_connections(fmus: Path, tmp_path: Path) -> None:
    plan = plan_of(tmp_path, fmus, PARTS, ["a.current -> b.charge"])
    assert "a.Float64_out -> b.Float64_in" in explain(plan)
    path = tmp_path / "out.ssp"
    write_ssp(plan.system, path)
    again = load_system(str(path))
    assert [(c.label, c.gain) for c in again.connections] == [("a.Float64_out -> b.Float64_in", -1.0)]
