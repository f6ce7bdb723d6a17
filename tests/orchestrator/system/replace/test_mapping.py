"""The mapping file: what it says, and every way to write it wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.replace.mapping import VariableMapping, load_mapping

GOOD = """\
[variables]
V_in = "supply.voltage"
u = { name = "cmd", sign = -1, unit = "N.m" }
"u[2]" = "second"
W_gear = ""
[inputs]
temperature = 293.15
[parameters]
k = [1.0, 2.0]
"""
OURS = ["V_in", "u[1]", "u[2]", "W_gear", "omega"]
THEIRS = ["supply.voltage", "cmd[1]", "cmd[2]", "second", "temperature", "k[1]", "k[2]", "omega"]


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "map.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_every_entry_names_their_variable(tmp_path: Path) -> None:
    mapping = load_mapping(written(tmp_path, GOOD))
    mapping.check(OURS, THEIRS, "motor", "their.fmu")
    assert mapping.entry("V_in").name == "supply.voltage"
    assert (mapping.entry("u[1]").name, mapping.entry("u[1]").sign, mapping.entry("u[1]").unit) == (
        "cmd[1]",
        -1.0,
        "N.m",
    )
    assert (mapping.entry("u[2]").name, mapping.entry("u[2]").sign) == ("second", 1.0)
    assert mapping.entry("W_gear").absent and mapping.states("W_gear")
    assert mapping.entry("omega").name == "omega" and not mapping.states("omega")
    assert mapping.inputs == {"temperature": 293.15} and mapping.parameters == {"k[1]": 1.0, "k[2]": 2.0}


def test_without_a_file_names_are_the_same() -> None:
    assert VariableMapping().entry("u[3]").name == "u[3]"


WRONG = {
    "no TOML": ("[variables", ["map.toml", "not valid TOML"]),
    "an unknown table": ("[variable]\nV_in = 'v'", ["unknown key 'variable'", "did you mean 'variables'", "line 1"]),
    "an unknown key": (
        "[variables]\nV_in = { nam = 'v' }",
        ["V_in: unknown key 'nam'", "did you mean 'name'", "line 2"],
    ),
    "a number for a name": ("[variables]\nV_in = 3", ["V_in = 3", "write the name", "line 2"]),
    "a number in the name": ("[variables]\nV_in = { name = 3 }", ["V_in: name and unit must be text", "line 2"]),
    "another sign": ("[variables]\nV_in = { sign = 2 }", ["V_in: sign = 2 must be 1 or -1", "line 2"]),
    "a sign that is a switch": ("[variables]\nV_in = { sign = true }", ["V_in: sign = True must be 1 or -1"]),
    "an unknown unit": (
        "[variables]\nV_in = { unit = 'furlongg' }",
        ["V_in: unit 'furlongg' is not understood", "line 2"],
    ),
    "one target twice": ("[variables]\nV_in = 'v'\nomega = 'v'", ["V_in and omega both name 'v'", "line 3"]),
    "mapped and given": (
        "[variables]\nV_in = 'v'\n[inputs]\nv = 1.0",
        ["'v' is mapped to V_in", "remove one", "line 4"],
    ),
    "a date for a value": ("[inputs]\nt = 2020-01-01", ["[inputs]: t", "is no number", "line 2"]),
    "a table that is none": ("variables = 3", ["variables must be a table"]),
}


@pytest.mark.parametrize(("text", "words"), WRONG.values(), ids=WRONG.keys())
def test_a_wrong_file_is_refused_with_its_line(text: str, words: list[str], tmp_path: Path) -> None:
    with pytest.raises(InputError) as refused:
        load_mapping(written(tmp_path, text))
    assert all(word in str(refused.value) for word in words), str(refused.value)


UNKNOWN = {
    "ours": ("[variables]\nV_inn = 'second'", ["motor has no variable 'V_inn'", "did you mean 'V_in'", "line 2"]),
    "theirs": (
        "[variables]\nV_in = 'secnd'",
        ["their.fmu has no variable 'secnd'", "did you mean 'second'", 'V_in = ""', "line 2"],
    ),
    "their input": (
        "[inputs]\ntemperatur = 3.0",
        ["[inputs]: their.fmu has no variable 'temperatur'", "did you mean 'temperature'"],
    ),
}


@pytest.mark.parametrize(("text", "words"), UNKNOWN.values(), ids=UNKNOWN.keys())
def test_an_unknown_name_gets_the_nearest(text: str, words: list[str], tmp_path: Path) -> None:
    mapping = load_mapping(written(tmp_path, text))
    with pytest.raises(InputError) as refused:
        mapping.check(OURS, THEIRS, "motor", "their.fmu")
    assert all(word in str(refused.value) for word in words), str(refused.value)


def test_a_file_that_is_not_there_is_named() -> None:
    with pytest.raises(InputError, match=r"nowhere\.toml cannot be read"):
        load_mapping(Path("nowhere.toml"))
