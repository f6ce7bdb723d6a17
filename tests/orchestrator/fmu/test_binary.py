"""A name from a description becomes a path: it stays in its folder, and only the platforms of the standard count."""

from __future__ import annotations

from pathlib import Path

import fmpy
import pytest
from first_fmi import first_fmu
from helpers import edited
from native_build import built, needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.rules.archive_rules import archive_rows, loadable_row
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.files import binary
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.tolerant.rules import IDENTIFIER

OUTSIDE = ["/etc/passwd", "../../../../../outside", "a/b", "", ".", "..", ".a", "a\\b", "a&#10;b", "a" * 201]
INSIDE = ["a b", "1a", "ä", "a.b", "a-b", "two plates, (one) clutch", "a..b"]


@pytest.mark.parametrize("identifier", OUTSIDE)
def test_a_model_identifier_that_may_lead_outside_is_refused(identifier: str, fmus: Path, tmp_path: Path) -> None:
    path = edited(
        fmus / "gain.fmu", tmp_path / "bad.fmu", {}, {'modelIdentifier="gain"': f'modelIdentifier="{identifier}"'}
    )
    with pytest.raises(
        FmuError, match=r"(?s)its modelIdentifier '.*' is no C identifier of at most 200 characters|not valid"
    ):
        Fmu.open(path)


@pytest.mark.parametrize("identifier", OUTSIDE)
def test_the_check_looks_for_no_library_outside(identifier: str, fmus: Path, tmp_path: Path) -> None:
    path = edited(
        fmus / "gain.fmu", tmp_path / "bad.fmu", {}, {'modelIdentifier="gain"': f'modelIdentifier="{identifier}"'}
    )
    subject = open_subject(path)
    verdicts = {row.rule: row.verdict for row in archive_rows(subject)}
    assert verdicts["modelIdentifier is a C name"] == "error" and loadable_row(subject).verdict == "error"


@needs_gcc
@pytest.mark.parametrize("identifier", INSIDE)
def test_one_that_is_no_c_identifier_but_a_file_name_runs(identifier: str, tmp_path: Path) -> None:
    path = edited(
        built(tmp_path) / "feedthrough2.fmu", tmp_path / "odd.fmu", {},
        {'modelIdentifier="feedthrough2"': f'modelIdentifier="{identifier}"'},
    )  # fmt: skip
    assert IDENTIFIER in [note.rule for note in Fmu.open(path).notes]
    assert load(path).run(stop="2 ms")["odd.y"].values.tolist() == [0.0] * 2
    subject = open_subject(path)
    verdicts = {row.rule: row.verdict for row in archive_rows(subject)}
    assert verdicts["modelIdentifier is a C name"] == "finding" and loadable_row(subject).verdict != "error"


@needs_gcc
def test_of_fmi_1_it_begins_the_functions_names_and_is_refused(tmp_path: Path) -> None:
    path = first_fmu(tmp_path / "first.fmu", changes={'modelIdentifier="first"': 'modelIdentifier="first-one"'})
    with pytest.raises(FmuError, match="its modelIdentifier 'first-one' is no C identifier"):
        Fmu.open(path)


@needs_gcc
def test_so_is_one_of_a_build_description(tmp_path: Path) -> None:
    native = built(tmp_path)
    build = (
        '<fmiBuildDescription fmiVersion="3.0"><BuildConfiguration modelIdentifier="../up"><SourceFileSet>'
        '<SourceFile name="../../../../etc/passwd"/></SourceFileSet></BuildConfiguration></fmiBuildDescription>'
    )
    path = edited(native / "feedthrough3.fmu", tmp_path / "bad.fmu", {"sources/buildDescription.xml": build.encode()})
    with pytest.raises(FmuError, match=r"its modelIdentifier '.*' is no C identifier of at most 200|not valid"):
        Fmu.open(path)
    missing = next(row for row in archive_rows(open_subject(path)) if row.rule == "sources are complete")
    assert missing.verdict == "finding" and "passwd" in missing.found


@pytest.mark.parametrize("machine", ["aarch64-linux", "aarch64-windows"])
def test_fmi_2_has_no_name_for_this_machine(
    machine: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fmpy, "platform_tuple", machine)
    path = edited(fmus / "gain.fmu", tmp_path / "other.fmu", {"documentation/a": b"another content"})
    with pytest.raises(FmuError, match=rf"FMI 2\.0 has no name for binaries of {machine}.*export it as FMI 3\.0"):
        Fmu.open(path)
    assert binary.platform_folder(3) == machine
