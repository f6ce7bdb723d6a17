"""What is not written as C is one error that names who it is and what serves instead, before anything is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from emit_cases import Masses, with_sources
from helpers import edited, read_system, rovbrush
from native_build import NATIVE, WIRES2, answers, feedthrough2, needs_gcc
from rovbrush.orchestrator.emit.export import export_c, export_fmu
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc


def test_events_at_times_that_cannot_be_counted_are_named(carried: Path, tmp_path: Path) -> None:
    path = tmp_path / "eventful.toml"
    path.write_text(
        'format = 2\nstop_time = "1 s"\nconnections = []\n[components.a]\nfmu = "mass"\nperiod = "1 ms"\n'
        '[[events]]\nname = "push"\nat = "0.1234567890123456789 s"\nset = { "a.F" = 1.0 }\n'
    )
    with pytest.raises(InputError, match=r"the events of eventful cannot be counted in C, at times that need ticks of"):
        export_fmu(load_system(str(path), carried), tmp_path / "x.fmu")
    assert not (tmp_path / "x.fmu").exists()


def test_texts_between_components_are_named_with_their_connection(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "feedthrough2.fmu")
    parts = {"a": ("feedthrough2", "1 ms"), "b": ("feedthrough2", "1 ms")}
    system = read_system(tmp_path, tmp_path, parts, [w for w in WIRES2 if "s_out" in w], stop="5 ms")
    with pytest.raises(
        InputError, match=r"a.s_out -> b.s_in passes a String, which is not done in C; take --container"
    ):
        export_c(system, tmp_path / "c")


def test_a_component_without_c_sources_is_named_with_what_serves_instead(carried: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, carried, {"a": ("bare", "1 ms")}, [], stop="5 ms")
    with pytest.raises(InputError, match=r"a has no C to write: take --fmu, .*bare.fmu has no C sources"):
        export_c(system, tmp_path / "c")
    assert not (tmp_path / "c").exists()


def test_sources_that_do_not_compile_are_told_in_the_compilers_words(tmp_path: Path) -> None:
    fmu = with_sources(answers(tmp_path / "wrong.fmu", "mass"), "answers.c")
    broken = (NATIVE / "answers.c").read_bytes().replace(b"typedef struct", b"typedef strukt", 1)
    edited(fmu, tmp_path / "copy.fmu", {"sources/answers.c": broken})
    system = read_system(tmp_path, tmp_path, {"a": ("copy", "1 ms")}, [], stop="5 ms")
    with pytest.raises(InputError, match=r"(?s)component a has no C to write: .*cannot be compiled:.*strukt"):
        export_c(system, tmp_path / "c")


def test_a_folder_of_something_else_is_left_alone(masses: Masses, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("words")
    with pytest.raises(InputError, match="the folder is not empty, and holds no exported"):
        export_c(masses(), tmp_path / "mine")
    with pytest.raises(InputError, match="is a file; name a folder"):
        export_c(masses(), tmp_path / "mine" / "thesis.txt")
    assert [path.name for path in (tmp_path / "mine").iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--fmu", "--ssp"], "choose one of --ssp, --fmu, --c DIR and --container"),
        ([], "choose one of --ssp, --fmu, --c DIR and --container"),
        (["--c", "x", "--out", "y"], "leave out --out"),
        (["--fmu", "--fmi", "1.0"], "--fmi 1.0: an FMU is written as 2.0 or 3.0"),
        (["--fmu", "--out", "x.zip"], "the name must end in .fmu"),
    ],
)
def test_options_that_do_not_go_together_are_refused(
    options: list[str], said: str, carried: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    read_system(tmp_path, carried, {"a": ("mass", "1 ms")}, [], stop="5 ms")
    assert rovbrush(monkeypatch, "export", "case.toml", "--fmus", carried, *options) == 2
    assert said in " ".join(capsys.readouterr().err.split())
