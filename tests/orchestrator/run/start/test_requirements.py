"""What a system requires of its start: numbers or other values as bounds, an error or a warning otherwise."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import rovbrush, system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp

PARTS = {"g": ("gain", "1 ms", {"k": 2.0, "offset": 1.0}), "w": ("wave", "1 ms", {"c0": 5.0})}  # g.y = 11 at time 0


def written(folder: Path, *lines: str) -> Path:
    path = folder / "case.toml"
    text = system_text(PARTS, ["w.y -> g.u"], stop="3 ms")
    path.write_text("\n".join([text, "[[require]]", 'message = "too far"', *lines, ""]), encoding="utf-8")
    return path


def run(folder: Path, fmus: Path, *lines: str) -> Run:
    return simulate(make_plan(load_system(str(written(folder, *lines)), fmus)))


@pytest.mark.parametrize("bound", ["10", '"g.k"', '"w.y"'])
def test_a_bound_is_a_number_a_parameter_or_an_output(tmp_path: Path, fmus: Path, bound: str) -> None:
    with pytest.raises(InputError, match=r"too far: g\.y = 11 at time 0, allowed are -inf to"):
        run(tmp_path, fmus, 'value = "g.y"', f"maximum = {bound}")
    assert run(tmp_path, fmus, 'value = "g.y"', f"minimum = {bound}").notes == []


def test_the_message_says_whose_value_the_bound_is(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match=r"allowed are 12 to 5 \(w\.y\)"):
        run(tmp_path, fmus, 'value = "g.y"', 'maximum = "w.y"', "minimum = 12")


def test_a_parameter_can_be_what_is_bounded(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match=r"too far: g\.k = 2 at time 0, allowed are 3 to inf"):
        run(tmp_path, fmus, 'value = "g.k"', "minimum = 3")


def test_a_warning_lets_the_run_go_on_and_stays_with_its_results(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = ('value = "g.y"', "maximum = 1.0", 'otherwise = "warning"')
    (note,) = summarize(run(tmp_path, fmus, *lines))["notes"]
    assert note.startswith("warning: too far: g.y = 11")
    written(tmp_path, *lines)
    case = tmp_path / "case.toml"
    assert rovbrush(monkeypatch, "run", case, "--fmus", fmus, "--out", tmp_path / "out", "--force") == 0
    assert note in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (('value = "g.yy"',), r"require: 'g\.yy' is no output or parameter; did you mean 'g\.y'"),
        (
            ('value = "g.y"', 'maximum = "w.yy"'),
            r"maximum = 'w\.yy' must be a number, an output or a parameter.*'w\.y'",
        ),
        (('value = "g.y"', 'maximum = "g.offset"'), r"require g\.y: maximum: .*"),
        (('value = "g.y"', 'otherwise = "shout"'), r"unknown otherwise 'shout'"),
        (('value = "g.y"', "minimum = true"), r"minimum must be a number, or the name of"),
    ],
)
def test_slips_are_found_when_the_file_is_read(
    tmp_path: Path, fmus: Path, lines: tuple[str, ...], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        load_system(str(written(tmp_path, *lines)), fmus)


def test_an_ssp_keeps_bounds_and_what_happens_otherwise(tmp_path: Path, fmus: Path) -> None:
    system = load_system(str(written(tmp_path, 'value = "g.y"', 'maximum = "w.y"', 'otherwise = "warning"')), fmus)
    write_ssp(system, tmp_path / "case.ssp")
    assert load_system(str(tmp_path / "case.ssp")).requirements == system.requirements
