"""Every type of FMI 2.0 and 3.0 goes from an output through the loop into an input to the last bit, and to disk."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import plan_of, read_system, run_of
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.texts import Texts
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.files.writing import write_results
from rovbrush.orchestrator.results.signals import Signal, Signals
from rovbrush.orchestrator.results.summary.figures_of_merit import figure_of_merit
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.mark.parametrize("interpreted", [False, True])
def test_every_type_of_fmi2_arrives_as_it_was_sent(interpreted: bool, native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "2 ms")}
    signals = Signals(run_of(tmp_path, native, parts, WIRES2, stop="6 ms", interpreted=interpreted))
    for name, dtype, value in (
        ("y", "f8", 1.5), ("n_out", "i4", -7), ("mode_out", "i4", 2), ("on_out", "?", True),
        ("s_out", "O", 'hüll, "on"'),
    ):  # fmt: skip
        found = signals[f"b.{name}"].values
        assert found.dtype == np.dtype(dtype) and found.tolist()[-1] == value, name


@pytest.mark.parametrize("interpreted", [False, True])
def test_every_type_of_fmi3_arrives_as_it_was_sent(interpreted: bool, native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "1 ms")}
    signals = Signals(run_of(tmp_path, native, parts, WIRES3, stop="3 ms", interpreted=interpreted))
    for key, value in FREE3.items():
        name = key[1:-3] + "_out"
        if isinstance(value, list):
            found = [signals[f"b.{name}[{k + 1}]"].values.tolist()[-1] for k in range(len(value))]
            assert found == value, name
        else:
            expected = float(np.float32(value)) if name == "Float32_out" else value
            assert signals[f"b.{name}"].values.tolist()[-1] == expected, name
    kinds = {n: signals[f"b.{n}_out"].values.dtype for n in ("Float32", "Int8", "UInt16", "Int64", "UInt64", "Boolean")}
    assert {n: str(d) for n, d in kinds.items()} == {
        "Float32": "float32", "Int8": "int8", "UInt16": "uint16", "Int64": "int64", "UInt64": "uint64",
        "Boolean": "bool",
    }  # fmt: skip


def test_fmi2_and_fmi3_components_exchange_what_fits(native: Path, tmp_path: Path) -> None:
    wires = [
        "a.y -> b.Float32_in (round)", "b.Float32_out -> c.u", "a.n_out -> b.Int64_in", "a.on_out -> b.Boolean_in",
        "b.Boolean_out -> c.on_in", "b.Int16_out -> c.n_in", "a.s_out -> b.String_in", "b.String_out -> c.s_in",
    ]  # fmt: skip
    taken = {wire.split("-> b.")[1].split()[0] for wire in wires if "-> b." in wire}
    rest = {k: v for k, v in FREE3.items() if k[1:] not in taken}
    parts = {
        "a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough3", "1 ms", rest),
        "c": ("feedthrough2", "1 ms", {"=mode_in": 1}),
    }  # fmt: skip
    signals = Signals(run_of(tmp_path, native, parts, wires, stop="4 ms"))
    found = [signals[f"c.{name}"].values.tolist()[-1] for name in ("y", "n_out", "on_out", "s_out")]
    assert found == [1.5, -32768, True, 'hüll, "on"']
    assert signals["b.Int64_out"].values.tolist()[-1] == -7


def test_elements_of_an_array_without_a_driver_keep_their_start_values(native: Path, tmp_path: Path) -> None:
    rest = {k: v for k, v in FREE3.items() if k != "=a_in"} | {f"='a_in[{k}]'": 10.0 * k for k in (1, 2, 3, 5, 6, 7, 8)}
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough3", "1 ms", rest)}
    signals = Signals(run_of(tmp_path, native, parts, ["a.y -> b.a_in[4]"], stop="3 ms"))
    found = [signals[f"b.a_out[{k}]"].values[-1] for k in range(1, 9)]
    assert found == [10.0, 20.0, 30.0, 1.5, 50.0, 60.0, 70.0, 80.0]


def test_a_matrix_parameter_is_set_element_by_element(native: Path, tmp_path: Path) -> None:
    system = plan_of(tmp_path, native, {"b": ("feedthrough3", "1 ms", {**FREE3, "M": [7, 0, 0, 2]})}, stop="2 ms")
    assert Signals(simulate(system))["b.trace"].values[-1] == 9.0


@pytest.mark.parametrize(
    ("wire", "words"),
    [
        (
            "a.y -> b.n_in",
            "a.y is of type Real, b.n_in of type Integer: a Real can lie between whole numbers; "
            'write "a.y -> b.n_in (round)" for the nearest it holds',
        ),
        ("a.n_out -> b.on_in", "a Boolean is true or false only; put an FMU between that compares the value"),
        ("a.n_out -> b.on_in (round)", "a Boolean is true or false only"),
        ("a.y -> c.Float32_in", "a Float32 does not hold every Real"),
        ("c.Int64_out -> b.u", 'a Real does not hold every Int64; write "c.Int64_out -> b.u (round)"'),
        ("a.s_out -> b.u", "of type String, b.u of type Real"),
        ("a.n_out -> c.Int16_in", "Int16 holds -32768 to 32767 only"),
        ("a.n_out -> c.UInt64_in", "UInt64 holds 0 to 18446744073709551615 only"),
        ("a.mode_out -> c.Enumeration_in", "the items of the two enumerations differ"),
        ("c.blob_out -> c.String_in", "there is no conversion between them"),
        ("a.n_out -> b.n_in (linear)", "a Integer is held, 'linear' has no meaning"),
    ],
)
def test_types_that_do_not_match_are_refused_by_name(wire: str, words: str, native: Path, tmp_path: Path) -> None:
    target = wire.split("-> ")[1].split()[0]
    parts = {
        name: (fmu, "1 ms", {k: v for k, v in free.items() if f"{name}.{k[1:]}" != target})
        for name, fmu, free in (
            ("a", "feedthrough2", FREE2),
            ("b", "feedthrough2", FREE2),
            ("c", "feedthrough3", FREE3),
        )
    }
    with pytest.raises(InputError) as error:
        plan_of(tmp_path, native, parts, [wire])
    assert words in str(error.value)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"=Int8_in": 128}, "b.Int8_in = 128 is out of range: -128 to 127 are allowed"),
        ({"=UInt64_in": -1}, "is out of range: 0 to 18446744073709551615"),
        ({"=Int32_in": 1.5}, "is not a whole number"),
        ({"=Boolean_in": "perhaps"}, "is not true or false"),
    ],
)
def test_start_values_must_fit_their_type(values: dict[str, Any], words: str, native: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        plan_of(tmp_path, native, {"b": ("feedthrough3", "1 ms", {**FREE3, **values})})
    assert words in str(error.value)


def test_held_types_are_never_averaged_and_the_plan_says_so(native: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough2", "5 ms")}
    text = explain(plan_of(tmp_path, native, parts, WIRES2, stop="10 ms"))
    assert "a Integer is held" in text and "a Boolean is held" in text and "a String is held" in text
    assert "move        b.n_in = a.n_out" in text
    assert "1 Real, 1 Integer, 1 Enumeration, 1 Boolean, 1 String" in text


def test_results_on_disk_keep_types_and_texts(native: Path, tmp_path: Path) -> None:
    run = run_of(tmp_path, native, {"a": ("feedthrough2", "1 ms", FREE2), "b": ("feedthrough3", "1 ms", FREE3)})
    write_results(run, tmp_path, {})
    with xarray.open_dataset(tmp_path / "result.nc", group="every_1_ms") as data:
        assert data["a.s_out"].values[-1] == 'hüll, "on"'
        assert data["a.on_out"].dtype == bool and bool(data["a.on_out"][-1])
        assert data["b.Int64_out"].dtype == np.int64 and int(data["b.Int64_out"][-1]) == -(2**53) - 1
        assert "units" not in data["a.n_out"].attrs
    header, last = [(tmp_path / "result.csv").read_text(encoding="utf-8").splitlines()[k] for k in (0, -1)]
    assert "a.n_out" in header.split(",") and '"hüll, ""on"""' in last and "true" in last.split(",")


