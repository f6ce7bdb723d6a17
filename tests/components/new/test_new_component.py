"""`rovbrush new-component`: what it writes passes everything, wherever it lies; what cannot be is one clear error."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, rovbrush, run_of
from kernel_unit import KernelUnit
from lives import Case, history, lives
from rovbrush.components.build import COMPONENTS, HERE, build, folder_of
from rovbrush.components.describe import theory
from rovbrush.components.errors import BuildError, NewComponentError, UnknownComponentError
from rovbrush.components.new.write import TEMPLATE, new_component, renamed
from rovbrush.components.python.building.build import carried_text, sources
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.component_tests.suites import suite_of

NAME = "pushed_body"
PROGRAMS = {"rovbrush": [sys.executable, "-m", "rovbrush.orchestrator"], "python": [sys.executable]}


@pytest.fixture(scope="module")
def body(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new component, as a stranger gets it, in a folder of his own."""
    return new_component(NAME, tmp_path_factory.mktemp("stranger"))[0]


def ended_well(command: str, folder: Path) -> str:
    """What a command of the README prints, which must succeed, typed in a folder."""
    program, *arguments = shlex.split(command)
    words = [*PROGRAMS[program], *arguments]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def printed(tmp_path_factory: pytest.TempPathFactory, measured: Measured) -> tuple[Path, list[str]]:
    """A folder where the lines that new-component prints were typed, and what each answered."""
    folder = tmp_path_factory.mktemp("printed")
    begin = time.perf_counter()
    said = ended_well(f"rovbrush new-component {NAME}", folder)
    commands = re.findall(r"^  ((?:rovbrush|python) .*?)  ", said, re.MULTILINE)
    answers = [ended_well(command, folder) for command in commands]
    measured("new component: written, built, tested, run, built in C, checked [s]", time.perf_counter() - begin, "none")
    return folder, answers


@pytest.fixture
def files(printed: tuple[Path, list[str]]) -> list[Path]:
    """Its FMUs."""
    fmus = printed[0] / "fmus"
    return [fmus / f"{NAME}.fmu", *(fmus / "native" / version / f"{NAME}.fmu" for version in ("fmi2", "fmi3"))]


def test_what_is_printed_works_as_it_stands(printed: tuple[Path, list[str]], files: list[Path]) -> None:
    """Written, built, tested, run, built in C, checked and described, by the lines that new-component prints."""
    folder, answers = printed
    assert len(answers) == 6
    tested, checked = answers[1], answers[4]
    assert "9 passed, 0 failed, 0 not applicable" in tested and "0 errors, 0 findings" in checked
    assert set((folder / "fmus").rglob("*.fmu")) == set(files)


def test_its_kernel_has_three_lives(body: Path) -> None:
    case = Case(str(body), 0.1, 60, {"F": (2.0, 9.0)}, {"v_start": 0.3})
    runs = {life: history(case, functions) for life, functions in lives(case.name).items()}
    assert np.ptp([step["y"][0] for step in runs["python"]]) > 0.1
    for life in ("numba", "c"):
        for expected, seen in zip(runs["python"], runs[life], strict=True):
            assert all(array.tobytes() == seen[name].tobytes() for name, array in expected.items()), life


