"""terminalsAndIcons.xml: what is good in it is read, what is not is passed over with a note, and no run rests on it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from helpers import edited, read_system, rovbrush
from native_build import built, needs_gcc
from rovbrush.orchestrator.cli.console import console
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from terminal_files import HEAD, PLACE, TAIL, member, stream, terminal, with_terminals

pytestmark = needs_gcc

GOOD = terminal("port", member("u", "Float64_in"), terminal("inner", member("a", "a_in")), kind="Some.Kind")


@pytest.fixture(scope="module")
def bare(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("bare")) / "feedthrough3.fmu"


def opened(bare: Path, folder: Path, text: str | bytes) -> Fmu:
    content = text.encode() if isinstance(text, str) else text
    return Fmu.open(edited(bare, folder / "toy.fmu", {PLACE: content}))


def said(fmu: Fmu) -> str:
    return "\n".join(note.found for note in fmu.notes if "terminal" in note.found)


def test_terminals_are_known_by_their_whole_names(bare: Path, tmp_path: Path) -> None:
    fmu = opened(bare, tmp_path, HEAD + GOOD + TAIL)
    assert list(fmu.terminals) == ["port", "port.inner"] and not said(fmu)
    assert fmu.terminals["port"].kind == "Some.Kind" and fmu.terminals["port.inner"].members[0].variable == "a_in"
    assert Fmu.open(bare).terminals == {}


@pytest.mark.parametrize(
    ("inside", "left", "words"),
    [
        (terminal("", member("u", "Float64_in")), [], "passed over"),
        (terminal("p", member("u", "Float64_in")) * 2, ["p"], "another of the name"),
        (terminal("p", member("u", "nothing")), ["p"], "'u'|u of"),
        (terminal("p", member("", "Float64_in")), ["p"], "Float64_in"),
        (terminal("p", member("u", "Float64_in"), member("u", "Float64_out")), ["p"], "'u' of"),
        (terminal("p", stream("Float64_in", "nothing")), ["p"], "h_in and h_out"),
        ('<Terminal name="p"/>', ["p"], "no matchingRule of"),
    ],
)
def test_what_names_nothing_is_passed_over_and_noted(
    inside: str, left: list[str], words: str, bare: Path, tmp_path: Path
) -> None:
    fmu = opened(bare, tmp_path, HEAD + inside + TAIL)
    assert list(fmu.terminals) == left
    assert any(word in said(fmu) for word in words.split("|")), said(fmu)


@pytest.mark.parametrize(
    "text",
    [
        "", "<", HEAD, "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]>" + HEAD + TAIL,
        b"\xff\xfe\x00", '<?xml version="1.0" encoding="UTF-77"?><a/>',
        "<!DOCTYPE a [<!ENTITY b 'bb'><!ENTITY c '&b;&b;'>]><a>&c;</a>",
    ],
)  # fmt: skip
def test_a_file_that_is_none_is_noted_and_the_fmu_has_no_terminals(
    text: str | bytes, bare: Path, tmp_path: Path
) -> None:
    fmu = opened(bare, tmp_path, text)
    assert fmu.terminals == {} and "it has none" in said(fmu)
    with pytest.raises(InputError, match="has no output 'port'"):
        read_system(tmp_path, tmp_path, {"a": ("toy", "1 ms"), "b": ("toy", "1 ms")}, ["a.port -> b.port"])


def test_terminals_in_terminals_end_somewhere(bare: Path, tmp_path: Path) -> None:
    text = member("u", "Float64_in")
    for _ in range(100):
        text = terminal("p", text)
    assert len(opened(bare, tmp_path, HEAD + text + TAIL).terminals) == 21


def test_info_shows_terminals_and_their_members(
    bare: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = with_terminals(bare, tmp_path / "toy.fmu", [GOOD, terminal("flow", stream("Float64_in", "Float64_out"))])
    monkeypatch.setattr(console, "width", 200)
    assert rovbrush(monkeypatch, "info", path) == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "terminal port.inner: matched by plug" in shown and "terminal port: matched by plug, Some.Kind" in shown
    assert "inflowing stream" in shown
    assert rovbrush(monkeypatch, "info", path, "--json") == 0
    found = json.loads(capsys.readouterr().out)["terminals"]
    assert found[0]["members"] == [{"name": "u", "variable": "Float64_in", "kind": "signal"}]


def test_check_names_what_is_wrong_with_terminals(
    bare: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(console, "width", 400)
    path = with_terminals(bare, tmp_path / "toy.fmu", [terminal("p", member("u", "nothing"))])
    rovbrush(monkeypatch, "check", path)
    shown = " ".join(capsys.readouterr().out.split())
    assert "'u' of TerminalMemberVariable (line 5)" in shown
