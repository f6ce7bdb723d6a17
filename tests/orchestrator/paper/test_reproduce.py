"""The report on the paper: every claim answered, by numbers, and a page that needs nothing but itself."""

from __future__ import annotations

import importlib.util
import json
import math
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import ROOT, Measured
from jinja2 import UndefinedError
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.paper import energy_flow, reproduce, verification, water
from rovbrush.orchestrator.paper.claims import CLAIMS, VERDICTS, Check, Finding, sensitivity, transients
from rovbrush.orchestrator.paper.claims.claim import at_least, at_most, near, within
from rovbrush.orchestrator.paper.lab import Case, Lab
from rovbrush.orchestrator.paper.page.motion import Motion
from rovbrush.orchestrator.paper.page.rendering import templates
from rovbrush.orchestrator.paper.theory import elastica, references
from rovbrush.orchestrator.paper.theory.beam import centrifugal_frequencies, shape, slope, slope_integrals

NOT_REPRODUCIBLE = {2, 4, 7, 8, 9, 10, 15, 16, 19, 21, 25}
BY_CALIBRATION = {11, 12, 13, 14, 17, 18}
LAMBDA = np.array([1.8751040687, 4.6940911330, 7.8547574382, 10.9955407349, 14.1371683910, 17.2787595321])


