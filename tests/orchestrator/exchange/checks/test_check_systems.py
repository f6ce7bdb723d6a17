"""`check` of a system's file: whether it can be read, where it breaks its standard, and each of its FMUs once."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from helpers import rovbrush
from osp_files import simulator, structure, wire, write_osp
from rovbrush.orchestrator.exchange.checks import systems
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.exchange.checks.rows import Report
from rovbrush.orchestrator.exchange.checks.systems import check_file
from ssp_files import CHAIN, GAINS, component, connection, connectors, document, system, write_ssp_file


@pytest.fixture(autouse=True)
def every_fmu_is_checked_once(monkeypatch: pytest.MonkeyPatch, known: dict[bytes, Report]) -> None:
    """What a check says of an FMU does not depend on the file it stands in: the same bytes are not tried again."""

    def remembered(path: Path) -> Report:
        content = path.read_bytes()
        if content not in known:
            known[content] = check_fmu(path)
        return known[content]

    monkeypatch.setattr(systems, "check_fmu", remembered)


@pytest.fixture(scope="module")
def known() -> dict[bytes, Report]:
    return {}


ODD = system(component("a", "gain", connectors(q="input")) + component("b", "gain"), connection("a.y", "b.u"))


def test_a_good_one_passes_and_its_fmus_are_checked_once(tmp_path: Path, fmus: Path) -> None:
    ssp = write_ssp_file(tmp_path / "case.ssp", fmus, document(CHAIN), ("gain",))
    osp = write_osp(tmp_path / "case", fmus, structure([simulator("a"), simulator("b")], [wire("a.y", "b.u")]))
    for path, kind in ((ssp, "SSP, stranger"), (osp, "OSP, case"), (osp.parent, "OSP, case")):
        whole, fmu = check_file(path)
        assert (whole.kind, whole.clean) == (kind, True)
        assert whole.rows[0].found == "2 components, 1 connection" and fmu.kind == "FMI 2.0, gain"


def test_what_breaks_the_standard_is_a_finding_and_strict_makes_it_an_error(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, rows = write_ssp_file(tmp_path / "case.ssp", fmus, document(ODD), ("gain",)), tmp_path / "rows.json"
    assert rovbrush(monkeypatch, "check", path, "--json", rows) == 0
    found = json.loads(rows.read_text())[0]
    assert (found["errors"], found["findings"]) == (0, 1)
    assert found["rows"][1]["rule"] == "connectors for which the FMU has no variable"
    assert rovbrush(monkeypatch, "check", path, "--strict") == 1
    assert rovbrush(monkeypatch, "run", path, "--strict", "--out", tmp_path / "out") == 1
    assert rovbrush(monkeypatch, "run", path, "--out", tmp_path / "out") == 0


def test_what_cannot_be_read_is_an_error_with_its_mend(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = document(system(GAINS, connection("a.y", "b.y")))
    (report,) = check_file(write_ssp_file(tmp_path / "case.ssp", fmus, text, ("gain",)))
    assert report.count("error") == 1 and "output and output cannot be connected" in report.rows[0].found
    outside = document(system('<ssd:Component name="a" source="../elsewhere/gain.fmu"/>'))
    path = write_ssp_file(tmp_path / "out.ssp", fmus, outside, ())
    (tmp_path / "elsewhere").mkdir()
    shutil.copy(fmus / "gain.fmu", tmp_path / "elsewhere")
    assert rovbrush(monkeypatch, "check", path) == 1
    assert rovbrush(monkeypatch, "check", path, "--allow-outside", tmp_path / "elsewhere") == 0
