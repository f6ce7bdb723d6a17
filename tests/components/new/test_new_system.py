"""`rovbrush new`: what it writes runs and passes its own test, wherever it lies; what cannot be is one clear error."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import jsonschema
import pytest
from helpers import rovbrush
from rovbrush.components.build import build_all
from rovbrush.components.errors import BuildError, NewComponentError, UnknownComponentError
from rovbrush.components.new.write_system import new_system

NAME = "my_plant"
PROGRAMS = {"rovbrush": [sys.executable, "-m", "rovbrush.orchestrator"], "pytest": [sys.executable, "-m", "pytest"]}


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory, fmus: Path) -> tuple[Path, str]:
    """A new system in a folder of a stranger's, and what the command said."""
    place = tmp_path_factory.mktemp("stranger")
    return place / NAME, ended_well(f"rovbrush new {NAME}", place, fmus)


def ended_well(command: str, folder: Path, fmus: Path) -> str:
    """What a command prints, which must succeed, typed in a folder."""
    program, *arguments = shlex.split(command)
    done = subprocess.run(
        [*PROGRAMS[program], *arguments], cwd=folder, capture_output=True, text=True, check=False,
        env={**os.environ, "ROVBRUSH_FMUS": str(fmus)},
    )  # fmt: skip
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def test_what_is_printed_works_as_it_stands(said: tuple[Path, str], fmus: Path) -> None:
    """Written, run, drawn, tested and built again, by the lines that it prints; the speed is held."""
    folder, text = said
    commands = re.findall(r"^  ((?:rovbrush|pytest).*?)  ", text, re.MULTILINE)
    assert len(commands) == 4 and "before it runs" not in text
    before = (folder / "speed_controller.fmu").read_bytes()
    answers = [ended_well(command, folder, fmus) for command in commands]
    summary = json.loads((folder / "results" / "summary.json").read_text())
    assert summary["complete"] and abs(summary["omega_end"] - 12.0) < 0.12
    assert "4 passed" in answers[2] and (folder / f"{NAME}.svg").is_file()
    assert (folder / "speed_controller.fmu").read_bytes() == before, "the same text is the same bytes"
    readme = (folder / "README.md").read_text()
    assert all(command in readme for command in commands[:2]) and "template" not in readme


def test_its_editor_knows_its_keys(said: tuple[Path, str]) -> None:
    folder = said[0]
    text = (folder / f"{NAME}.toml").read_text()
    assert text.startswith("#:schema system.schema.json\n")
    schema = json.loads((folder / "system.schema.json").read_text())
    jsonschema.Draft202012Validator(schema).validate(tomllib.loads(text))
    (rule,) = tomllib.loads((folder / ".taplo.toml").read_text())["rule"]
    assert rule["include"] == [f"{NAME}.toml"] and (folder / rule["schema"]["path"]).is_file()
    for path in (folder / ".vscode").iterdir():
        json.loads(path.read_text())


@pytest.mark.parametrize("name", ["", "a b", "2nd", "a-b", "über", "../a", "a/b", ".", "x" * 65, "$(id)"])
def test_a_name_that_no_file_should_have_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(NewComponentError, match="is no name for a system"):
        new_system(name, tmp_path, {})
    assert not list(tmp_path.iterdir())


def test_what_exists_is_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("of somebody")
    for name in ("folder", "file"):
        assert rovbrush(monkeypatch, "new", name, "--folder", tmp_path) == 2
        assert "exists; choose another name" in capsys.readouterr().err
    assert rovbrush(monkeypatch, "new", NAME, "--folder", tmp_path / "file") == 2
    assert "file is no folder" in capsys.readouterr().err
    assert rovbrush(monkeypatch, "new", "nominal", "--folder", tmp_path) == 2
    assert "`rovbrush systems --copy nominal` copies it" in capsys.readouterr().err
    assert {path.name for path in tmp_path.iterdir()} == {"folder", "file"}


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_to_is_told(tmp_path: Path) -> None:
    tmp_path.chmod(0o555)
    try:
        with pytest.raises(NewComponentError, match="cannot write"):
            new_system(NAME, tmp_path, {})
    finally:
        tmp_path.chmod(0o755)


def test_if_its_fmu_cannot_be_built_nothing_is_left(tmp_path: Path) -> None:
    with pytest.raises(BuildError, match="speed_controller"):
        new_system(NAME, tmp_path, {"speed_controller.py": "no Python"})
    assert not list(tmp_path.iterdir())


# --- scripts of pythonfmu's ---

SCRIPT = """
from pythonfmu import Fmi2Causality, Fmi2Slave, Real


class Doubled(Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.u = self.y = 0.0
        self.register_variable(Real("u", causality=Fmi2Causality.input))
        self.register_variable(Real("y", causality=Fmi2Causality.output))

    def do_step(self, current_time, step_size):
        self.y = 2.0 * self.u
        return True
"""


def test_a_script_is_built_and_runs_twice_in_one_process(tmp_path: Path) -> None:
    """Plain pythonfmu 0.7.0 crashes at the second instance."""
    from rovbrush.orchestrator import load

    (tmp_path / "doubled.py").write_text(SCRIPT)
    (fmu,) = build_all(tmp_path, (str(tmp_path / "doubled.py"),))
    assert fmu == tmp_path / "doubled.fmu"
    code = (
        f"from rovbrush.orchestrator import load; m = load({str(fmu)!r}, step='0.1 s', stop='1 s').set('u', 3.0); "
        "print(*[float(m.run()['y'][-1]) for _ in range(3)])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.split()) == (0, ["6.0"] * 3), done.stderr
    assert load(fmu, step="0.1 s", stop="1 s").system.components["doubled"].fmu.digest
    with zipfile.ZipFile(fmu) as archive:
        assert b"1980-01-01" in archive.read("modelDescription.xml")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("class A(:\n", r"faulty\.py:1: "),
        ("x = 1\n", "faulty.py: .*Fmi2Slave"),
        ("raise RuntimeError('no licence')\n", "faulty.py: RuntimeError: no licence"),
    ],
)
def test_a_fault_in_a_script_is_told_with_its_file(text: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "faulty.py").write_text(text)
    with pytest.raises(BuildError, match=message):
        build_all(tmp_path, (str(tmp_path / "faulty.py"),))
    assert [path.name for path in tmp_path.glob("*.fmu")] == []


def test_a_script_has_a_name_of_a_module_and_no_c(tmp_path: Path) -> None:
    (tmp_path / "a-b.py").write_text(SCRIPT)
    (tmp_path / "doubled.py").write_text(SCRIPT)
    with pytest.raises(UnknownComponentError, match="letters, digits and _"):
        build_all(tmp_path, (str(tmp_path / "a-b.py"),))
    with pytest.raises(BuildError, match="there is no C of it"):
        build_all(tmp_path, (str(tmp_path / "doubled.py"),), platforms=("linux64",))
    with pytest.raises(UnknownComponentError, match="nowhere"):
        build_all(tmp_path, (str(tmp_path / "nowhere.py"),))
