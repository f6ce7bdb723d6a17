"""Every way to break the standard that a run can do without: it runs, a note names it, --strict makes it an error."""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import fmpy
import pytest
from breaches import DESCRIPTIONS, DESCRIPTIONS3, FOLDER2, FOLDER3, LIBRARY2, LIBRARY3, SUFFIX, U
from helpers import edited, last, read_system, rovbrush, system_text
from native_build import FREE2, FREE3, built, feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.note_rows import note_rows
from rovbrush.orchestrator.exchange.checks.rules.archive_rules import loadable_row
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.tolerant import rules
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import strictly

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def runs_noted_and_strict(fmu: Path, rule: rules.Rule, words: str, values: Mapping[str, Any], output: str) -> None:
    """It runs rightly, a note names what is wrong and where, `check` finds it, and --strict is an error."""
    parts = {"a": (str(fmu), "1 ms", values)}
    system = read_system(fmu.parent, fmu.parent, parts, stop="10 ms")
    component = system.components["a"].fmu
    noted = {note.rule: note for note in component.notes}
    assert rule in noted, [note.found for note in component.notes]
    assert words in ", ".join(noted[rule].places), noted[rule].places
    run = simulate(make_plan(system))
    assert not run.failure, run.failure
    assert last(run, f"a.{output}") == pytest.approx(0.015, rel=1e-12)
    row = next(row for row in note_rows(open_subject(fmu).notes) if row.rule == rule.found)
    assert row.verdict == "finding" and row.mend == rule.mend and rule.taken in row.found
    with pytest.raises(FmuError) as error:
        strictly(system)
    assert str(fmu) in str(error.value) and rule.found in str(error.value) and rule.mend in str(error.value)


@pytest.mark.parametrize(("rule", "replacements", "words"), DESCRIPTIONS)
def test_a_description_that_breaks_the_standard_runs_with_a_note(
    rule: rules.Rule, replacements: Mapping[str, str], words: str, native: Path, tmp_path: Path
) -> None:
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {}, replacements)
    runs_noted_and_strict(fmu, rule, words, FREE2, "x")


@pytest.mark.parametrize(("rule", "replacements", "words"), DESCRIPTIONS3)
def test_so_does_one_of_fmi_3(
    rule: rules.Rule, replacements: Mapping[str, str], words: str, native: Path, tmp_path: Path
) -> None:
    fmu = edited(native / "feedthrough3.fmu", tmp_path / "feedthrough3.fmu", {}, replacements)
    runs_noted_and_strict(fmu, rule, words, {**FREE3, "=Float64_in": 0.015}, "Float64_out")


BUILD = b'<fmiBuildDescription fmiVersion="2.9"/>'
ARCHIVES: dict[str, tuple[rules.Rule, dict[str, bytes | None], str, int]] = {
    "windows paths": (rules.BACKSLASH, {"resources\\table.csv": b"1", "resources\\": b""}, "resources\\table.csv", 2),
    "another name": (rules.LIBRARY, {LIBRARY2: None, f"{FOLDER2}/model{SUFFIX}": b""}, f"model{SUFFIX}", 2),
    "another case": (rules.LIBRARY, {LIBRARY2: None, f"{FOLDER2}/FeedThrough2{SUFFIX}": b"",
                                     f"{FOLDER2}/helper{SUFFIX}": b"x"}, f"FeedThrough2{SUFFIX}", 2),
    "folder of FMI 3": (rules.PLATFORM, {LIBRARY2: None, f"{FOLDER3}/feedthrough2{SUFFIX}": b""},
                        str(fmpy.platform_tuple), 2),
    "folder of FMI 2": (rules.PLATFORM, {LIBRARY3: None, f"{FOLDER2}/feedthrough3{SUFFIX}": b""},
                        str(fmpy.platform), 3),
    "another build": (rules.BUILD, {"sources/buildDescription.xml": BUILD}, "2.9", 3),
}  # fmt: skip