def test_its_kernel_and_all_its_fmus_behave(
    body: Path, files: list[Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for test in suite_of(str(body)).tests:
        test(KernelUnit(str(body)))
    for path in files:
        assert rovbrush(monkeypatch, "test-component", path, "--as", body, "--tolerance", "0") == 0
    rows = [column(run_of(tmp_path, tmp_path, {"a": (str(path), "1 ms", {"=F": 8.0})}), "a.W_drag") for path in files]
    assert len(rows[0][1]) > 1000 and all(row[1].tobytes() == rows[0][1].tobytes() for row in rows)


@pytest.mark.evidence
def test_all_its_fmus_are_fit_to_be_exchanged(files: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """That for FMI 3.0 is by what is printed."""
    for path in files:
        assert rovbrush(monkeypatch, "check", path, "--strict") == 0


def test_its_readme_lists_its_equations_and_variables(body: Path) -> None:
    text = (body / "README.md").read_text(encoding="utf-8")
    assert [one.number for one in theory.equations(str(body))] == ["A1", "A2"]
    assert text == theory.with_table(text, str(body)) and f"`{NAME}/kernel.py:" in text
    assert "| 3 | `F` | input | Real | N |" in text


def test_after_a_change_its_readme_is_described_anew(tmp_path: Path) -> None:
    folder, _ = new_component("changed_body", tmp_path)
    kernel = folder / "kernel.py"
    kernel.write_text(kernel.read_text().replace("    y.s = x.s\n", "    y.s = x.s  # Eq. A3\n"))
    before = (folder / "README.md").read_text()
    assert ended_well(f"python -m rovbrush.components.describe {folder}", tmp_path) == f"{folder / 'README.md'}\n"
    after = (folder / "README.md").read_text()
    assert "| Eq. A3 | `y.s` |" in after and after != before


@pytest.mark.parametrize("path", sorted(TEMPLATE.glob("*.py")), ids=lambda path: path.name)
def test_an_fmu_carries_the_same_text_wherever_the_component_lies(path: Path, tmp_path: Path) -> None:
    outside, inside = (tmp_path / side for side in ("outside.py", "inside.py"))
    text = path.read_text(encoding="utf-8")
    outside.write_text(renamed(text, NAME, inside=False), encoding="utf-8")
    inside.write_text(renamed(text, NAME, inside=True), encoding="utf-8")
    without_blanks = [carried_text(side).replace(b"\n\n", b"\n") for side in (outside, inside)]
    assert without_blanks[0] == without_blanks[1]
    assert "rovbrush" not in inside.read_text() and "..." not in outside.read_text()


# --- what cannot be written ---


@pytest.mark.parametrize("name", ["", "a b", "2nd", "a-b", "_a", "über", "a.b", "../a", "a/b", "x" * 65])
def test_a_name_that_no_fmu_can_have_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(NewComponentError, match="is no name for a component"):
        new_component(name, tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "why"),
    [
        *((name, "already") for name in COMPONENTS),
        ("class", "a word of Python"),
        ("match", "a word of Python"),
        ("declare", "a part of rovbrush.components"),
        ("errors", "a part of rovbrush.components"),
        ("json", "Python has a module json already"),
        ("numpy", "Python has a module numpy already"),
    ],
)
def test_a_name_that_is_taken_is_refused(name: str, why: str, tmp_path: Path) -> None:
    with pytest.raises(NewComponentError, match=why):
        new_component(name, tmp_path)
    assert not list(tmp_path.iterdir())


def test_what_exists_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("of somebody")
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    for name in ("folder", "file", "link"):
        with pytest.raises(NewComponentError, match="exists; choose another name"):
            new_component(name, tmp_path)
    with pytest.raises(NewComponentError, match="file is no folder"):
        new_component(NAME, tmp_path / "file")
    assert {path.name for path in tmp_path.iterdir()} == {"folder", "file", "link"}
    assert not list((tmp_path / "folder").iterdir()) and (tmp_path / "file").read_text() == "of somebody"


def test_the_command_says_what_is_wrong_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert rovbrush(monkeypatch, "new-component", "dc_motor", "--folder", tmp_path) == 2
    assert " ".join(capsys.readouterr().err.split()) == (
        "error: there is a component dc_motor already; choose another name"
    )


# --- what is wrong in one of one's own ---


@pytest.fixture
def copy(body: Path, tmp_path: Path) -> Path:
    """The component once more, to be broken."""
    folder = tmp_path / NAME
    folder.mkdir()
    for path in body.iterdir():
        if path.is_file():
            (folder / path.name).write_bytes(path.read_bytes())
    return folder


@pytest.mark.parametrize(
    ("file", "old", "new", "error"),
    [
        ("kernel.py", "u.F / p.d", "u.F / p.drag", r"kernel\.py:\d+: Parameters has no field 'drag'"),
        ("kernel.py", "    v_end = u.F / p.d\n", "    v_end = u.F /\n", r"kernel\.py:\d+: invalid syntax"),
        ("fmu.py", "from . import kernel\n", "import rovbrush.orchestrator\nfrom . import kernel\n",
         r"fmu\.py:\d+: an FMU carries rovbrush.components only"),
        ("fmu.py", "\n\nclass ", "\n\nclass Other:\n    pass\n\n\nclass ", r"fmu\.py: there is one class.* here are 2"),
        ("records.py", '    v: float = value(', '    m: float = value("kg", "masses", 3)\n    v: float = value(',
         r"fmu\.py: the parameter 'm' has the name of an array of state or scratch; rename it"),
        ("parameters.py", "    d: float", "    h: float", r"fmu\.py: the parameter 'h' has the name of the step size"),
        ("parameters.py", "    d: float", "    y: float", r"fmu\.py: the parameter 'y' has the name of the outputs"),
        ("parameters.py", "    d: float", "    state: float", r"fmu\.py: the parameter 'state' has the name of an"),
        ("records.py", "    F: float = input_", "    d: float = input_",
         r"fmu\.py: the input 'd' has the name of the parameter before it"),
        ("records.py", "    v: float = output", "    F: float = output",
         r"fmu\.py: the output 'F' has the name of the input before it"),
    ],
)  # fmt: skip
def test_a_fault_in_a_component_is_told_with_its_file(copy: Path, file: str, old: str, new: str, error: str) -> None:
    text = (copy / file).read_text()
    assert old in text
    (copy / file).write_text(text.replace(old, new, 1))
    with pytest.raises(BuildError, match=re.escape(f"{copy}/") + error):
        build(copy, copy.parent / "fmus")


def test_a_folder_that_is_no_component_is_told(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    for folder in (tmp_path / "empty", tmp_path / "nowhere"):
        with pytest.raises(UnknownComponentError, match=r"it has no fmu\.py; `rovbrush new-component` writes one"):
            folder_of(str(folder))
        with pytest.raises(InputError, match=r"it has no behaviour\.py"):
            suite_of(str(folder))
    assert folder_of("dc_motor") == HERE / "dc_motor"


def test_a_component_s_folder_has_the_name_of_a_module(copy: Path) -> None:
    renamed_folder = copy.rename(copy.parent / "pushed-body")
    with pytest.raises(UnknownComponentError, match="letters, digits and _"):
        folder_of(str(renamed_folder))


def test_tests_of_another_module_of_that_name_are_not_taken(tmp_path: Path) -> None:
    """A folder `json`: what Python has imported under that name is something else."""
    (tmp_path / "json").mkdir()
    (tmp_path / "json" / "behaviour.py").write_text("SUITE = None\n")
    with pytest.raises(InputError, match="cannot be imported"):
        suite_of(str(tmp_path / "json"))
    (tmp_path / "unsuited").mkdir()
    (tmp_path / "unsuited" / "behaviour.py").write_text("")
    with pytest.raises(InputError, match="has no SUITE"):
        suite_of(str(tmp_path / "unsuited"))


def test_a_component_in_a_package_is_a_part_of_it(copy: Path) -> None:
    """In a folder with `__init__.py` it may import what lies beside it, as pytest takes such files."""
    (copy.parent / "__init__.py").write_text("")
    text = (copy / "behaviour.py").read_text()
    (copy / "behaviour.py").write_text(text.replace("from .fmu import", "from ..beside import H_MAX\nfrom .fmu import"))
    (copy.parent / "beside.py").write_text("H_MAX = 1.0\n")
    assert suite_of(str(copy)).name == NAME


def test_tests_of_a_component_may_fill_a_folder(copy: Path) -> None:
    """`behaviour/__init__.py` takes the place of `behaviour.py`."""
    (copy.parent / "__init__.py").write_text("")
    text = (copy / "behaviour.py").read_text()
    (copy / "behaviour.py").unlink()
    (copy / "behaviour").mkdir()
    (copy / "behaviour" / "__init__.py").write_text(text.replace("from .fmu import", "from ..fmu import"))
    assert suite_of(str(copy)).name == NAME
    assert not [path for path in sources(copy) if "behaviour" in path]
