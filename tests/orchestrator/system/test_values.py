"""Values of parameters: where they come from, which wins, what is refused, and as what they reach the FMU."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from fmpy.model_description import ModelVariable
from good_system import GOOD, read
from helpers import last, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.values import start_as_toml


@pytest.mark.parametrize(
    ("values", "hints"),
    [
        ({"gg.k": 1.0}, ["--set: no component 'gg' in 'gg.k'; did you mean 'g'?"]),
        ({"g.kk": 1.0}, ["--set: g.kk is unknown; did you mean 'k'?"]),
        ({"g": 1.0}, ["--set", "g"]),
        ({"g.": 1.0}, ["--set", "unknown"]),
        ({"g.k": "3 apples"}, ["g.k = 3 apples: unit 'apples' is not understood"]),
        ({"g.k": -2e6}, ["-2e+06", "out of range"]),
        ({"g.u": 1.0}, ["--set: g.u is driven by the connection source.y -> g.u"]),
        ({"g.y": 1.0}, ["is of causality output and cannot be set"]),
        ({"g.weights[3]": 1.0}, ["g.weights[3] is unknown", "weights"]),
    ],
)
def test_wrong_values_given_afterwards_are_refused(
    values: dict[str, object], hints: list[str], tmp_path: Path, fmus: Path
) -> None:
    system = read(tmp_path, fmus, GOOD)
    with pytest.raises(InputError) as error:
        system.with_values(values, "--set")
    for hint in hints:
        assert hint in str(error.value)


def test_values_given_afterwards_win_over_the_file_and_the_file_over_its_parameter_file(
    tmp_path: Path, fmus: Path
) -> None:
    (tmp_path / "set.toml").write_text("[g]\nk = 9.0\noffset = 8.0\n[source]\nc0 = 7.0\n[unused]\nx = 1\n")
    system = read(tmp_path, fmus, 'parameters = "set.toml"\n' + GOOD).with_values({"g.offset": "6"}, "--set")
    assert (system.components["g"].parameters["k"], system.components["g"].parameters["offset"]) == (2.0, 6.0)
    assert system.components["source"].parameters["c0"] == 1.0


def test_a_wrong_value_in_the_parameter_file_names_that_file(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "set.toml").write_text("[g]\noffset = 8.0e9\n")
    with pytest.raises(InputError, match=r"set\.toml.*g\.offset = 8e\+09 N is out of range"):
        read(tmp_path, fmus, 'parameters = "set.toml"\n' + GOOD)


def test_a_misspelt_component_in_the_parameter_file_is_an_error(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "set.toml").write_text("[sourse]\nc0 = 7.0\n")
    with pytest.raises(InputError, match=r"no component 'sourse'; did you mean 'source'\? \(set\.toml, line 1\)"):
        read(tmp_path, fmus, 'parameters = "set.toml"\n' + GOOD)


def test_parameters_reach_the_fmu_in_their_own_type(tmp_path: Path, fmus: Path) -> None:
    parts = {
        "p": ("plain", "10 ms", {"label": "5 % ü", "mode": 0, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0}),
        "g": ("gain", "10 ms", {"count": 7, "on": False, "=u": 1.0, "offset": 0.5}),
    }
    assert last(run_of(tmp_path, fmus, parts), "g.y") == 1.5


MENDS = {"Real": "0.0", "Integer": "0", "Boolean": "false", "String": '""', "Enumeration": "0"}


@pytest.mark.parametrize("kind", MENDS)
@pytest.mark.parametrize("start", [None, "1"])
def test_the_mend_for_a_missing_value_is_toml_of_its_type(kind: str, start: str | None) -> None:
    variable = ModelVariable(kind, 1, type=kind, start=start)
    text = start_as_toml(variable)
    value = tomllib.loads(f"x = {text}")["x"]
    stated = {"Boolean": "true", "String": '"1"', "Real": "1.0"}.get(kind, "1")
    assert text == (MENDS[kind] if start is None else stated)
    assert isinstance(value, {"Boolean": bool, "String": str}.get(kind, float | int))