def test_texts_have_one_number_each_and_a_full_pool_is_reported() -> None:
    texts = Texts(count=3, size=16)
    assert [texts.number(t) for t in ("", "one", "two", "one", "three", "")] == [0, 1, 2, 1, -1, 0]
    assert texts.text(2) == "two"
    assert Texts(count=8, size=6).number("longer") == -1


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "u8", "?"])
def test_figures_of_merit_of_whole_numbers_do_not_overflow(dtype: str) -> None:
    ends = np.iinfo(dtype) if dtype != "?" else None
    values = np.array([ends.min, ends.max, ends.min] if ends else [False, True, False], dtype=dtype)
    signal = Signal("a.n", "", "", np.array([0.0, 1.0, 2.0]), values)
    largest = max(abs(int(v)) for v in values)
    assert abs(figure_of_merit("peak", [signal], 0.0, 2.0)) == largest
    assert 0.0 < figure_of_merit("rms", [signal], 0.0, 2.0) <= float(largest)
    assert figure_of_merit("max", [signal], 0.0, 2.0) == int(values[1])


def test_a_figure_of_a_text_is_refused_before_the_run(native: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, native, {"a": ("feedthrough2", "1 ms", FREE2)}, stop="5 ms")
    drawn = {"file": "f.png", "title": "", "signals": ["a.s_out"]}
    with pytest.raises(InputError, match=r"figure f\.png: 'a\.s_out' is a text; name a number"):
        planned(replace(system, reporting={**system.reporting, "figures": [drawn]}))
