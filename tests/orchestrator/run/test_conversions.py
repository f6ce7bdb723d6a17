"""Between types: what loses nothing arrives exactly, what could is refused or rounded, what is unfit ends the run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import plan_of, read_system, run_of
from native_build import FREE2, FREE3, NUMBERS3, built, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.connections.connections import connections_of
from rovbrush.orchestrator.system.file.connections.link import Link
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.replace.mapping import load_mapping
from rovbrush.orchestrator.system.replace.replacement import replace_component
from rovbrush.orchestrator.system.ssp.write import write_ssp
from rovbrush.orchestrator.toml.file import TomlFile

pytestmark = needs_gcc
TYPES = ("Float64", *NUMBERS3, "Boolean", "Enumeration")
BITS = {"Float64": 53, "Float32": 24}


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def loses_nothing(source: str, target: str) -> bool:
    """What the types say, without any look at the implementation."""
    if source == target:
        return True
    if target == "Boolean" or (source.startswith("Float") and not target.startswith("Float")):
        return False
    if target == "Enumeration":  # checked value by value
        return source != "UInt64"
    if source == "Boolean":
        return True
    size = {name: int("".join(c for c in name if c.isdigit()) or 64) for name in (source, target)}
    if source.startswith("Float"):
        return size[source] <= size[target]
    if source == "Enumeration":  # items 1 and 2^53 + 1
        return target in ("Int64", "UInt64")
    bits = size[source] - (not source.startswith("U"))
    if target in BITS:
        return bits <= BITS[target]
    return bits <= size[target] - (not target.startswith("U")) and (
        source.startswith("U") or not target.startswith("U")
    )


def refused(wire: str, native: Path, folder: Path) -> str:
    target = wire.split(" -> b.")[1].split()[0]
    free = {key: value for key, value in FREE3.items() if key[1:] != target}
    try:
        plan_of(folder, native, {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "1 ms", free)}, [wire])
    except InputError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("source", TYPES)
def test_what_could_lose_something_is_refused_with_the_words_that_allow_it(
    source: str, native: Path, tmp_path: Path
) -> None:
    for target in TYPES:
        wire = f"a.{source}_out -> b.{target}_in"
        said = refused(wire, native, tmp_path)
        assert bool(said) != loses_nothing(source, target), (source, target, said)
        if said and target != "Boolean":
            assert f'write "{wire} (round)"' in said
            assert not refused(f"{wire} (round)", native, tmp_path)


@pytest.mark.parametrize("interpreted", [False, True])
def test_every_conversion_that_loses_nothing_arrives_exactly(interpreted: bool, native: Path, tmp_path: Path) -> None:
    """Targets b0, b1, ... take from every source in turn; an Enumeration takes items only."""
    sent = FREE3 | {"=UInt64_in": 2**64 - 1}
    parts: dict[str, Any] = {"a": ("feedthrough3", "1 ms", sent)}
    wires, expected = [], {}
    for k, shift in enumerate(range(1, len(TYPES))):
        free = dict(FREE3)
        for j, target in enumerate(TYPES):
            source = TYPES[(j + shift) % len(TYPES)]
            if loses_nothing(source, target) and target != "Enumeration":
                wires.append(f"a.{source}_out -> b{k}.{target}_in")
                value = sent[f"={source}_in"]
                expected[f"b{k}.{target}"] = float(np.float32(value)) if "Float32" in (source, target) else value
                del free[f"={target}_in"]
        parts[f"b{k}"] = ("feedthrough3", "2 ms", free)
    signals = Signals(run_of(tmp_path, native, parts, wires, stop="6 ms", interpreted=interpreted))
    assert len(expected) > 40
    for name, value in expected.items():
        assert signals[f"{name}_in"].values.tolist()[1:] == [value] * 3, name
        assert signals[f"{name}_out"].values.tolist()[-1] == value, name


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_numbers_of_fmi2_go_where_they_fit(interpreted: bool, algorithm: str, native: Path, tmp_path: Path) -> None:
    wires = [
        "a.n_out -> b.u",
        "a.on_out -> b.n_in",
        "a.n_out -> b.mode_in",
        "a.mode_out -> c.u",
        "a.mode_out -> c.n_in",
    ]
    parts = {
        "a": ("feedthrough2", "1 ms", FREE2 | {"=n_in": 2}),
        "b": ("feedthrough2", "2 ms", {"=on_in": False, "=s_in": ""}),
        "c": ("feedthrough2", "0.5 ms", {"=mode_in": 1, "=on_in": False, "=s_in": ""}),
    }  # fmt: skip
    run = run_of(tmp_path, native, parts, wires, stop="4 ms", algorithm=algorithm, interpreted=interpreted)
    signals = Signals(run)
    found = {name: set(signals[name].values.tolist()) for name in ("b.y", "b.n_out", "b.mode_out", "c.y", "c.n_out")}
    assert found == {"b.y": {2.0}, "b.n_out": {1}, "b.mode_out": {2}, "c.y": {2.0}, "c.n_out": {2}}
    text = explain(run.plan)
    assert "a Integer is held; converted: Integer to Real" in text
    assert "converted: Integer to Enumeration, its items checked" in text
    assert "converted: Enumeration to Integer" in text


@pytest.mark.parametrize("interpreted", [False, True])
def test_a_number_that_is_no_item_ends_the_run_and_is_named(interpreted: bool, native: Path, tmp_path: Path) -> None:
    table = {"time": [0.0, 0.0025, 1.0], "values": [1, 7, 7]}  # the items: off (1), on (2)
    parts = {"a": ("feedthrough2", "1 ms", {k: v for k, v in FREE2.items() if k != "=n_in"} | {"=n_in": table}),
             "b": ("feedthrough2", "1 ms", {"=u": 0.0, "=n_in": 0, "=on_in": False, "=s_in": ""})}  # fmt: skip
    run = simulate(plan_of(tmp_path, native, parts, ["a.n_out -> b.mode_in"], stop="6 ms"), interpreted)
    assert "connection a.n_out -> b.mode_in: 7 is none of its items, 1, 2 at t = 0.004 s" in run.failure
    assert Signals(run)["b.mode_out"].values.tolist() == [1, 1, 1, 1]


def test_enumerations_of_other_items_say_which(native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough3", "1 ms", {}), "b": ("feedthrough2", "1 ms", {})}
    with pytest.raises(InputError, match=r"differ: only the output has .*; put an FMU between that makes one of the o"):
        read_system(tmp_path, native, parts, ["a.Enumeration_out -> b.mode_in"])


@pytest.mark.parametrize("value", [1e300, -1e300, 3.5e38])
@pytest.mark.parametrize("how", ["file", "set", "session", "table", "connection"])
def test_a_number_beyond_float32_is_refused_by_its_name_wherever_it_comes_from(
    how: str, value: float, native: Path, tmp_path: Path
) -> None:
    said = r"Float32_in.*is (beyond what its type holds|out of range: -3.40282e\+38 to 3.40282e\+38 are)"
    free = dict(FREE3)
    wires, parts = [], {"b": ("feedthrough3", "1 ms", free)}
    if how in ("file", "table"):
        free["=Float32_in"] = value if how == "file" else {"time": [0.0, 1.0], "values": [0.0, value]}
    if how == "table":
        said = r"inputs of b \(case.toml, line \d+\) = \S+ is out of range: -3.40282e\+38 to 3.40282e\+38 are"
    if how == "connection":
        del free["=Float32_in"]
        parts["a"] = ("feedthrough3", "1 ms", FREE3 | {"=Float64_in": value})
        wires = ["a.Float64_out -> b.Float32_in (round)"]
        said = "connection a.Float64_out -> b.Float32_in: at time 0 .* is beyond what its type holds"
    with pytest.raises((InputError, FmuError), match=said):
        system = read_system(tmp_path, native, parts, wires, stop="3 ms")
        if how == "set":
            system = system.with_values({"b.Float32_in": value}, "--set")
        with Session(make_plan(system)) as session:
            if how == "session":
                session.set("b.Float32_in", value)


@pytest.mark.parametrize("interpreted", [False, True])
def test_and_so_is_one_that_a_connection_brings_while_the_run_goes(
    interpreted: bool, native: Path, tmp_path: Path
) -> None:
    """The rows before it stay; the largest number that is rounded to a finite one is taken."""
    table = {"time": [0.0, 0.002, 0.0021, 1.0], "values": [3.4028235e38, 3.4028235e38, 1e39, 1e39]}
    parts = {"a": ("feedthrough3", "1 ms", FREE3 | {"=Float64_in": table}),
             "b": ("feedthrough3", "1 ms", {k: v for k, v in FREE3.items() if k != "=Float32_in"})}  # fmt: skip
    plan = plan_of(
        tmp_path, native, parts, ["a.Float64_out -> b.Float32_in (hold, round)"], stop="9 ms", order=["a", "b"]
    )
    run = simulate(plan, interpreted)
    assert "component b: Float32_in = " in run.failure and "is beyond what its type holds" in run.failure
    assert len(run.tables[0]) >= 2


def test_a_number_that_is_no_item_at_time_0_is_an_error(native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", FREE2 | {"=n_in": 3}), "b": ("feedthrough2", "1 ms", {"=u": 0.0})}
    with pytest.raises(FmuError, match=r"connection a.n_out -> b.mode_in: at time 0 3 is none of its items, 1, 2"):
        simulate(plan_of(tmp_path, native, parts, ["a.n_out -> b.mode_in"]))


ROUNDED = {
    "Int32": {2.5: 2, 3.5: 4, -0.4: 0, -1.6: -2, 2.0**31 - 1: 2**31 - 1, -(2.0**31) - 0.4: -(2**31)},
    "UInt64": {2.0**63: 2**63, 2.0**64 - 2048: 2**64 - 2048, -0.4: 0},
    "Int64": {-(2.0**63): -(2**63), 2.0**63 - 1024: 2**63 - 1024},
    "UInt8": {254.5: 254, 255.4: 255},
}
UNFIT = {"Int32": 2.0**31, "UInt64": 2.0**64, "Int64": 2.0**63, "UInt8": 255.5, "Int8": -129.0}


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("target", ROUNDED)
def test_round_takes_the_nearest_whole_number_the_even_one_of_two(
    interpreted: bool, target: str, native: Path, tmp_path: Path
) -> None:
    values = list(ROUNDED[target])
    times = [k / 1000 for k in range(1, len(values) + 1) for _ in (0, 1)]
    table = {"time": [0.0, *times], "values": [v for v in values for _ in (0, 1)] + values[-1:]}
    table["time"][-1] = 1.0
    free = {k: v for k, v in FREE3.items() if k != f"={target}_in"}
    parts = {"a": ("feedthrough2", "1 ms", {**FREE2, "=u": table}), "b": ("feedthrough3", "1 ms", free)}
    wires = [f"a.y -> b.{target}_in (round)"]
    system = read_system(tmp_path, native, parts, wires, stop=f"{len(values) + 1} ms")
    run = simulate(make_plan(system), interpreted)
    assert not run.failure
    assert Signals(run)[f"b.{target}_in"].values.tolist()[2:] == list(ROUNDED[target].values())  # b samples


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("target", UNFIT)
def test_what_a_type_does_not_hold_ends_the_run(interpreted: bool, target: str, native: Path, tmp_path: Path) -> None:
    table = {"time": [0.0, 0.002, 0.002, 1.0], "values": [1.0, 1.0, UNFIT[target], UNFIT[target]]}
    free = {k: v for k, v in FREE3.items() if k != f"={target}_in"}
    parts = {"a": ("feedthrough2", "1 ms", {**FREE2, "=u": table}), "b": ("feedthrough3", "1 ms", free)}
    run = simulate(plan_of(tmp_path, native, parts, [f"a.y -> b.{target}_in (round)"], stop="5 ms"), interpreted)
    assert "is beyond what its type holds at t = 0.004 s" in run.failure and f"b.{target}_in" in run.failure


def test_whole_numbers_beyond_the_other_type_end_the_run_too(native: Path, tmp_path: Path) -> None:
    for source, target, value in (("Int64", "UInt64", -1), ("UInt64", "Int64", 2**63), ("Int16", "Int8", 128)):
        free = {k: v for k, v in FREE3.items() if k != f"={target}_in"}
        table = {"time": [0.0, 0.002, 1.0], "values": [1, value, value]}
        parts = {"a": ("feedthrough3", "1 ms", {**FREE3, f"={source}_in": table}), "b": ("feedthrough3", "1 ms", free)}
        for interpreted in (False, True):
            run = simulate(
                plan_of(tmp_path, native, parts, [f"a.{source}_out -> b.{target}_in (round)"], stop="5 ms"), interpreted
            )
            assert f"{value:g} is beyond what its type holds" in run.failure, (source, target)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_a_loop_through_a_conversion_is_consistent_at_time_0_and_goes_on(
    algorithm: str, interpreted: bool, native: Path, tmp_path: Path
) -> None:
    """n -> u -> n: whatever it begins with stays."""
    parts = {"a": ("feedthrough2", "1 ms", {k: v for k, v in FREE2.items() if k != "=n_in"}),
             "b": ("feedthrough2", "1 ms", {k: v for k, v in FREE2.items() if k != "=u"})}  # fmt: skip
    wires = ["a.n_out -> b.u", "b.y -> a.n_in (round)"]
    run = run_of(tmp_path, native, parts, wires, stop="5 ms", algorithm=algorithm, interpreted=interpreted)
    assert set(Signals(run)["a.n_out"].values.tolist()) == {0} and set(Signals(run)["b.y"].values.tolist()) == {0.0}


def test_an_isolated_fmu_gets_the_same(native: Path, tmp_path: Path) -> None:
    wires = ["a.n_out -> b.u", "a.on_out -> b.n_in"]
    parts = {
        "a": ("feedthrough2", "1 ms", FREE2),
        "b": ("feedthrough2", "1 ms", {"=mode_in": 1, "=on_in": True, "=s_in": ""}),
    }
    run = run_of(tmp_path, native, parts, wires, stop="3 ms", of={"b": {"isolation": "process"}})
    assert Signals(run)["b.y"].values.tolist() == [-7.0] * 4 and Signals(run)["b.n_out"].values.tolist() == [1] * 4


def test_round_goes_with_a_transfer_and_through_an_ssp(native: Path, tmp_path: Path) -> None:
    free = {k: v for k, v in FREE3.items() if k != "=Float32_in"}
    parts = {"a": ("feedthrough3", "2 ms", FREE3), "b": ("feedthrough3", "1 ms", free)}
    system = read_system(tmp_path, native, parts, ["a.Float64_out -> b.Float32_in (linear, round)"])
    (c,) = system.connections
    assert (c.transfer, c.rounded) == ("linear", True)
    whole = read_system(tmp_path, native, {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "1 ms", {
        k: v for k, v in FREE2.items() if k != "=n_in"})}, ["a.y -> b.n_in (round)"])  # fmt: skip
    again = load_system(str(write_ssp(whole, tmp_path / "whole.ssp")), native)
    assert [(c.label, c.rounded) for c in again.connections] == [("a.y -> b.n_in", True)]


@pytest.mark.parametrize(
    ("wire", "kind"), [("a.n_out -> b.u (mean)", "Integer"), ("a.y -> b.n_in (mean, round)", "Integer")]
)
def test_what_is_no_floating_point_signal_at_an_end_is_held(wire: str, kind: str, native: Path, tmp_path: Path) -> None:
    target = wire.split("-> b.")[1].split()[0]
    parts = {"a": ("feedthrough2", "1 ms", FREE2),
             "b": ("feedthrough2", "2 ms", {k: v for k, v in FREE2.items() if k[1:] != target})}  # fmt: skip
    with pytest.raises(InputError, match=f"a {kind} is held, 'mean' has no meaning for it; take 'hold'"):
        plan_of(tmp_path, native, parts, [wire])


def test_unknown_words_behind_a_connection_name_the_known(native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "1 ms", FREE2)}
    with pytest.raises(InputError, match="unknown transfer 'rouns'; did you mean 'round'"):
        plan_of(tmp_path, native, parts, ["a.n_out -> b.n_in (rouns)"])


MAPPING = """[variables]
u = "Float32_in"
n_in = "Float64_in"
on_in = "Int8_in"
mode_in = ""
s_in = ""
y = "Float32_out"
x = ""
n_out = "Int16_out"
mode_out = ""
on_out = "Boolean_out"
s_out = ""
bad_at = ""
fault = ""
"""


def test_somebody_elses_fmu_may_have_types_that_hold_ours(native: Path, tmp_path: Path) -> None:
    rest = {"=u": 0.5, "=mode_in": 1, "=s_in": ""}
    wires = ["a.n_out -> b.n_in", "a.on_out -> b.on_in", "b.n_out -> c.n_in"]
    free = {k: v for k, v in FREE2.items() if k != "=n_in"}
    parts = {"a": ("feedthrough2", "1 ms", FREE2 | {"=n_in": 7}), "b": ("feedthrough2", "1 ms", rest),
             "c": ("feedthrough2", "1 ms", free)}  # fmt: skip
    system = read_system(tmp_path, native, parts, wires, stop="4 ms")
    (tmp_path / "map.toml").write_text(MAPPING, encoding="utf-8")
    mapping, theirs = load_mapping(tmp_path / "map.toml"), Fmu.open(native / "feedthrough3.fmu")
    run = simulate(make_plan(replace_component(system, "b", theirs, mapping)))
    signals = Signals(run)
    assert not run.failure
    assert signals["b.n_in"].values.tolist()[-1] == 7.0 and signals["b.on_in"].values.tolist()[-1] == 1
    (tmp_path / "map.toml").write_text(MAPPING.replace("Float64_in", "Int16_in"), encoding="utf-8")
    with pytest.raises(InputError, match="theirs is of type Int16, Integer is needed"):
        replace_component(system, "b", theirs, load_mapping(tmp_path / "map.toml"))


def test_a_transformation_of_what_is_no_floating_point_signal_is_an_error(native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "1 ms", {"=u": 0.0})}
    system = read_system(tmp_path, native, parts)
    for input_, words in (("n_in", "a Integer is not transformed, by 2 x"), ("u", "")):
        link = Link("a", "n_out", "b", input_, "", 2.0, 1.0, "(here)")
        if words:
            with pytest.raises(InputError, match=words):
                connections_of(TomlFile(tmp_path / "case.toml"), dict(system.components), link)
        else:
            (c,) = connections_of(TomlFile(tmp_path / "case.toml"), dict(system.components), link)
            assert (c.gain, c.offset) == (2.0, 1.0)