@pytest.fixture(scope="module")
def out(fmus: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("report")
    with pytest.MonkeyPatch.context() as patch:
        # a dozen runs, of which test_water.py tells
        patch.setattr(water, "errors", lambda _lab, brush: [(f"errors of {brush.name}", "0")])
        reproduce.reproduce(folder, fmus)
    return folder


@pytest.fixture(scope="module")
def rows(out: Path) -> dict[int, dict[str, Any]]:
    return {row["number"]: row for row in json.loads((out / "claims.json").read_text(encoding="utf-8"))}


class Page(HTMLParser):
    """Tags of the page with their attributes, and its visible text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.hidden = 0
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        self.hidden += tag in ("script", "style", "math")
        if tag == "math":
            self.words.append(dict(attrs)["alttext"] or "")

    def handle_endtag(self, tag: str) -> None:
        self.hidden -= tag in ("script", "style", "math")

    def handle_data(self, data: str) -> None:
        if not self.hidden:
            self.words.append(data)


@pytest.fixture(scope="module")
def parsed(out: Path) -> Page:
    return Page((out / "report.html").read_text(encoding="utf-8"))


def flat(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def test_every_claim_has_a_row_with_finite_numbers_and_a_command(rows: dict[int, dict[str, Any]]) -> None:
    assert sorted(rows) == list(range(1, 26))
    for number, row in rows.items():
        assert row["verdict"] in VERDICTS and row["claim"] and row["checks"]
        assert all(math.isfinite(x) for x in flat(row["paper"]) + flat(row["computed"])), number
        assert len(flat(row["paper"])) == len(flat(row["computed"])) == len(row["checks"])
        assert all(command.startswith("rovbrush run ") for command in row["command"].split("; ")), number
        assert ("arithmetic" in row) == (row["verdict"] == "not reproducible")
        if "arithmetic" in row:
            assert re.search(r"\d", row["arithmetic"]) and "\n" not in row["arithmetic"]


def test_verdicts_agree_with_the_arithmetic_of_the_paper(rows: dict[int, dict[str, Any]]) -> None:
    assert {n for n, row in rows.items() if row["verdict"] == "not reproducible"} == NOT_REPRODUCIBLE
    assert {n for n, row in rows.items() if row["verdict"] == "reproduced by calibration"} == BY_CALIBRATION


def test_numbers_of_the_claims_are_those_that_arithmetic_gives(
    rows: dict[int, dict[str, Any]], measured: Measured
) -> None:
    assert rows[2]["computed"] == pytest.approx([162.7, 1019.7, 2855.2], abs=0.05)  # formula below Eq. 4 with Table 2
    assert rows[6]["computed"] == pytest.approx([125.0, 125.0], abs=0.1)
    assert rows[19]["computed"] == pytest.approx(739.0, rel=0.01)
    assert rows[21]["computed"] == pytest.approx(0.007, abs=5e-4)
    at_tips, summed = rows[9]["computed"]
    assert at_tips < 0.05 and summed == pytest.approx(10.9, abs=0.1)  # the paper's F_y is Eq. 11
    assert rows[25]["computed"][0] < 1e-4 and rows[25]["computed"][2] > 2.0 * math.sqrt(2.0)  # neither end of its range
    for number in (4, 7, 8, 9, 10, 15, 17, 18, 22, 25):
        for check in rows[number]["checks"]:
            measured(f"claim {number}: {check['quantity']} [{check['unit']}]", check["computed"], f"{check['paper']:g}")


def test_every_bound_has_its_reason(rows: dict[int, dict[str, Any]], parsed: Page) -> None:
    words = "".join(parsed.words)
    for number, row in rows.items():
        for check in row["checks"]:
            assert len(check["reason"]) > 4 and check["reason"] in words, (number, check["quantity"])


def test_stiction_is_told_from_doubled_friction(rows: dict[int, dict[str, Any]]) -> None:
    sliding, *excess = rows[22]["checks"]
    assert sliding["computed"] < sliding["paper"] == 0.02  # v_eps
    assert all(0.8 < check["computed"] < 5.0 for check in excess)
    assert "never sticks" in rows[22]["note"] and "no stiction" in rows[22]["note"]


def test_transients_are_judged_by_overshoot_and_settling_time(rows: dict[int, dict[str, Any]], fmus: Path) -> None:
    case = Lab(fmus).case("nominal")
    assert transients.time_constants(case)["bristle"] == pytest.approx(1.0 / (0.02 * 162.7), rel=1e-3)
    for number, name in ((17, "F_z"), (18, "T_brush")):
        seen, (first, settled, _) = transients.transient(case, name), rows[number]["checks"]
        assert settled["computed"] == seen.settled and settled["paper"] == pytest.approx(3.0 / (0.02 * 162.7), rel=1e-3)
        assert seen.overshoot > 100.0 * seen.spread  # the end of the run is steady, its begin is not
        assert first["computed"] == (seen.overshoot if number == 17 else case.signals["brush.T_brush"].values[1:].max())


def test_method_is_stable_up_to_the_known_limit_and_damping_moves_it() -> None:
    assert sensitivity.stable(0.0) == pytest.approx(2.0 * math.sqrt(2.0), rel=1e-9)  # imaginary axis
    assert sensitivity.stable(0.0) < sensitivity.stable(0.01) < sensitivity.stable(0.02) < 2.9


def test_the_page_tells_both_readings_of_table_3_and_what_the_paper_s_brush_amounts_to(parsed: Page) -> None:
    words = " ".join("".join(parsed.words).split())
    assert "rolling brush" in words and "cup brush" in words
    assert words.count("not a buildable brush") >= 1 and "0.45 m2" in words and "41 kg" in words
    assert "35 A and 418 W off the hull" in words


def test_energy_closes_at_every_level(rows: dict[int, dict[str, Any]], measured: Measured) -> None:
    assert len(rows[24]["checks"]) == 7
    for check in rows[24]["checks"]:
        measured(f"energy, {check['quantity']}", check["computed"], f"{check['paper']:g}")
        assert check["computed"] <= check["paper"]


def test_the_page_loads_nothing_from_elsewhere(out: Path, parsed: Page) -> None:
    for tag, attributes in parsed.tags:
        for name in ("src", "href", "data", "action", "srcset"):
            value = attributes.get(name) or ""
            assert value.startswith(("#", "data:")) or not value, (tag, name, value[:80])
        assert tag not in ("link", "iframe", "object", "embed", "base")
    text = (out / "report.html").read_text(encoding="utf-8")
    styles = re.findall(r"<style>(.*?)</style>", text, re.S)
    assert not any("http" in style or "@import" in style for style in styles)
    assert len(text) < 12e6


def test_the_page_has_its_figures_and_all_claims(parsed: Page, rows: dict[int, dict[str, Any]]) -> None:
    images = [attributes for tag, attributes in parsed.tags if tag == "img"]
    assert len(images) == 4 and all((a["src"] or "").startswith("data:image/png;base64,") and a["alt"] for a in images)
    assert sum("plotly-graph-div" in (a.get("class") or "") for _, a in parsed.tags) == 2
    words = "".join(parsed.words)
    for row in rows.values():
        assert row["claim"] in words
        assert row.get("arithmetic", "") in words
    ours = ("filament_brush", "cup_brush", "dc_motor", "rov_vehicle", "rov_controller", "mission", "constant_speed")
    for name in ours:
        assert f"{name}.fmu" in words, name
    assert "`" not in words, "Markdown that nobody renders"
    assert next(attributes["id"] for tag, attributes in parsed.tags if tag == "section") == "motion"
    for anchor in ("claims", "table3", "figures", "readings", "verification", "energy", "motion", "provenance"):
        assert any(a.get("id") == anchor for _, a in parsed.tags), anchor


def test_every_check_of_the_suite_that_the_page_names_exists(parsed: Page) -> None:
    for check in verification.SUITE:
        assert f"def {check.test}(" in (ROOT / check.definition).read_text(encoding="utf-8"), check.test
        assert check.command in "".join(parsed.words)


def test_one_claim_can_be_asked_alone_and_gives_the_same_numbers(
    fmus: Path, tmp_path: Path, rows: dict[int, dict[str, Any]]
) -> None:
    (row,) = reproduce.reproduce(tmp_path / "none", fmus, (16,)).rows
    assert json.loads(json.dumps(row)) == rows[16]
    assert not (tmp_path / "none").exists()


def test_an_unknown_claim_or_a_missing_library_is_refused_before_any_run(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reproduce, "Lab", lambda *_: pytest.fail("something was run"))
    with pytest.raises(InputError, match="the claims are 1 to 25"):
        reproduce.reproduce(tmp_path, fmus, (26,))
    find = importlib.util.find_spec
    monkeypatch.setattr(reproduce, "find_spec", lambda name: None if name == "plotly" else find(name))
    with pytest.raises(InputError, match=r"pip install 'rovbrush\[report\]'"):
        reproduce.reproduce(tmp_path, fmus)
    (tmp_path / "taken").write_text("mine")
    monkeypatch.undo()
    with pytest.raises(InputError, match="cannot write to the output folder"):
        reproduce.reproduce(tmp_path / "taken", fmus)


def test_the_command_ends_with_2_for_an_unknown_claim_and_with_0_for_a_known_one(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for number, code in ((0, 2), (14, 0)):
        monkeypatch.setattr(sys, "argv", ["rovbrush", "reproduce", "--claim", str(number), "--fmus", str(fmus)])
        monkeypatch.chdir(tmp_path)
        with pytest.raises(SystemExit) as ending:
            main()
        assert ending.value.code == code
    seen = capsys.readouterr()
    assert "--claim 0: the claims are 1 to 25" in seen.err and "mean omega_b" in seen.out
    assert "not a buildable brush" in seen.out and "why: fitted exactly" in seen.out
    assert not list(tmp_path.iterdir())


def test_a_verdict_follows_from_the_checks_alone() -> None:
    good, bad = near("x", 1.0, 1.005, "1", 0.01, "why"), near("x", 1.0, 1.02, "1", 0.01, "why")
    fitted = Check("F_z", -221.7, -221.7, "N", "within 1 %", True, "why", "F_z_mean")
    assert Finding((good,)).verdict == "reproduced"
    assert Finding((good, fitted)).verdict == "reproduced by calibration"
    assert Finding((good, fitted, bad)).verdict == "not reproducible"
    assert at_most("x", 1.0, 1.0, "1").holds and not at_most("x", 1.0, 1.1, "1").holds
    assert at_least("x", 1.0, 1.0, "1").holds and not at_least("x", 1.0, 0.9, "1").holds
    assert within("x", 2.0, 2.0, "1", 0.0, "why").holds and not within("x", 2.0, 2.1, "1", 0.05, "why").holds
    assert not any(rule("x", 1.0, math.nan, "1", 0.1, "why").holds for rule in (near, within))
    assert len({claim.text for claim in CLAIMS.values()}) == 25


def test_text_is_escaped() -> None:
    source = (
        '{% from "tables.html" import table, picture %}{{ table(heading, rows, code=1) }}{{ picture("data:", words) }}'
    )
    text = templates().from_string(source).render(heading=["<h>", "&"], rows=[["a < b", "<script>"]], words='"><b>')
    page = Page(text)
    assert "".join(page.words).split() == ["<h>&", "a", "<", "b<script>"]
    assert {tag for tag, _ in page.tags} == {"div", "table", "thead", "tbody", "tr", "th", "td", "span", "code", "img"}
    assert dict(page.tags)["img"] == {"alt": '"><b>', "src": "data:"}


def test_a_value_that_a_template_lacks_is_an_error() -> None:
    with pytest.raises(UndefinedError, match="'rows' is undefined"):
        templates().from_string("{{ rows | length }}").render()


def test_exact_elastica_agrees_with_the_published_table(measured: Measured) -> None:
    measured("elastica: closed form against the table", elastica.reference_error(), "1e-5")
    assert elastica.reference_error() < 1e-5  # five decimals are printed


def test_the_beams_leave_the_elastica_where_the_report_says(measured: Measured) -> None:
    bent = elastica.bending(LAMBDA)
    errors = {"deflection": bent.deflection_error, "tip, linear": bent.linear_tip_error,
              "tip, foreshortened": bent.foreshortened_tip_error}  # fmt: skip
    for name, error in errors.items():
        places = [elastica.leaves_at(error, bent.model_w, limit) for limit in elastica.LIMITS]
        for limit, place in zip(elastica.LIMITS, places, strict=True):
            measured(f"elastica: |y(L)|/L where the error of the {name} is {100 * limit:g} %", place, "reported")
        assert places == sorted(places) and places[0] > 0.0
    # A shortening of 3/5 w^2/L turns the linear beam's tip error into 3/5 w/L.
    assert elastica.leaves_at(bent.linear_tip_error, bent.model_w, 0.05) == pytest.approx(0.05 / 0.6, rel=0.01)
    assert np.all(bent.foreshortened_tip_error < 0.3 * bent.linear_tip_error)


def test_reference_tables_of_the_report_are_those_of_the_tests() -> None:
    for path in references.FOLDER.glob("*.csv"):
        assert path.read_bytes() == (ROOT / "tests" / "reference" / path.name).read_bytes()


def test_rotating_cantilever_of_the_report_agrees_with_the_published_table(measured: Measured) -> None:
    for speed, *published in references.rotating_cantilever():
        seen = centrifugal_frequencies(LAMBDA, LAMBDA**2, speed, 0.0, in_plane=False)[:3]
        measured(
            "report: rotating cantilever, largest relative difference", np.max(np.abs(seen / published - 1.0)), "1e-3"
        )
        assert seen == pytest.approx(published, rel=1e-3)  # six modes of a series; the table's digits otherwise


def test_slopes_are_the_derivatives_of_the_shapes() -> None:
    xi, step = np.linspace(0.1, 0.9, 9), 1e-6
    for lam in LAMBDA:
        numeric = (shape(lam, xi + step) - shape(lam, xi - step)) / (2 * step)
        assert slope(lam, xi) == pytest.approx(numeric, rel=1e-7, abs=1e-6)
    assert slope_integrals(LAMBDA)[0, 0] == pytest.approx(4.6478, abs=1e-4)  # L int Y_1'^2 dx, tabulated for Y_1(L) = 2


@pytest.fixture(scope="module")
def case(fmus: Path) -> Case:
    return Lab(fmus).case("test_stand", stop="0.2 s")


def test_energy_flows_are_positive_and_the_nodes_pass_on_what_they_get(case: Case) -> None:
    links = energy_flow.flows(case)
    assert all(link.energy > 0 for link in links)
    supplied = sum(link.energy for link in links if link.source == "battery")
    assert supplied == pytest.approx(case.last("motor.W_electrical"))
    for node in ("motor", "brush"):
        assert abs(energy_flow.imbalance(links, node)) < 1e-3 * supplied


def test_a_case_knows_the_command_that_repeats_it(fmus: Path) -> None:
    lab = Lab(fmus)
    case = lab.case("test_stand", {"brush.zeta": [0.01] * 6, "brush.N_m": 2}, "50 ms")
    expected = (
        "rovbrush run test_stand --set 'brush.zeta=[0.01,0.01,0.01,0.01,0.01,0.01]' --set brush.N_m=2 --stop '50 ms'"
    )
    assert case.command == expected and lab.used == [expected]
    assert lab.case("test_stand", {"brush.zeta": [0.01] * 6, "brush.N_m": 2}, "50 ms") is case
    assert case.parameters("brush.zeta").tolist() == [0.01] * 6 and case.parameter("brush.N_m") == 2


def test_motion_is_drawn_where_the_vehicle_is(fmus: Path) -> None:
    case = Lab(fmus).case("hull_pass", stop="2 s")
    motion = Motion(case, 5)
    low = motion.tool(0, np.array([[0.0, 0.0, motion.radius]]))[0, 2]  # the brush's lowest point, upwards
    hull = motion.hull()[:, 2]
    assert np.ptp(hull) < 1e-9
    assert low - hull[0] == pytest.approx(-case.signals["vehicle.delta"].values[0], abs=1e-9)
    assert motion.box(0).mean(axis=0) == pytest.approx(motion.position[0] * [1.0, -1.0, -1.0])
    assert np.linalg.det(motion.attitude) == pytest.approx(np.ones(5))
    for name, (row, column) in {"psi": (1, 0), "theta": (2, 0)}.items():  # yaw turns the nose to the east, pitch up
        angle = motion.at(f"vehicle.{name}")
        lever = np.cos(motion.at("vehicle.theta")) if name == "psi" else -1.0
        assert motion.attitude[:, row, column] == pytest.approx(lever * np.sin(angle), abs=1e-6)
