# ruff: noqa: E501  one row per case
"""Somebody else's FMU in the place of a component: what fits, and every way not to fit with what the user is told."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest
from helpers import edited, read_system, system_text
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.system.assemble import apply_changes
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.request import changes_of

PARTS = {
    "w": ("wave", "10 ms", {"c0": 0.3, "a": 2.0, "w": 9.0}),
    "g": ("gain", "10 ms", {"k": 2.0, "count": 5}),
    "x": ("integrator", "10 ms"),
}
WIRES = ["w.y -> g.u", "g.y -> x.u"]
FIXED = {'canHandleVariableCommunicationStepSize="true"': 'canHandleVariableCommunicationStepSize="false"'}


def planned(
    tmp_path: Path, fmus: Path, xml: dict[str, str], mapping: str = "", period: str = "", **files: bytes | None
) -> Plan:
    """A wave, a gain and an integrator, the gain replaced by one whose model description is edited."""
    read_system(tmp_path, fmus, PARTS, WIRES)
    edited(fmus / "gain.fmu", tmp_path / "their.fmu", dict(files), xml)
    (tmp_path / "map.toml").write_text(mapping, encoding="utf-8")
    changes = changes_of(
        [f"g={tmp_path / 'their.fmu'}"],
        [f"g={tmp_path / 'map.toml'}"] if mapping else [],
        [f"g={period}"] if period else [],
    )
    return make_plan(apply_changes(load_system(str(tmp_path / "case.toml"), fmus), changes))


RENAMED = {'name="u"': 'name="force"', 'name="y"': 'name="thrust"'}
FMI1 = {'fmiVersion="2.0"': 'fmiVersion="1.0"'}
BAD = {
    # what, changes of the description, mapping file, words of the message
    "an input is missing": (RENAMED, "", ["their.fmu has an input 'force' that nothing drives", "map one of ours to it (u = \"force\")"]),
    "an input that is driven is missing": ({'name="u"': 'name="force"'}, "[inputs]\nforce = 0.0", ["their.fmu has no input 'u'", "which w.y drives", "there are force", 'u = ""']),
    "an output that drives is missing": ({'name="y"': 'name="thrust"'}, "", ["their.fmu has no output 'y'", "drives x.u", 'y = "their name"']),
    "an output that drives is said to be missing": ({'name="y"': 'name="thrust"'}, "[variables]\ny = ''", ["their.fmu has no output 'y'", "drives x.u"]),
    "a parameter that is set is missing": ({'name="k"': 'name="factor"'}, "", ["their.fmu has no parameter 'k'", "the system sets to 2.0", 'k = ""']),
    "another name than the mapping says": (RENAMED, "[variables]\nu = 'forse'\ny = 'thrust'", ["their.fmu has no variable 'forse'", "did you mean 'force'", "map.toml, line 2"]),
    "an incompatible unit": ({'causality="input" variability="continuous">\n\t\t\t<Real unit="1"': 'causality="input" variability="continuous">\n\t\t\t<Real unit="N"'}, "", ["g.u as 'u' of their.fmu", "the units do not fit", "1 cannot become N"]),
    "the mapping overrules a unit": ({}, "[variables]\nu = { unit = 'N' }", ["the mapping says that it is in N, their FMU that it is in 1", "map.toml, line 2"]),
    "an output where an input is needed": ({}, "[variables]\nu = 'held'\nheld = ''\n[inputs]\n", ["g.u as 'held' of their.fmu", "causality output, input is needed", "map.toml, line 2"]),
    "an input where an output is needed": ({}, "[variables]\ny = 'u'\nu = ''", ["g.y as 'u' of their.fmu", "causality input, output is needed"]),
    "an output where a parameter is needed": ({}, "[variables]\nk = 'held'\nheld = ''", ["g.k as 'held' of their.fmu", "causality output, parameter is needed"]),
    "another type": ({'causality="input" variability="continuous">\n\t\t\t<Real unit="1" start="0.0"/>': 'causality="input" variability="discrete">\n\t\t\t<Integer start="0"/>'}, "", ["g.u as 'u' of their.fmu", "type Integer, Real is needed"]),
    "a sign of a whole number": ({}, "[variables]\ncount = { sign = -1 }", ["a Integer has no sign"]),
    "a value out of their range": ({'min="1" max="9"': 'min="1" max="4"'}, "", ["--replace g=their.fmu: g.count = 5", "1 to 4"]),
    "a parameter of theirs that is none": ({}, "[variables]\nheld = ''\n[parameters]\nheld = 1.0", ["[parameters]: 'held' of their.fmu is of causality output"]),
    "steps of one size": ({**FIXED, 'stepSize="0.001"': 'stepSize="0.002"'}, "", ["their.fmu", "2 ms", "10 ms"]),
    "of FMI 1.0 that is none": (FMI1, "", ["is of FMI version 1.0", "correct fmiVersion"]),
}  # fmt: skip


@pytest.mark.parametrize(("xml", "mapping", "words"), BAD.values(), ids=BAD.keys())
def test_what_does_not_fit_is_refused_with_a_remedy(
    xml: dict[str, str], mapping: str, words: list[str], tmp_path: Path, fmus: Path
) -> None:
    with pytest.raises(RovbrushError) as refused:
        planned(tmp_path, fmus, xml, mapping)
    assert all(word in str(refused.value) for word in words), str(refused.value)


def test_a_binary_for_another_system_only_is_refused(tmp_path: Path, fmus: Path) -> None:
    with zipfile.ZipFile(fmus / "gain.fmu") as archive:
        ours = [name for name in archive.namelist() if name.startswith("binaries/")]
    files: dict[str, bytes | None] = {**dict.fromkeys(ours), "binaries/darwin32/gain.dylib": b"a library"}
    with pytest.raises(RovbrushError, match=r"has no binary for linux64; it has darwin32"):
        planned(tmp_path, fmus, {}, **files)


def test_steps_of_one_size_are_no_fault_where_the_period_is_that_size(tmp_path: Path, fmus: Path) -> None:
    xml = {**FIXED, 'stepSize="0.001"': 'stepSize="0.01"'}
    assert planned(tmp_path, fmus, xml).clock.periods["g"] > 0


def test_the_remedy_of_steps_of_one_size_works(tmp_path: Path, fmus: Path) -> None:
    plan = planned(tmp_path, fmus, {**FIXED, 'stepSize="0.001"': 'stepSize="0.002"'}, period="2 ms")
    assert plan.clock.seconds(plan.clock.periods["g"]) * 500 == 1


OPTIONS = {
    "no component": (["gg=x.fmu"], [], [], ["no component 'gg'", "did you mean 'g'"]),
    "no file": (["g=nowhere.fmu"], [], [], ["nowhere.fmu does not exist"]),
    "no equals sign": (["their.fmu"], [], [], ["--replace their.fmu: write component=value", "--replace w=their.fmu"]),
    "twice": (["g=a.fmu", "g=b.fmu"], [], [], ["--replace g=b.fmu: g has", "a.fmu already"]),
    "a mapping alone": ([], ["g=map.toml"], [], ["--map g: nothing replaces g"]),
    "a period of nothing": ([], [], ["gg=1 ms"], ["--period: no component 'gg'", "did you mean 'g'"]),
    "a period that is none": ([], [], ["g=soon"], ["--period g = 'soon' is not a time"]),
}


@pytest.mark.parametrize(("replace", "maps", "periods", "words"), OPTIONS.values(), ids=OPTIONS.keys())
def test_wrong_options_are_refused(
    replace: list[str], maps: list[str], periods: list[str], words: list[str], tmp_path: Path, fmus: Path
) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text(PARTS, WIRES), encoding="utf-8")
    with pytest.raises(RovbrushError) as refused:
        apply_changes(load_system(str(path), fmus), changes_of(replace, maps, periods))
    assert all(word in str(refused.value) for word in words), str(refused.value)
