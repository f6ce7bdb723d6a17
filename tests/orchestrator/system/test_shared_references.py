"""Inputs and parameters of FMI 2.0 that share a value reference are one variable: neither undoes the other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from helpers import edited, last, read_system, run_of
from native_build import FREE2, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.contents import contents_of
from rovbrush.orchestrator.fmu.fmu import Fmu

pytestmark = needs_gcc

SECOND = (
    '<ScalarVariable name="twin" valueReference="0" causality="input" variability="continuous"><Real start="0"/>'
    "</ScalarVariable>\n</ModelVariables>"
)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("shared")
    made = built(folder) / "feedthrough2.fmu"
    edited(made, folder / "named.fmu", {}, {"</ModelVariables>": SECOND}).replace(made)
    return folder


def others(**values: Any) -> dict[str, Any]:
    return {key: value for key, value in FREE2.items() if key != "=u"} | values


@pytest.mark.parametrize("name", ["u", "twin"])
def test_a_value_by_either_name_holds(name: str, fmus: Path, tmp_path: Path) -> None:
    run = run_of(tmp_path, fmus, {"a": ("feedthrough2", "1 ms", others(**{f"={name}": 2.5}))}, stop="5 ms")
    assert last(run, "a.y") == 2.5


@pytest.mark.parametrize("name", ["u", "twin"])
def test_a_connection_to_either_name_holds(name: str, fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms", others(**{"=u": 2.5})), "b": ("feedthrough2", "1 ms", others())}
    run = run_of(tmp_path, fmus, parts, [f"a.y -> b.{name}"], stop="5 ms")
    assert last(run, "b.y") == 2.5


def test_two_values_and_two_drivers_are_errors(fmus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a\.u has a value already; a\.twin is the same variable"):
        read_system(tmp_path, fmus, {"a": ("feedthrough2", "1 ms", others(**{"=u": 1.0, "=twin": 2.0}))})
    parts = {"a": ("feedthrough2", "1 ms"), "b": ("feedthrough2", "1 ms")}
    with pytest.raises(InputError, match=r"input b\.u is driven twice"):
        read_system(tmp_path, fmus, parts, ["a.y -> b.u", "a.y -> b.twin"])


def test_contents_and_feedthrough_know_one_variable(fmus: Path) -> None:
    fmu = Fmu.open(fmus / "feedthrough2.fmu")
    assert fmu.feedthrough()["y"] == {"u"} and "twin" not in fmu.names("input")
    assert {v["name"]: v.get("alias") for v in contents_of(fmu)["variables"]}["twin"] == "u"
