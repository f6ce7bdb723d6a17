"""Sources outside of an SSP: refused with the word that allows their folder, and taken with it; nothing is fetched."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from helpers import rovbrush
from rovbrush.orchestrator.api import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system
from ssp_files import document, system, write_ssp_file


@pytest.fixture
def elsewhere(tmp_path: Path, fmus: Path) -> Path:
    """A folder with an FMU beside that of the case."""
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    shutil.copy(fmus / "gain.fmu", folder)
    return folder


SOURCES = {"up": "../elsewhere/gain.fmu", "absolute": "{}/gain.fmu", "file": "file://{}/gain.fmu"}
KINDS = ["package", "structure", "folder"]


def written(kind: str, source: str, tmp_path: Path, fmus: Path) -> Path:
    """A .ssp, a .ssd or the folder of one, in whose place `..` is the same folder."""
    text = document(system(f'<ssd:Component name="a" source="{source}"/>'))
    if kind == "package":
        return write_ssp_file(tmp_path / "case.ssp", fmus, text, ())
    (tmp_path / "case").mkdir()
    structure = tmp_path / "case" / "SystemStructure.ssd"
    structure.write_text(text)
    return structure if kind == "structure" else structure.parent


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("source", SOURCES)
def test_a_source_outside_is_taken_from_folders_that_are_allowed(
    kind: str, source: str, elsewhere: Path, tmp_path: Path, fmus: Path
) -> None:
    path = written(kind, SOURCES[source].format(elsewhere), tmp_path, fmus)
    with pytest.raises(InputError) as error:
        load_system(str(path))
    assert "leaves the folder of the SSP" in str(error.value)
    word = str(error.value).partition("--allow-outside ")[2].split()[0]
    assert word == str(elsewhere)
    assert set(load_system(str(path), outside=[Path(word)]).components) == {"a"}
    assert set(load_system(str(path), outside=[tmp_path]).components) == {"a"}
    with pytest.raises(InputError, match="leaves the folder"):
        load_system(str(path), outside=[tmp_path / "else"])


def test_the_word_works_on_the_command_line_and_from_python(
    elsewhere: Path, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written("package", SOURCES["up"], tmp_path, fmus)
    monkeypatch.chdir(tmp_path)
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", "case.ssp", "--out", out) == 2
    assert rovbrush(monkeypatch, "run", "case.ssp", "--out", out, "--allow-outside", "elsewhere") == 0
    assert rovbrush(monkeypatch, "plan", "case.ssp", "--allow-outside", "elsewhere") == 0
    assert rovbrush(monkeypatch, "export", "case.ssp", "--ssp", "--out", "own.ssp", "--allow-outside", "elsewhere") == 0
    assert set(load_system("own.ssp").components) == {"a"}
    assert load(path, allow_outside=["elsewhere"]).run(stop="10 ms")["a.y"] is not None


@pytest.mark.parametrize(
    "source", ["http://example.org/a.fmu", "//host/a.fmu", "fmu-proxy://localhost:9091?file=a.fmu"]
)
def test_nothing_is_fetched_whatever_is_allowed(source: str, tmp_path: Path, fmus: Path) -> None:
    path = written("package", source, tmp_path, fmus)
    with pytest.raises(InputError, match="is not inside the SSP; nothing is fetched from elsewhere"):
        load_system(str(path), outside=[Path("/")])


def test_a_link_that_leads_outside_is_outside(elsewhere: Path, tmp_path: Path, fmus: Path) -> None:
    path = written("structure", "gain.fmu", tmp_path, fmus)
    (path.parent / "gain.fmu").symlink_to(elsewhere / "gain.fmu")
    with pytest.raises(InputError, match=rf"--allow-outside {elsewhere}"):
        load_system(str(path))
    assert set(load_system(str(path), outside=[elsewhere]).components) == {"a"}


def test_a_drive_of_another_machine_is_one_error(tmp_path: Path, fmus: Path) -> None:
    path = written("package", "C:\\models\\a.fmu", tmp_path, fmus)
    with pytest.raises(InputError, match="is on a drive of another machine; put the file into the SSP"):
        load_system(str(path))
