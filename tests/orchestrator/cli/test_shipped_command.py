"""What comes with the package can be copied and then runs where it lies; the documentation is found."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest
from helpers import rovbrush
from rovbrush.orchestrator.cli import documentation
from rovbrush.orchestrator.cli.documentation import open_page
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_names, settings_tables
from rovbrush.orchestrator.system.file.copied import copy_shipped
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.shipped import SCHEMAS, SWEEPS, SYSTEMS, shipped_systems
from rovbrush.orchestrator.system.schema.pages import Algorithms, schema_text

EVERY = [*(SYSTEMS / f"{name}.toml" for name in shipped_systems()), *sorted(SWEEPS.glob("*.toml"))]


@pytest.mark.parametrize("path", EVERY, ids=lambda path: path.stem)
def test_the_first_line_of_a_shipped_file_names_its_schema(path: Path) -> None:
    word, _, name = path.read_text(encoding="utf-8").partition("\n")[0].partition(" ")
    kind = "sweep" if path.parent == SWEEPS else "system"
    assert word == "#:schema" and (path.parent / name).resolve() == SCHEMAS / f"{kind}.schema.json"


@pytest.mark.parametrize("kind", ["system", "sweep"])
def test_the_shipped_schemas_are_current(kind: str) -> None:
    """Else: `rovbrush schema KIND --out orchestrator/systems/schema/KIND.schema.json`."""
    current = schema_text(kind, Algorithms(algorithm_names(), settings_tables()))
    assert (SCHEMAS / f"{kind}.schema.json").read_text(encoding="utf-8") == current


@pytest.mark.parametrize("name", ["nominal", "hull_pass", "three_cups", "test_stand"])
def test_a_copied_system_is_the_shipped_one_and_needs_nothing_of_it(
    name: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shipped = load_system(name, fmus)
    paths = copy_shipped(name, tmp_path / "mine")
    monkeypatch.setattr("rovbrush.orchestrator.system.file.parameter_sets.SYSTEMS", tmp_path / "nowhere")
    copy = load_system(str(paths[0]), fmus)
    assert (copy.components, copy.connections, copy.events) == (shipped.components, shipped.connections, shipped.events)
    assert copy.parameter_set == shipped.parameter_set and copy.stop == shipped.stop
    first = paths[0].read_text().partition("\n")[0]
    assert json.loads((tmp_path / "mine" / first.removeprefix("#:schema ")).read_text())["title"]
    assert tomllib.loads(paths[0].read_text()) == tomllib.loads((SYSTEMS / f"{name}.toml").read_text())


def test_the_command_says_what_it_wrote_and_what_to_type(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert rovbrush(monkeypatch, "systems", "--copy", "nominal", "--to", tmp_path / "mine") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "wrote nominal.toml, paper.toml, system.schema.json" in said
    assert f"rovbrush run {tmp_path / 'mine' / 'nominal.toml'} --out results" in said
    assert rovbrush(monkeypatch, "systems", "--copy", "map", "--to", tmp_path / "mine") == 0
    assert "rovbrush sweep" in capsys.readouterr().out and (tmp_path / "mine" / "sweep.schema.json").is_file()


def test_without_a_folder_the_copy_is_made_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert rovbrush(monkeypatch, "systems", "--copy", "no_load") == 0
    assert {"no_load.toml", "system.schema.json"} <= {path.name for path in tmp_path.iterdir()}


def test_two_systems_share_a_parameter_set_and_nothing_is_written_over(tmp_path: Path) -> None:
    copy_shipped("nominal", tmp_path)
    assert (tmp_path / "paper.toml").is_file() and copy_shipped("jam", tmp_path) and copy_shipped("jam", tmp_path)
    (tmp_path / "paper.toml").write_text("changed = 1\n")
    before = sorted(path.name for path in tmp_path.iterdir())
    with pytest.raises(InputError, match=r"holds paper\.toml already, which is not written over; .*--to"):
        copy_shipped("no_load", tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == before
    assert (tmp_path / "paper.toml").read_text() == "changed = 1\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--copy", "nominl"), "no shipped system or sweep 'nominl'; did you mean 'nominal'?"),
        (("--copy", "../systems/nominal"), "no shipped system or sweep"),
        (("--copy", "paper"), "no shipped system or sweep 'paper'"),
        (("--copy", "nominal", "--to", "{file}"), "cannot write to the output folder"),
        (("--copy", "nominal", "--to", "{file}/below"), "choose another with --to"),
        (("--to", "."), "say of what with --copy NAME"),
    ],
)
def test_what_cannot_be_copied_is_one_clear_error(
    arguments: tuple[str, ...], message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    words = [word.format(file=tmp_path / "file") for word in arguments]
    assert rovbrush(monkeypatch, "systems", *words) == 2
    said = capsys.readouterr().err
    assert message in said and "Traceback" not in said and [path.name for path in tmp_path.iterdir()] == ["file"]


# --- rovbrush docs ---


def test_the_built_site_comes_before_an_address(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(documentation, "PACKAGE", tmp_path)
    monkeypatch.setattr(documentation, "_urls", lambda: {"homepage": "https://a.example", "documentation": "https://b.example"})  # fmt: skip  # noqa: E501
    assert rovbrush(monkeypatch, "docs", "--path") == 0
    assert capsys.readouterr().out == "https://b.example\n"
    page = tmp_path / "build" / "docs" / "index.html"
    page.parent.mkdir(parents=True)
    page.write_text("")
    assert rovbrush(monkeypatch, "docs", "--path") == 0
    assert capsys.readouterr().out == f"{page}\n"


def test_without_a_browser_the_place_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(documentation, "PACKAGE", tmp_path)
    monkeypatch.setattr(documentation, "_urls", lambda: {"documentation": "https://b.example"})
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("webbrowser.open", lambda _: False)
    assert rovbrush(monkeypatch, "docs") == 0
    assert capsys.readouterr().out == "https://b.example\nno browser could be opened here; open it yourself\n"


def test_a_browser_gets_the_address_of_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr("webbrowser.open", lambda url: opened.append(url) or True)
    assert open_page(str(tmp_path / "a b.html")) and open_page("https://b.example")
    assert opened == [(tmp_path / "a b.html").as_uri(), "https://b.example"]


def test_where_there_is_none_that_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(documentation, "PACKAGE", tmp_path)
    monkeypatch.setattr(documentation, "_urls", dict)
    assert rovbrush(monkeypatch, "docs") == 2
