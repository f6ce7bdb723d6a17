"""What crosses a boundary is recorded in its own type: whole numbers to the last digit, truth values, items, texts."""

from __future__ import annotations

import csv
from dataclasses import replace as changed
from pathlib import Path
from typing import Any

import pytest
from helpers import edited, read_system, rovbrush
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.exchange.recordings.write import write_boundary
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
TEXT = 'a, "b"\nc;é'
FREE: dict[str, Any] = {"feedthrough2": {**FREE2, "=s_in": TEXT}, "feedthrough3": {**FREE3, "=String_in": TEXT}}
WIRES = {"feedthrough2": WIRES2, "feedthrough3": WIRES3}


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def recorded(name: str, native: Path, folder: Path) -> Path:
    """Recordings of `a`, whose inputs are constant, and of `b`, which `a` drives."""
    own = {"M": [1, 2, 3, 4]} if name == "feedthrough3" else {}  # its library does not start with what it states
    parts = {"a": (name, "1 ms", {**FREE[name], **own}), "b": (name, "1 ms", own)}
    system = read_system(folder, native, parts, WIRES[name], stop="5 ms")
    system = changed(
        system, record=("*",), components={n: changed(c, direct="off") for n, c in system.components.items()}
    )
    run = simulate(planned(system))
    assert not run.failure, run.failure
    for component in parts:
        write_boundary(run, component, folder)
    return folder


def table(path: Path) -> dict[str, list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    return dict(zip(head, map(list, zip(*rows, strict=True)), strict=True))


@pytest.mark.parametrize("component", ["a", "b"])
@pytest.mark.parametrize("name", FREE)
def test_values_are_recorded_as_what_they_are(name: str, component: str, native: Path, tmp_path: Path) -> None:
    recorded(name, native, tmp_path)
    columns = table(tmp_path / f"{component}_in.csv")
    expected = {key[1:]: value for key, value in FREE[name].items()}
    for variable, value in expected.items():
        if isinstance(value, list) or variable in ("u", "Float32_in"):
            continue
        cell = str(int(value)) if isinstance(value, bool) else str(value)
        assert columns[variable][-1] == cell, variable
    if name == "feedthrough3":
        assert [columns[f"t_in[{k}]"][-1] for k in (1, 2)] == ["a", "b"]
        assert [columns[f"a_in[{k}]"][-1] for k in (1, 2)] == ["0.5", "1.0"]


@pytest.mark.parametrize("component", ["a", "b"])
@pytest.mark.parametrize("name", FREE)
def test_the_same_fmu_repeats_every_value_of_every_type(
    name: str, component: str, native: Path, tmp_path: Path
) -> None:
    recorded(name, native, tmp_path)
    verdicts = replay(native / f"{name}.fmu", tmp_path, component, rtol=0.0).require_within()
    assert {v.text for v in verdicts} == {"equal"}
    types = {"s_out", "on_out", "mode_out"} if name == "feedthrough2" else {"t_out[2]", "Boolean_out", "UInt64_out"}
    assert types <= {v.output for v in verdicts}


@pytest.mark.parametrize(
    ("output", "old", "new"),
    [
        ("String_out", '"a, ""b""', '"a, ""c""'), ("Int64_out", "-9007199254740993", "-9007199254740992"),
        ("Enumeration_out", ",9007199254740993,", ",1,"),
    ],
)  # fmt: skip
def test_another_value_of_any_type_is_outside(output: str, old: str, new: str, native: Path, tmp_path: Path) -> None:
    recorded("feedthrough3", native, tmp_path)
    path = tmp_path / "a_ref.csv"
    head, rows = path.read_text(encoding="utf-8").split("\n", 1)
    assert old in rows
    path.write_text(f"{head}\n{rows.replace(old, new)}", encoding="utf-8")
    with pytest.raises(RunError, match=f"outside the tolerance: {output}"):
        replay(native / "feedthrough3.fmu", tmp_path, "a", rtol=0.0).require_within()


WRONG = {
    "no whole number": ("n_in", "-7", "-7.5", r"a_in\.csv, line 2: n_in = -7\.5 is not a whole number"),
    "no item": ("mode_in", "2", "onn", r"a_in\.csv, line 2: mode_in = onn .*no item of the enumeration.*mean 'on'"),
    "neither true nor false": ("on_in", "1", "yes", r"a_in\.csv, line 2: on_in = yes is not true or false"),
    "too large": ("n_in", "-7", "3000000000", r"a_in\.csv, line 2: n_in = 3000000000 is out of range: -2147483648 to"),
}


@pytest.mark.parametrize(("column", "old", "new", "message"), WRONG.values(), ids=WRONG)
def test_a_cell_that_its_variable_cannot_hold_is_one_clear_error(
    column: str, old: str, new: str, message: str, native: Path, tmp_path: Path
) -> None:
    recorded("feedthrough2", native, tmp_path)
    columns = table(tmp_path / "a_in.csv")
    assert columns[column][0] == old
    columns[column][0] = new
    with (tmp_path / "a_in.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([list(columns), *zip(*columns.values(), strict=True)])
    with pytest.raises(InputError, match=message):
        replay(native / "feedthrough2.fmu", tmp_path, "a")


def test_true_false_and_items_by_name_are_taken_too(native: Path, tmp_path: Path) -> None:
    recorded("feedthrough2", native, tmp_path)
    path = tmp_path / "a_in.csv"
    columns = table(path)
    columns |= {"on_in": ["true"] * len(columns["time"]), "mode_in": ["on"] * len(columns["time"])}
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([list(columns), *zip(*columns.values(), strict=True)])
    assert {v.text for v in replay(native / "feedthrough2.fmu", tmp_path, "a").require_within()} == {"equal"}


def test_the_command_records_and_replays_an_fmu_alone(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    fmu = native / "feedthrough3.fmu"
    given = (
        "--set",
        "M=[1,2,3,4]",
        "--set",
        "Int64_in=-9007199254740993",
        "--set",
        f"String_in={TEXT}",
        "--period",
        "1 ms",
        "--stop",
        "5 ms",
    )
    out = ("--record-boundary", "feedthrough3", "--out", tmp_path)
    assert rovbrush(monkeypatch, "run", fmu, *given, *out) == 0
    assert rovbrush(monkeypatch, "replay", fmu, tmp_path, "--rtol", "0") == 0
    assert "outside" not in capfd.readouterr().out


def test_a_component_without_inputs_and_outputs_says_so(native: Path, tmp_path: Path) -> None:
    xml = {'causality="output"': 'causality="local"', 'causality="input"': 'causality="local"'}
    fmu = edited(
        native / "feedthrough2.fmu", tmp_path / "silent.fmu", {}, {**xml, "<Outputs>": "<!--", "</Outputs>": "-->"}
    )
    system = read_system(tmp_path, tmp_path, {"s": (fmu.stem, "1 ms")}, stop="5 ms")
    run = simulate(planned(system))
    with pytest.raises(RunError, match=r"--record-boundary s: silent\.fmu has neither inputs nor outputs"):
        write_boundary(changed(run, plan=changed(run.plan, groups=())), "s", tmp_path)
