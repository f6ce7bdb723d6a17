"""The designer's page: a task run, its error bars, and where each number stands."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.paper.design import sections, study
from rovbrush.orchestrator.paper.design.origins import numbers
from rovbrush.orchestrator.paper.design.sections import answers, sensors, verdict
from rovbrush.orchestrator.paper.design.spread import LIMIT, Cause, Spread
from rovbrush.orchestrator.paper.design.task import SWEEP, Task, force_error, task
from rovbrush.orchestrator.paper.lab import Lab
from rovbrush.orchestrator.paper.margins.table import BRUSHES
from rovbrush.orchestrator.paper.page.design import SECTIONS, spread_figure
from rovbrush.orchestrator.paper.thrust_budget import CURRENTS, thrust_budget
from rovbrush.orchestrator.studies.sweep.file import sweep_file

POINTS = 2


@pytest.fixture(scope="module")
def out(fmus: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("design")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            sections, "delay_limit", lambda _system: 0.05
        )  # a dozen runs; tests/system/test_margins.py has it
        own = {"the task's": sweep_file(SWEEP).system}
        patch.setattr(study, "thrust_budget", lambda lab: thrust_budget(lab, own))  # the others have tests of their own
        study.design(folder, fmus, POINTS)
    return folder


@pytest.fixture(scope="module")
def asked(fmus: Path) -> Task:
    return task(Lab(fmus))


def synthetic(error: list[float], contact: list[float]) -> Spread:
    return Spread(np.array(error), np.array(contact), {}, [Cause("a.b", 0.0, 1.0, 0.5)], [], "rovbrush sweep x")


@pytest.mark.evidence
def test_page_and_numbers_answer_the_task_with_error_bars(out: Path, asked: Task) -> None:
    found = json.loads((out / "design.json").read_text(encoding="utf-8"))
    assert found["task"]["force_N"] == asked.force == 20.0 and found["task"]["current_m_s"] == asked.current == 0.3
    assert found["points"]["of"] == POINTS
    rows = {row[0]: row for row in found["answers"]}
    _, unit, seen, low, high = rows["force on the hull, mean"]
    assert unit == "N" and float(seen) == pytest.approx(-asked.case.summary["F_z_mean"], abs=0.01)
    assert float(low) <= float(high)
    assert all(row[3] and row[4] for row in found["answers"]), "an answer without its error bar"
    assert [row[0] for row in found["short"]] == [
        "Which brush", "Which strategy and gains", "Which sensors", "How much thrust", "How sure"
    ]  # fmt: skip


@pytest.mark.evidence
def test_margins_stand_for_the_brush_and_for_one_twice_as_stiff(out: Path) -> None:
    found = json.loads((out / "design.json").read_text(encoding="utf-8"))["margins"]
    assert [row[0] for row in found] == list(BRUSHES)
    stiffness = [float(row[1]) for row in found]
    assert 1.5 < stiffness[1] / stiffness[0] < 2.5
    assert [float(row[3]) for row in found] == [40.0, 20.0] and all(float(row[2]) > 0.0 for row in found)


@pytest.mark.evidence
def test_thrust_that_is_left_is_told_of_the_task_s_own_tool(out: Path) -> None:
    found = json.loads((out / "design.json").read_text(encoding="utf-8"))
    (row,) = found["budget"]["rows"]
    largest = [float(cell) for cell in row[2 : 2 + len(CURRENTS)]]
    assert largest == sorted(largest, reverse=True) and float(row[-2]) == pytest.approx(largest[-1] / 20.0, abs=0.01)
    assert f"could hold {largest[-1]:.0f} N" in dict(found["short"])["How much thrust"]


@pytest.mark.evidence
def test_page_loads_nothing_from_elsewhere_and_has_every_section(out: Path) -> None:
    text = (out / "design.html").read_text(encoding="utf-8")
    links = re.findall(r'(?:src|href)="([^"]*)"', text)
    assert links and all(link.startswith(("#", "data:image/png;base64,")) for link in links)
    for name, heading in SECTIONS:
        assert f'id="{name}"' in text and heading in text
    assert text.count("<img") == 2 and "`" not in re.sub(r"<style>.*?</style>", "", text, flags=re.S)


@pytest.mark.evidence
def test_every_parameter_says_where_it_stands(asked: Task) -> None:
    found = {(c, n.name): n for c in ("brush", "motor", "controller", "mission") for n in numbers(asked, c)}
    assert all(number.origin and number.meaning and number.unit for number in found.values())
    assert found["mission", "F_n"].origin == f"sweeps/{SWEEP}.toml" and found["mission", "F_n"].value == "20"
    assert found["controller", "mode"].origin == asked.case.run.plan.system.path.name
    chosen = asked.case.run.plan.system.parameter_set
    assert chosen is not None and found["brush", "k_c"].origin == f"{chosen.name}.toml"
    assert found["brush", "rho"].origin == "Table 2" and "source" not in found["brush", "rho"].meaning


@pytest.mark.evidence
def test_points_hold_that_keep_contact_and_miss_the_force_by_a_tenth_at_most() -> None:
    found = synthetic([0.02, LIMIT, 0.11, 0.02, np.nan], [1.0, 1.0, 1.0, 0.999, np.nan])
    assert found.held.tolist() == [True, True, False, False, False]
    assert verdict(found).startswith(
        "2 of 5 points hold: 1 lose contact while under way, 1 have a force error above 10 %"
    )
    assert found.bar(found.error)[1] == pytest.approx(0.06)  # a point that failed has no part in the bar
    assert spread_figure(found).axes[0].lines


@pytest.mark.evidence
def test_force_error_is_that_of_the_samples() -> None:
    force = 20.0 + np.array([1.0, -2.0, 0.5, 3.0])
    rms = np.sqrt(np.mean(force**2))
    wanted = np.sqrt(np.mean((force - 20.0) ** 2)) / 20.0
    assert force_error(-np.mean(force), rms, 20.0) == pytest.approx(wanted, rel=1e-12)  # F_z of a brush is negative


@pytest.mark.evidence
def test_ranges_are_centred_on_what_the_task_has(asked: Task) -> None:
    exact = {"brush.L", "brush.d", "brush.R_brush", "vehicle.m", "vehicle.m_tool", "vehicle.r_tool[3]"}  # 1 %
    vary = dict(sweep_file(SWEEP).vary)
    assert vary.pop("sensors.seed"), "each point has noise of its own"
    for name, text in vary.items():
        low, high = (float(end) for end in str(text).split(":"))
        value = asked.case.parameter(name)
        wide = 1.0 if name == "vehicle.net_buoyancy" else abs(value) * (0.01 if name in exact else 0.2)
        assert 0.5 * (low + high) == pytest.approx(value, abs=0.01 * wide), name
        assert 0.5 * (high - low) == pytest.approx(wide, rel=0.01), name


@pytest.mark.evidence
def test_sensors_are_told_one_by_one_with_the_file_that_has_them(fmus: Path) -> None:
    case = Lab(fmus).case("station_keeping", stop="0.1 s")
    rows = {row[0]: row[1:] for row in sensors(Task(sweep_file(SWEEP), case))}
    assert rows["depth"][:2] == (
        f"{case.parameter('sensors.rate_depth'):.5g} 1/s",
        f"{case.parameter('sensors.delay_depth'):.5g} s",
    )
    assert len(rows) == 8 and all(row[-1] == "station_keeping.toml" for row in rows.values())


@pytest.mark.evidence
def test_without_points_there_are_no_error_bars_and_without_sensors_no_rows_of_them(asked: Task, fmus: Path) -> None:
    assert all(row[3:] == ("", "") for row in answers(asked, None))
    without = Task(sweep_file(SWEEP), Lab(fmus).case("nominal", stop="0.1 s"))
    assert asked.component("rov_sensors") and not without.component("rov_sensors") and sensors(without) == []


@pytest.mark.evidence
def test_the_command_writes_the_page_or_says_what_is_missing(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(study, "find_spec", lambda _name: None)
    with pytest.raises(InputError, match=r"pip install 'rovbrush\[report\]'"):
        study.design(tmp_path, fmus, 0)
    monkeypatch.undo()
    monkeypatch.setattr(sections, "margins", lambda *_: [])
    monkeypatch.setattr(study, "thrust_budget", lambda _lab: [])
    monkeypatch.setattr(
        sys, "argv", ["rovbrush", "design", "--points", "0", "--out", str(tmp_path), "--fmus", str(fmus)]
    )
    with pytest.raises(SystemExit) as ending:
        main()
    assert ending.value.code == 0 and "design.html" in capsys.readouterr().out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["design.html", "design.json"]
    assert "No points were asked for" in (tmp_path / "design.html").read_text(encoding="utf-8")
