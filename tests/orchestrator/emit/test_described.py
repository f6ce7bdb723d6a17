"""The descriptions of exported FMUs: names by their rules, numbers and characters as XML has them."""

from __future__ import annotations

import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from fmpy import read_model_description
from helpers import edited, read_system
from native_build import needs_gcc
from rovbrush.orchestrator.emit import archive
from rovbrush.orchestrator.emit.description2 import STRUCTURED
from rovbrush.orchestrator.emit.export import export_fmu

RULED = ("a.b", "a.b[1,2].c", "a.'b c'", r"a.'it\'s'", "der(a.b)", "der(a.b[2],3)", "_a._1", "a.'!#$%&()*+,-./'",
         "a.':;<>=?@[]^{}|~ '")  # fmt: skip
OTHERS = (
    "a.der(b)",
    "a.1",
    "a.b c",
    "a.h\u00fcll",
    "a.'h\u00fcll'",
    "a.''",
    "a.b[0",
    "der(a.b",
    "a..b",
    "a.'\"'",
    "a.b[x]",
)


@pytest.mark.parametrize("name", RULED)
def test_names_by_the_rules_are_structured(name: str) -> None:
    assert STRUCTURED.fullmatch(name)


@pytest.mark.parametrize("name", OTHERS)
def test_other_names_are_flat(name: str) -> None:
    assert not STRUCTURED.fullmatch(name)


@needs_gcc
@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_what_xml_cannot_hold_does_not_spoil_a_description(
    fmi: str, carried: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A derivative in a component, control characters, quotes and brackets, and a start value that is infinite."""
    monkeypatch.setattr(archive, "for_windows", lambda: None)
    with zipfile.ZipFile(carried / "mass.fmu") as opened:
        xml = opened.read("modelDescription.xml").decode()
    xml = xml.replace('name="v"', 'name="der(x)"')
    edited(carried / "mass.fmu", tmp_path / "mass.fmu", {"modelDescription.xml": xml.encode()})
    system = read_system(tmp_path, tmp_path, {"a": ("mass", "1 ms")}, [], stop="5 ms")
    component = system.components["a"]
    given = replace(component, parameters={**component.parameters, "x0": float("inf")})
    system = replace(system.with_component(given), description='bell \x07, "<&>", end')
    monkeypatch.setattr("rovbrush.orchestrator.emit.prepared.solutions", lambda _plan: {})
    export_fmu(system, tmp_path / "whole.fmu", fmi)
    found = read_model_description(str(tmp_path / "whole.fmu"))  # valid by the schema of the standard
    assert found.description == 'bell \ufffd, "<&>", end'
    assert found.variableNamingConvention == "flat"
    starts = {v.name: v.start for v in found.modelVariables}
    assert starts["a.x0"] == "INF"