@pytest.mark.parametrize("case", ARCHIVES)
def test_an_archive_that_breaks_the_standard_runs_with_a_note(case: str, native: Path, tmp_path: Path) -> None:
    rule, changes, words, version = ARCHIVES[case]
    source = native / f"feedthrough{version}.fmu"
    with zipfile.ZipFile(source) as archive:
        library = archive.read(LIBRARY2 if version == 2 else LIBRARY3)
    filled = {
        name: library if content == b"" and name.endswith(SUFFIX) else content for name, content in changes.items()
    }
    fmu = edited(source, tmp_path / source.name, filled)
    if version == 2:
        runs_noted_and_strict(fmu, rule, words, FREE2, "x")
    else:
        runs_noted_and_strict(fmu, rule, words, {**FREE3, "=Float64_in": 0.015}, "Float64_out")
    assert loadable_row(open_subject(fmu)).verdict == "pass"


def test_an_entry_that_is_there_twice_with_the_same_content_is_one(native: Path, tmp_path: Path) -> None:
    fmu = shutil.copy(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu")
    with zipfile.ZipFile(fmu, "a") as archive, pytest.warns(UserWarning, match="Duplicate name"):
        archive.writestr("modelDescription.xml", archive.read("modelDescription.xml"))
    runs_noted_and_strict(fmu, rules.TWICE, "modelDescription.xml", FREE2, "x")


@pytest.mark.parametrize("declared", ["UTF-8", "martian"])
def test_bytes_of_another_encoding_than_the_declared_are_read(declared: str, native: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(native / "feedthrough2.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    text = text.replace("UTF-8", declared).replace('guid="', 'author="M\u00fcller" guid="')
    fmu = edited(
        native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {"modelDescription.xml": text.encode("latin-1")}
    )
    runs_noted_and_strict(fmu, rules.ENCODING, declared, FREE2, "x")
    assert Fmu.open(fmu).description.author == "M\u00fcller"


@pytest.mark.parametrize(
    ("encoding", "mark"), [("ISO-8859-1", b""), ("UTF-8", b"\xef\xbb\xbf"), ("utf8", b""), ("UTF-16", b"")]
)
def test_every_encoding_that_is_declared_is_read_without_a_word(
    encoding: str, mark: bytes, native: Path, tmp_path: Path
) -> None:
    with zipfile.ZipFile(native / "feedthrough2.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    text = text.replace("UTF-8", encoding).replace('guid="', 'author="M\u00fcller" guid="')
    content = mark + text.encode(encoding)
    opened = Fmu.open(edited(native / "feedthrough2.fmu", tmp_path / "f.fmu", {"modelDescription.xml": content}))
    assert opened.description.author == "M\u00fcller" and not opened.notes


@pytest.mark.parametrize("dependencies", ["1\n   4", "1\t4", "  1 4  ", "1&#10;4"])
def test_a_list_may_be_broken_over_lines(dependencies: str, native: Path, tmp_path: Path) -> None:
    changes = {'index="2" dependencies="1"': f'index="2" dependencies="{dependencies}"'}
    opened = Fmu.open(edited(native / "feedthrough2.fmu", tmp_path / "feedthrough2.fmu", {}, changes))
    assert opened.feedthrough()["y"] == {"u"} and not opened.notes  # the fourth is a parameter


@pytest.mark.parametrize("isolation", ["none", "process"])
def test_functions_that_a_library_lacks_fail_only_when_they_are_called(
    isolation: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    fmu = feedthrough2(tmp_path / "bare.fmu", BARE=1)
    of = {"a": {"isolation": isolation}}
    (tmp_path / "case.toml").write_text(system_text({"a": ("./bare.fmu", "1 ms", FREE2)}, stop="10 ms", of=of))
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "out") == 0
    said = " ".join(capfd.readouterr().out.split())
    assert rules.FUNCTIONS.found in said and "fmi2CancelStep" in said
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "strict", "--strict") == 1
    assert "fmi2CancelStep" in capfd.readouterr().err
    instance = load(Fmu.open(fmu), "a")
    instance.begin(1.0)
    instance.exit_initialization()
    with pytest.raises(FmuError, match=r"cannot save its state .its library has no function fmi2GetFMUstate"):
        instance.save()
    instance.close()


def test_run_counts_what_is_wrong_and_strict_refuses_it(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    changes = {'guid="feedthrough2"': "", U: U.replace("start", 'unit="blorp" start')}
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "their.fmu", {}, changes)
    (tmp_path / "case.toml").write_text(
        system_text({"a": ("their.fmu", "1 ms", FREE2), "b": ("their.fmu", "1 ms", FREE2)}, stop="10 ms")
    )
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "out") == 0
    said = " ".join(capfd.readouterr().out.split())
    assert said.count("their.fmu breaks the standard in 2 points that a run can do without: `rovbrush check") == 1
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--out", tmp_path / "strict", "--strict") == 1
    assert "blorp" in capfd.readouterr().err and not (tmp_path / "strict").exists()
    assert rovbrush(monkeypatch, "check", fmu) == 0
    assert "blorp" in capfd.readouterr().out
    assert rovbrush(monkeypatch, "check", fmu, "--strict") == 1


def test_every_rule_is_tried() -> None:
    tried = [*(row[0] for row in (*DESCRIPTIONS, *DESCRIPTIONS3)), *(row[0] for row in ARCHIVES.values())]
    elsewhere = {
        rules.TWICE,
        rules.ENCODING,
        rules.FUNCTIONS,
        rules.ALIAS,
        rules.TERMINAL,
        rules.TERMINALS_FILE,
    }  # each has its own test
    assert set(rules.RULES) - set(tried) == elsewhere


@pytest.mark.parametrize("name", ["feedthrough2.FMU", "unpacked", "sub/unpacked"])
def test_the_suffix_may_be_upper_case_and_the_archive_unpacked(name: str, native: Path, tmp_path: Path) -> None:
    target = tmp_path / name
    if name.endswith("FMU"):
        shutil.copy(native / "feedthrough2.fmu", target)
    else:
        fmpy.extract(str(native / "feedthrough2.fmu"), str(target))
    system = read_system(tmp_path, tmp_path / "fmus", {"a": (name, "1 ms", FREE2)}, stop="10 ms")
    run = simulate(make_plan(system))
    assert last(run, "a.x") == pytest.approx(0.015, rel=1e-12)
    fmu = system.components["a"].fmu
    assert not fmu.notes and Fmu.open(fmu.archive).folder == fmu.folder
    assert all(file.is_relative_to(target) or file.is_relative_to(fmu.folder) for file in [fmu.library])


def test_an_unpacked_folder_that_holds_a_link_is_refused(native: Path, tmp_path: Path) -> None:
    fmpy.extract(str(native / "feedthrough2.fmu"), str(tmp_path / "unpacked"))
    (tmp_path / "unpacked" / "link").symlink_to("/etc/passwd")
    with pytest.raises(FmuError, match="'link' is a link or a device; put the file there"):
        Fmu.open(tmp_path / "unpacked")


def test_of_several_libraries_the_one_to_take_must_be_named(native: Path, tmp_path: Path) -> None:
    changes: dict[str, bytes | None] = {LIBRARY2: None, f"{FOLDER2}/a{SUFFIX}": b"x"}
    changes[f"{FOLDER2}/b{SUFFIX}"] = b"x"
    fmu = edited(native / "feedthrough2.fmu", tmp_path / "their.fmu", changes)
    with pytest.raises(FmuError, match=rf"of a{SUFFIX}, b{SUFFIX} in binaries/{fmpy.platform} call one feedthrough2"):
        Fmu.open(fmu)
